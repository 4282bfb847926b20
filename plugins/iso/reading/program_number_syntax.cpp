// The program number O1234 or :1234, or the name <PART>, which begins a program. A file may hold several programs; the
// control does not run from one into the next, so the second number ends the run.
#include <algorithm>
#include <string>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/cnc/program_name.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct ProgramNumberSyntax {
  static constexpr auto spec = ig::syntax("ProgramNumberSyntax", "Reads the program number O, : or <NAME>.")
                                   .after("TapeBoundarySyntax", "HeadIndexSyntax")
                                   .before("MacroStatementSyntax", "WordSyntax")
                                   .scans("Oo:<");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0113",
                     "another program, {0}, begins here, and the run ends before it: use --program to run it"),
      ig::diagnostic(IG_WARNING, "ISO-0490",
                     "program {0} begins before {1} returned, so the run returns to the caller: end {1} with M99"),
  };

  ig::TextField program{"Source.Program", ig::write};
  ig::Signal begun{"Source.~Program", ig::read | ig::write, ig::Life::frame};
  ig::Signal number_before{"Source.~NumberBefore", ig::write, ig::Life::frame};
  ig::Signal parameters{"ProgrammableDataInput.~Parameters", ig::read | ig::write, ig::Life::modal};
  ig::Flow flow;
  std::string name;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    const std::size_t end = read_name(text, position);
    if (end == position) return position;
    b.set_text(program, name);
    if (flow.is_indexing()) {
      const auto number = numbered_name('O', std::string_view(name).substr(1));
      flow.label(b, number ? number->text() : std::string_view(name), IG_LABEL_PROGRAM);
      b.erase(parameters);  // an index does not see that a G11 is missing
    } else if (b.is_raised(begun) || (flow.frame(b).tag & begins_inside) != 0) {
      leave(b, ig::Where::columns(position, end));
      return block_end(text, end);
    }
    b.raise(begun);
    b.raise(number_before);
    return end;
  }

 private:
  void leave(ig::Block& b, const ig::Where& where) {
    const ig_frame frame = flow.frame(b);
    if (frame.depth > 0 && flow.leave(b).is_done()) {
      b.report(ig::diag("ISO-0490"), where, std::string_view(name), ig::to_view(frame.program));
      return;
    }
    b.report(ig::diag("ISO-0113"), where, std::string_view(name));
    b.end_program();
  }

  /// True for letters, digits and + - _ . only: a tag of XML is not a program name.
  static bool is_name(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
      return is_letter(c) || is_digit(c) || std::string_view("+-_.").find(c) != std::string_view::npos;
    });
  }

  std::size_t read_name(std::string_view text, std::size_t position) {
    const bool is_o = to_upper(text[position]) == 'O';
    if (is_o && begins_o_word(text, position)) return position;
    const std::size_t start = text[position] == '<' ? position : skip_blanks(text, position + 1);
    if (at(text, start) == '<') {
      const std::size_t close = skip_bracketed(text, start);
      if (text[close - 1] != '>' || !is_name(piece(text, start + 1, close - 1))) return position;
      name.assign(piece(text, start, close));
      return close;
    }
    const std::size_t end = skip_digits(text, start);
    if (end == start) return position;
    name.assign(1, 'O').append(piece(text, start, end));
    return end;
  }
};

const ig::Register<ProgramNumberSyntax> program_number_syntax;

}  // namespace
}  // namespace iso
