/// The functions of expressions (Syntec, Macro Function List).
#include <charconv>
#include <cmath>
#include <string>

#include <isogloss/cnc/degrees.hpp>

#include "macro/macro_expression.hpp"

namespace syntec {

using ig::cnc::is_digit;
using ig::cnc::is_letter;

namespace {

/// What only the machine knows, or what gives it orders and answers.
constexpr std::string_view known_to_machine[] = {
    "READDI", "READDO", "READABIT", "READRREGBIT", "SYSDATA", "DRVDATA", "GETPR",  "CHKMN",    "CHKSN",   "CHKMT",
    "CHKMI",  "CHKINF", "RANDOM",   "DBOPEN",      "DBNEW",   "DBLOAD",  "DBSAVE", "DBINSERT", "DBDELETE"};

}  // namespace

std::string shown(const MacroValue& value) {
  if (value.is_text()) return value.text;
  if (value.is_vacant()) return {};
  std::array<char, 32> digits{};
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value.number).ptr;
  return {digits.data(), end};
}

std::optional<std::string> with_variables(ig::Block& b, const MacroEnvironment& environment, std::string_view text,
                                          ig::Where where) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const ig::Digits digits = text[i] == '#' || text[i] == '@' ? ig::read_digits(text, i + 1) : ig::Digits{};
    if (!digits.ok) {
      out += text[i++];
      continue;
    }
    const auto number = static_cast<double>(digits.value);
    const auto v = text[i] == '#' ? hash_variable(number) : at_variable(number);
    if (!v) {
      b.report(ig::diag("SYN-0025"), where, text.substr(i, digits.end - i));
      return std::nullopt;
    }
    const auto value = environment.read(b, *v, where);
    if (!value) return std::nullopt;
    out += shown(*value);
    if (out.size() > longest_text) {
      b.report(ig::diag("SYN-0033"), where, text.substr(0, 60));
      return std::nullopt;
    }
    i = digits.end;
  }
  return out;
}

std::optional<MacroValue> MacroExpression::named() {
  const std::size_t begin = position_;
  const auto is_part = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
  position_ = ig::cnc::skip_name_of(text_.text, begin, is_part);
  const std::string name = ig::cnc::in_capitals(text_.text.substr(begin, position_ - begin));
  skip();
  if (name == "STKTOP" && here() == '[') {
    ++position_;
    const auto index = number();
    if (!index) return std::nullopt;
    if (!accept(']')) return unclosed(begin);
    const std::vector<MacroValue>& stack = environment_.store().stack;
    if (!(*index >= 0 && *index < static_cast<double>(stack.size())) || *index != std::floor(*index))
      return fail(ig::diag("SYN-0029"), begin, position_);
    return stack[stack.size() - 1 - static_cast<std::size_t>(*index)];
  }
  if (here() == '[' && (name == "AR" || name == "MAR")) return fail(ig::diag("SYN-0027"), begin, position_);
  if (here() != '(') {
    const std::size_t digits = name.starts_with("MAR") ? 3 : 2;
    const bool is_of_app = (name.starts_with("AR") || name.starts_with("MAR")) && name.size() > digits &&
                           ig::cnc::skip_digits(name, digits) == name.size();
    return fail(is_of_app ? ig::diag("SYN-0027") : ig::diag("SYN-0026"), begin, begin + name.size());
  }
  return call(name, begin);
}

std::optional<std::vector<MacroValue>> MacroExpression::arguments() {
  const std::size_t begin = position_;
  if (!accept('(')) return fail(ig::diag("SYN-0021"), begin, text_.text.size());
  std::vector<MacroValue> out;
  if (accept(')')) return out;
  do {
    constexpr std::size_t most = 16;
    auto one = binary(0);
    if (!one) return std::nullopt;
    if (out.size() == most) return fail(ig::diag("SYN-0021"), begin, position_);
    out.push_back(std::move(*one));
  } while (accept(','));
  if (!accept(')')) return unclosed(begin);
  return out;
}

