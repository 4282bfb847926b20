// %_N_NAME_MPF: in an archive the program NAME begins here and the one before it ends; ;$PATH= names its folder. Any
// other text after % is the title of the file.
#include "flow/program_path.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensFileHead {
  static constexpr auto spec = ig::syntax("SiemensFileHeadSyntax", "%_N_NAME_MPF: a program begins.")
                                   .before("SiemensFlowSyntax", "SiemensWordSyntax")
                                   .scans("%;\x1A");

  ig::TextField program_{"Source.Program", ig::write};
  ig::TextField tape_{"TapeBoundary.Text", ig::write};
  ig::Signal begun_{"Source.~Program", ig::read | ig::write, ig::Life::frame};
  ig::Signal started_{"TapeBoundary.~Started", ig::read | ig::write, ig::Life::frame};
  ig::Flow flow_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (text[position] == ';') return folder(b, text, position);
    const std::size_t end = block_end(text, position);
    if (position > 0 && ig::cnc::skip_blanks(text, 0) != position) return position;
    const std::string_view head = trim(ig::cnc::piece(text, position, end));
    const std::string_view name = name_of(head);
    if (name.empty()) return title(b, text, head, position, end);
    b.set_text(program_, name);
    if (flow_.is_indexing()) {
      flow_.label(b, upper(name), IG_LABEL_PROGRAM);
    } else if (b.is_raised(begun_)) {
      end_program(b);
    }
    b.raise(begun_);
    return end;
  }

 private:
  /// A lone % at the end, and Ctrl-Z, end the file.
  std::size_t title(ig::Block& b, std::string_view text, std::string_view head, std::size_t position,
                    std::size_t end) const {
    b.set_text(tape_, text[position] == '%' ? head : "^Z");
    if (text[position] != '%' || (head.size() == 1 && b.is_raised(started_))) b.flow(IG_FLOW_END_FILE);
    b.raise(started_);
    return end;
  }

  /// ;$PATH=/_N_CUS_DIR is a comment as well.
  std::size_t folder(ig::Block& b, std::string_view text, std::size_t position) const {
    constexpr std::string_view path = ";$PATH=";
    if (!flow_.is_indexing() || position != 0 || !equals_ignoring_case(text.substr(0, path.size()), path))
      return position;
    flow_.label(b, folder_of(trim(text.substr(path.size()))) + "/", IG_LABEL_PROGRAM);
    return position;
  }

  void end_program(ig::Block& b) const {
    if (flow_.frame(b).depth > 0 && flow_.leave(b).is_done()) return;
    b.end_program();
  }

  /// NAME of %_N_NAME_MPF or %_N_NAME_SPF; "" for any other line.
  static std::string_view name_of(std::string_view head) {
    if (!equals_ignoring_case(head.substr(0, 4), "%_N_")) return {};
    std::string_view name = head.substr(4, skip_name(head, 4) - 4);
    if (name.size() > 4)
      for (const std::string_view kind : {"_MPF", "_SPF"})
        if (equals_ignoring_case(name.substr(name.size() - 4), kind)) {
          name.remove_suffix(4);
          break;
        }
    return name;
  }
};

const ig::Register<SiemensFileHead> siemens_file_head_syntax;

}  // namespace
}  // namespace siemens
