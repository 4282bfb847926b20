// % marks the start and the end of the program on the tape. The text between the first % and the end of its line is
// leader and is skipped; text after the second % is not program, but programs there can be called. A % directly after
// the program number is the first one: some files have the number above it. Ctrl-Z ends a file like the second %. A
// file without marks, or with the last mark only, is a program all the same.
#include <isogloss/cnc/scan.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct TapeBoundarySyntax {
  static constexpr auto spec =
      ig::syntax("TapeBoundarySyntax", "Reads % at the start and at the end of the program.").scans("%\x1A");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "ISO-0112", "the text beside the tape mark % is ignored: '{0}'"),
  };

  ig::Flow flow_;
  ig::TextField text_{"TapeBoundary.Text", ig::write};
  ig::Signal started{"TapeBoundary.~Started", ig::read | ig::write, ig::Life::frame};
  ig::Signal program{"Source.~Program", ig::read, ig::Life::frame};
  ig::Signal number_before{"Source.~NumberBefore", ig::read | ig::write | ig::wake_while, ig::Life::frame};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = block_end(text, position);
    const std::size_t mark_end = skip_while(text, position, [](char c) { return c == '%'; });
    if (flow_.is_indexing() && text[position] == '%') return program_follows(text, mark_end) ? mark_end : end;
    const bool has_begun = b.is_raised(program) && !b.is_raised(number_before);
    if (text[position] != '%' || b.is_raised(started) || has_begun) {
      const std::size_t behind = std::max(mark_end, position + 1);
      b.set_text(text_, text[position] == '%' ? piece(text, position, behind) : "^Z");
      skipped(b, text, behind, end);
      b.flow(IG_FLOW_END_FILE);
      return end;
    }
    b.raise(started);
    b.set_text(text_, piece(text, position, mark_end));
    if (program_follows(text, mark_end)) return mark_end;
    skipped(b, text, mark_end, end);
    return end;
  }

  /// The number takes effect in the block after its own.
  ig::Status build(ig::Block& b) {
    if (!b.is_raised(number_before) || b.is_fresh(number_before)) return ig::Status::unchanged;
    b.erase(number_before);
    return ig::Status::changed;
  }

 private:
  /// In %O0003(TITLE) on one line the program number is not part of the leader.
  static bool program_follows(std::string_view text, std::size_t position) {
    const std::size_t first = skip_blanks(text, position);
    return first == block_end(text, first) ||
           std::string_view("Oo:<(%\x1A").find(text[first]) != std::string_view::npos;
  }

  static void skipped(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
    const std::string_view rest = trim(piece(text, begin, end));
    if (!rest.empty()) b.report(ig::diag("ISO-0112"), ig::Where::columns(begin, end), rest);
  }
};

const ig::Register<TapeBoundarySyntax> tape_boundary_syntax;

}  // namespace
}  // namespace iso