/// A name in brackets: X, X1, or the letter of an axis.
std::optional<MacroValue> MacroExpression::of_argument(std::string_view name, std::size_t begin) {
  accept('(');
  const std::size_t at_value = position_;
  std::optional<MacroValue> value;
  if (name == "STDAX") {
    value = binary(0);
    if (!value) return std::nullopt;
    if (!accept(',')) return fail(ig::diag("SYN-0021"), at_value, text_.text.size());
  }
  skip();
  const std::size_t first = position_;
  position_ = ig::cnc::skip_name_of(text_.text, first, [](char c) { return is_letter(c) || is_digit(c); });
  const std::string argument = ig::cnc::in_capitals(text_.text.substr(first, position_ - first));
  const bool is_name =
      !argument.empty() && is_letter(argument[0]) && ig::cnc::skip_digits(argument, 1) == argument.size();
  if (!is_name || !accept(')')) return fail(ig::diag("SYN-0021"), first, text_.text.size());
  if (name == "AXID") {
    const std::size_t axis = argument.size() == 1 ? std::string_view("XYZ").find(argument[0]) : std::string_view::npos;
    if (axis == std::string_view::npos) return fail(ig::diag("SYN-0027"), begin, position_);
    return MacroValue::whole(static_cast<double>(axis + 1));
  }
  if (name == "STDAX") {
    const bool is_angle = std::string_view("ABC").find(argument[0]) != std::string_view::npos;
    return standard(*value, is_angle ? environment_.angle_unit() : environment_.length_unit(block_), begin);
  }
  MacroStore::Level& level = environment_.store().level();
  environment_.note_letter(argument.size() == 1 ? variable_of_letter(argument[0]) : 0);
  const MacroValue* const found = (name == "GETARG" ? level.arguments : level.trap).find(argument);
  MacroValue out = found != nullptr ? *found : MacroValue();
  if (out.is_vacant()) out.text = piece(begin, position_);
  return out;
}

/// An integer counts the unit, unless Pr3241 reads integers as lengths.
std::optional<MacroValue> MacroExpression::standard(const MacroValue& value, double unit, std::size_t begin) {
  if (value.is_text()) return fail(ig::diag("SYN-0031"), begin, position_);
  if (!value.is_whole()) return value;
  if (environment_.whole_numbers_are_mm()) return MacroValue::real(value.number);
  // 5 / 1000 is the double of 0.005, 5 * 0.001 is not.
  const double parts = std::round(1 / unit);
  const bool is_part = parts <= largest_whole && std::abs(parts * unit - 1) < 1e-9;
  return MacroValue::real(is_part ? value.number / parts : value.number * unit);
}

std::optional<MacroValue> MacroExpression::call(std::string_view name, std::size_t begin) {
  for (const std::string_view special : {"GETARG", "GETTRAPARG", "STDAX", "AXID"})
    if (name == special) return of_argument(name, begin);
  for (const std::string_view unknown : known_to_machine)
    if (name == unknown) return fail(ig::diag("SYN-0027"), begin, text_.text.size());
  if (depth_ >= deepest) {
    block_.report(ig::diag("SYN-0023"), text_.from(begin), static_cast<double>(deepest));
    return std::nullopt;
  }
  ++depth_;
  const auto given = arguments();
  --depth_;
  if (!given) return std::nullopt;
  bool is_known = false;
  auto out = mathematical(name, *given, begin, is_known);
  if (!is_known) out = of_control(name, *given, begin, is_known);
  if (!is_known) return fail(ig::diag("SYN-0026"), begin, position_);
  return out;
}

std::optional<MacroValue> MacroExpression::mathematical(std::string_view name, const std::vector<MacroValue>& given,
                                                        std::size_t begin, bool& is_known) {
  struct Function {
    std::string_view name;
    std::size_t arguments;
  };
  constexpr Function functions[] = {{"ABS", 1},  {"SIN", 1},   {"COS", 1},  {"TAN", 1},   {"ASIN", 1}, {"ACOS", 1},
                                    {"ATAN", 1}, {"ATAN2", 2}, {"SQRT", 1}, {"POW", 2},   {"EXP", 1},  {"LN", 1},
                                    {"MAX", 2},  {"MIN", 2},   {"SIGN", 1}, {"ROUND", 1}, {"CEIL", 1}, {"FLOOR", 1}};
  const Function* function = nullptr;
  for (const Function& f : functions)
    if (f.name == name) function = &f;
  if (function == nullptr) return std::nullopt;
  is_known = true;
  if (given.size() != function->arguments) return fail(ig::diag("SYN-0021"), begin, position_);
  const auto first = operand(given[0], begin);
  const auto second = given.size() > 1 ? operand(given[1], begin) : std::optional(0.0);
  if (!first || !second) return std::nullopt;
  const double x = *first, y = *second;
  const auto outside = [&] { return fail(ig::diag("SYN-0029"), begin, position_); };
  double out = 0;
  if (name == "MAX" || name == "MIN") {
    const MacroValue& chosen = (name == "MAX") == (x >= y) ? given[0] : given[1];
    return chosen.is_vacant() ? MacroValue::whole(0) : chosen;
  }
  if (name == "SIGN") return MacroValue::whole(x > 0 ? 1 : x < 0 ? -1 : 0);
  if (name == "ROUND") return whole_of(std::round(x), begin);
  if (name == "CEIL") return whole_of(std::ceil(x), begin);
  if (name == "FLOOR") return whole_of(std::floor(x), begin);
  if (name == "ABS") out = std::abs(x);
  if (name == "SIN") out = ig::cnc::sine(x);
  if (name == "COS") out = ig::cnc::cosine(x);
  if (name == "TAN") {
    out = ig::cnc::tangent(x);
    if (std::isnan(out)) return outside();
  }
  if (name == "ASIN" || name == "ACOS") {
    if (!(x >= -1 && x <= 1)) return outside();
    out = name == "ASIN" ? ig::cnc::arc_sine(x) : ig::cnc::arc_cosine(x);
  }
  if (name == "ATAN") out = std::atan(x) * ig::cnc::degrees_per_radian;
  if (name == "ATAN2") {
    if (x == 0 && y == 0) return outside();
    out = std::atan2(x, y) * ig::cnc::degrees_per_radian;
  }
  if (name == "SQRT") {
    if (x < 0) return outside();
    out = std::sqrt(x);
  }
  if (name == "POW") {
    if (x < 0) return outside();
    out = std::pow(x, y);
  }
  if (name == "EXP") out = std::exp(x);
  if (name == "LN") {
    if (x <= 0) return outside();
    out = std::log(x);
  }
  if (!std::isfinite(out)) return fail(ig::diag("SYN-0033"), begin, position_);
  return MacroValue::real(out + 0.0);
}

