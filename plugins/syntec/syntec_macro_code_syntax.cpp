/// Codes that call a macro of the machine builder: G200 to G999, and the G, M and T codes that parameters assign to
/// one. Such a macro is in MACRO format and is not executed; the words of the block are its arguments and move no axis.
/// The same holds for codes with two or more decimals (G68.18), which belong to robots.
#include <string>

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroCode {
  static constexpr auto spec =
      ig::syntax("SyntecMacroCodeSyntax",
                 "Reports macros of the machine's builder, which are not executed, and removes their words.")
          .after("FlagSyntax")
          .before("FanucMacroCallSyntax", "ParameterizedFlagSyntax", "DecimalPointSyntax", "ToolChangeSyntax")
          .scans("GMgm");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0002", "{0} calls the macro {1}, which is not executed: its moves are missing"),
  };

  /// The words that a macro takes from its block: a G macro with one axis takes all, an M code takes all but T.
  static constexpr std::string_view of_g = "XYZABCIJKUVWPQRLE", of_m = "XYZABCIJKUVWPQRLEDFHS";

  std::vector<ig::Word> words_ = words();
  ig::Word tool_{"Parsing.T", ig::read | ig::wake};
  ig::Signal called_{"Parsing.~BuilderMacro", ig::read | ig::write | ig::wake};
  ig::Signal by_m_{"Parsing.~BuilderMacroByM", ig::read | ig::write};
  MachineCodes machine_;  // a row of a code goes before the builder's macro, which is not executed here
  ig::Config macros_{"isogloss.code-call/1", ig::Need::optional, "The codes that call a macro, and its number."};
  bool tool_calls_ = macros_.number("T").has_value();

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const ig::Decimal code = ig::read_decimal(text, skip_blanks(text, position + 1));
    if (!code.ok || code.value < 0 || code.value > 99'999 || at(text, code.end) == '=') return position;
    const char letter = to_upper(text[position]);
    const std::string name = name_of(letter, piece(text, skip_blanks(text, position + 1), code.end));
    if (!macros_.number(name) || machine_.find(name) != nullptr) return position;
    const auto where = ig::Where::columns(position, code.end);
    if (letter == 'G' && code.value < 200 && code.decimals > 1)
      b.report(ig::diag("SYN-0003"), where, name,
               "it belongs to robots and signals; its words are not executed either");
    else
      b.report(ig::diag("SYN-0002"), where, name, file_of(name));
    b.raise(called_);
    if (letter == 'M') b.raise(by_m_);
    return code.end;
  }

  ig::Status build(ig::Block& b) const {
    if (tool_calls_ && b.has(tool_)) b.report(ig::diag("SYN-0002"), ig::Where::word(tool_.id()), "T", "T0000");
    if (!b.is_raised(called_)) return ig::Status::unchanged;
    const std::size_t count = b.is_raised(by_m_) ? of_m.size() : of_g.size();
    for (std::size_t i = 0; i < count; ++i) b.take(words_[i]);
    return ig::Status::changed;
  }

 private:
  static std::vector<ig::Word> words() {
    std::vector<ig::Word> out;
    for (const char letter : of_m) out.emplace_back(std::string("Parsing.") + letter, ig::read);
    return out;
  }

  /// G0 becomes G00, G200.0 becomes G200.
  static std::string name_of(char letter, std::string_view number) {
    while (number.size() > 1 && number.front() == '0' && is_digit(number[1])) number.remove_prefix(1);
    if (number.ends_with(".0")) number.remove_suffix(2);
    if (number.ends_with('.')) number.remove_suffix(1);
    return std::string(1, letter) + (skip_digits(number, 0) < 2 ? "0" : "") + std::string(number);
  }

  /// The name of the macro's file: G0200, G200001 for G200.1, M0123.
  static std::string file_of(std::string_view name) {
    const std::size_t point = std::min(name.find('.'), name.size());
    std::string digits(name.substr(1, point - 1));
    const std::size_t width = point < name.size() ? 3 : 4;
    if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
    if (point < name.size()) {
      const std::string_view decimals = name.substr(point + 1);
      if (decimals.size() < 3) digits.append(3 - decimals.size(), '0');
      digits.append(decimals);
    }
    return name.front() + digits;
  }
};

const ig::Register<SyntecMacroCode> syntec_macro_code_syntax;

}  // namespace
}  // namespace syntec
