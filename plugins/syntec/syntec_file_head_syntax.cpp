/// `%@MACRO` makes a file one of the macro language, and `$2` begins the program of the second axis group: neither is
/// read, and one diagnostic says so where it begins. `$1` begins the program of the first group, which is read.
#include <isogloss/flow.hpp>

#include "scan_util.hpp"
#include "syntec_diagnostics.hpp"

namespace syntec {
namespace {

struct SyntecFileHead {
  static constexpr auto spec =
      ig::syntax("SyntecFileHeadSyntax", "Declines files in MACRO format and the programs of further axis groups.")
          .before("TapeBoundarySyntax", "IsoCommentSyntax", "WordSyntax", "FlagSyntax")
          .scans("%$");

  ig::TextField text_{"TapeBoundary.Text", ig::write};
  ig::Signal declined_{"Source.~Declined", ig::write | ig::wake};
  ig::Flow flow_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t before = position;  // backwards: a long line may hold many of these marks
    while (before > 0 && iso::is_blank(text[before - 1])) --before;
    if (before > 0) return position;
    return text[position] == '%' ? macro_mark(b, text, position) : axis_group(b, text, position);
  }

  /// A program that was called is left where it is declined; any other ends there.
  ig::Status build(ig::Block& b) const {
    if (flow_.frame(b).depth > 0)
      flow_.leave(b);
    else
      b.end_program();
    return ig::Status::unchanged;
  }

 private:
  static constexpr std::string_view mark = "@MACRO";

  std::size_t macro_mark(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t name = iso::skip_blanks(text, position + 1);
    const std::size_t end = std::min(name + mark.size(), text.size());
    if (!iso::equals_ignoring_case(iso::piece(text, name, end), mark) || iso::is_letter(iso::at(text, end)))
      return position;
    b.set_text(text_, iso::piece(text, position, end));
    return decline(b, text, position, end, diag("SYN-0001"), {});
  }

  std::size_t axis_group(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = iso::skip_digits(text, position + 1);
    const std::string_view group = iso::piece(text, position + 1, end);
    if (group.empty()) return position;
    return group == "1" ? end : decline(b, text, position, end, diag("SYN-0004"), group);
  }

  /// Nothing behind it is program, on the same line neither.
  std::size_t decline(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, std::uint32_t what,
                      std::string_view name) const {
    b.report(what, ig::Where::columns(begin, end), name);
    b.raise(declined_);
    b.flow(IG_FLOW_END_FILE);
    return iso::block_end(text, end);
  }
};

const ig::Register<SyntecFileHead> registered;

}  // namespace
}  // namespace syntec