std::optional<MacroValue> MacroExpression::of_control(std::string_view name, const std::vector<MacroValue>& given,
                                                      std::size_t begin, bool& is_known) {
  is_known = true;
  const auto wrong = [&] { return fail(ig::diag("SYN-0021"), begin, position_); };
  const auto unknown = [&] { return fail(ig::diag("SYN-0027"), begin, position_); };
  if (name == "STD") {
    if (given.empty() || given.size() > 2) return wrong();
    if (given.size() == 1) return standard(given[0], environment_.length_unit(block_), begin);
    const auto unit = operand(given[1], begin);
    if (!unit) return std::nullopt;
    if (!(*unit > 0 && *unit <= 1)) return fail(ig::diag("SYN-0029"), begin, position_);
    return standard(given[0], *unit, begin);
  }
  if (name == "PARAM") {
    if (given.size() != 1) return given.size() == 2 ? unknown() : wrong();
    const auto number = whole_operand(given[0], "PARAM", begin);
    if (!number) return std::nullopt;
    const auto value = environment_.parameter(*number);
    if (value) return MacroValue::of_number(*value);
    block_.report(ig::diag("SYN-0034"), text_.where(begin, position_), *number);
    return std::nullopt;
  }
  if (name == "SYSVAR") {
    if (given.size() != 2) return wrong();
    const auto group = operand(given[0], begin), number = operand(given[1], begin);
    if (!group || !number) return std::nullopt;
    const auto v = *group == 1 ? hash_variable(*number) : std::nullopt;
    if (!v) return unknown();
    return environment_.read(block_, *v, text_.where(begin, position_));
  }
  if (name == "POP") {
    std::vector<MacroValue>& stack = environment_.store().stack;
    if (!given.empty()) return wrong();
    if (stack.empty()) return fail(ig::diag("SYN-0029"), begin, position_);
    MacroValue out = std::move(stack.back());
    stack.pop_back();
    return out;
  }
  if (name == "STR2INT") {
    if (given.size() != 1 || !given[0].is_text()) return wrong();
    const auto text = with_variables(block_, environment_, given[0].text, text_.where(begin, position_));
    if (!text) return std::nullopt;
    const std::string_view digits = ig::cnc::trim(*text);
    const ig::Decimal d = digits.empty() ? ig::Decimal{} : ig::read_decimal(digits, 0);
    if (!d.ok || d.end != digits.size()) return fail(ig::diag("SYN-0029"), begin, position_);
    return whole_of(std::trunc(d.value), begin);
  }
  if (name == "SCANTEXT") return scan_text(given, begin);
  if (name == "SETDRAW") return MacroValue::whole(0);  // the colour of a path that nothing draws
  is_known = false;
  return std::nullopt;
}

/// A text that was assigned to a common variable: four characters in each, up to a zero.
std::optional<MacroValue> MacroExpression::scan_text(const std::vector<MacroValue>& given, std::size_t begin) {
  if (given.size() != 1) return fail(ig::diag("SYN-0021"), begin, position_);
  const auto first = operand(given[0], begin);
  if (!first) return std::nullopt;
  std::string out;
  for (double number = *first; out.size() < longest_text; ++number) {
    const auto v = at_variable(number);
    if (!v || !environment_.store().is_known(*v) || !environment_.store().read(*v).is_number())
      return fail(ig::diag("SYN-0027"), begin, position_);
    const double value = environment_.store().read(*v).number;
    if (!(value >= -largest_whole - 1 && value <= 4294967295.0)) return fail(ig::diag("SYN-0027"), begin, position_);
    const auto packed = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    for (int i = 0; i < 4; ++i) {
      const auto c = static_cast<char>(packed >> (8 * i) & 0xffu);
      if (c == '\0') return MacroValue::of_text(std::move(out));
      out += c;
    }
  }
  return fail(ig::diag("SYN-0027"), begin, position_);
}

}  // namespace syntec
