#include "language/string_formula.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "language/block_words.hpp"

namespace heidenhain {

namespace {

enum Function : std::size_t { to_number, length, find, compare };
constexpr std::array<std::string_view, 4> number_functions{"TONUMB", "STRLEN", "INSTR", "STRCOMP"};
constexpr int most_text_decimals = 9;

}  // namespace

bool StringFormula::is_number_function(std::string_view text, std::size_t position) {
  const std::string_view word = piece(text, position, letters_end(text, position));
  return std::any_of(number_functions.begin(), number_functions.end(),
                     [&](std::string_view name) { return equals_ignoring_case(word, name); });
}

std::optional<std::string> StringFormula::text() {
  std::optional<std::string> all = operand();
  while (all && skips("||")) {
    const std::optional<std::string> more = operand();
    if (!more) return std::nullopt;
    *all += *more;
  }
  return all;
}

std::optional<std::string> StringFormula::operand() {
  position_ = skip(text_, position_);
  if (at(text_, position_) == '"') return quoted();
  std::size_t end = position_;
  if (Values::text_parameter_at(text_, position_, end)) {
    const auto held = values_.text(b_, text_, position_, end);
    position_ = end;
    return held ? std::optional<std::string>(*held) : std::nullopt;
  }
  const std::size_t begin = position_;
  if (skips("TOCHAR")) return to_char();
  if (skips("SUBSTR")) return substring();
  if (skips("SYSSTR")) return of_system(begin);
  const std::string_view rest = rest_of_line(text_, begin);
  if (rest.empty()) return missing("a text");
  b_.report(ig::diag("HEI-0116"), where_of_line(text_, begin), rest,
            std::string_view("this is no text, and no function of texts that is known here"));
  return std::nullopt;
}

std::optional<std::string> StringFormula::quoted() {
  const std::size_t close = text_.find('"', position_ + 1);
  if (close == std::string_view::npos) return missing("the closing quotation mark");
  std::string inner(piece(text_, position_ + 1, close));
  position_ = close + 1;
  return inner;
}

/// TOCHAR ( DAT+Q50 DECIMALS4 )
std::optional<std::string> StringFormula::to_char() {
  if (!expects("(", "(") || !expects("DAT", "DAT")) return std::nullopt;
  const Value number = values_.read(b_, text_, position_);
  if (!number.ok) return missing("the value of DAT");
  position_ = number.end;
  const std::optional<double> decimals = value("DECIMALS", -1);
  if (!decimals || !expects(")", ")")) return std::nullopt;
  std::array<char, 400> digits{};
  char* const end = digits.data() + digits.size();
  const double places = std::fmin(std::floor(*decimals), most_text_decimals);
  const auto written =
      places < 0 ? std::to_chars(digits.data(), end, number.number, std::chars_format::fixed)
                 : std::to_chars(digits.data(), end, number.number, std::chars_format::fixed, static_cast<int>(places));
  return std::string(digits.data(), written.ptr);
}

/// SUBSTR ( SRC_QS10 BEG2 LEN4 )
std::optional<std::string> StringFormula::substring() {
  if (!expects("(", "(")) return std::nullopt;
  const auto source = parameter("SRC_");
  const auto begin = source ? value("BEG", 0) : std::nullopt;
  const auto count = begin ? value("LEN", std::nullopt) : std::nullopt;
  if (!count || !expects(")", ")")) return std::nullopt;
  const auto whole = [&](double n) {
    return static_cast<std::size_t>(std::fmin(std::fmax(std::floor(n), 0), static_cast<double>(source->size())));
  };
  return source->substr(whole(*begin), whole(*count));
}

/// SYSSTR ( ID10321 NR0 ): paths, the time, names of tools.
std::optional<std::string> StringFormula::of_system(std::size_t begin) {
  if (!expects("(", "(")) return std::nullopt;
  for (const std::string_view word : {"ID", "NR", "IDX", "DAT"})
    if (!value(word, 0)) return std::nullopt;
  if (!expects(")", ")")) return std::nullopt;
  b_.report(ig::diag("HEI-0375"), ig::Where::columns(begin, position_), trim(piece(text_, begin, position_)));
  return std::string();
}

std::optional<double> StringFormula::number() {
  const std::size_t end = letters_end(text_, position_);
  std::size_t function = 0;
  while (!equals_ignoring_case(piece(text_, position_, end), number_functions[function])) ++function;
  position_ = end;
  if (!expects("(", "(")) return std::nullopt;
  const auto result = result_of(function);
  return result && expects(")", ")") ? result : std::nullopt;
}

std::optional<double> StringFormula::result_of(std::size_t function) {
  const auto source = parameter("SRC_");
  if (!source) return std::nullopt;
  if (function == length) return static_cast<double>(source->size());
  if (function == to_number) {
    const std::string_view digits = trim(*source);
    const Value read = values_.read(b_, digits, 0);
    if (read.ok && read.end == digits.size() && !digits.empty() && digits.find_first_of("Qq") == std::string_view::npos)
      return read.number;
    return missing("a number in the text of SRC_");
  }
  const auto sought = parameter("SEA_");
  if (!sought) return std::nullopt;
  if (function == compare) return *source == *sought ? 0 : *source < *sought ? -1 : 1;
  const auto begin = value("BEG", 0);
  if (!begin) return std::nullopt;
  const auto first = static_cast<std::size_t>(std::fmin(std::fmax(*begin, 0), static_cast<double>(source->size())));
  // A control gives the length of the text where it does not find the other one.
  return static_cast<double>(std::min(source->find(*sought, first), source->size()));
}

bool StringFormula::skips(std::string_view word) {
  const std::size_t begin = skip(text_, position_), end = glued(text_, begin, word);
  if (end != begin) position_ = end;
  return end != begin;
}

bool StringFormula::expects(std::string_view word, std::string_view shown) {
  if (skips(word)) return true;
  missing(shown);
  return false;
}

std::optional<std::string> StringFormula::parameter(std::string_view word) {
  if (!expects(word, word)) return std::nullopt;
  std::size_t end = position_;
  if (!Values::text_parameter_at(text_, position_, end)) return missing("a string parameter");
  const auto held = values_.text(b_, text_, position_, end);
  position_ = end;
  return held ? std::optional<std::string>(*held) : std::nullopt;
}

std::optional<double> StringFormula::value(std::string_view word, std::optional<double> otherwise) {
  if (!skips(word)) {
    if (!otherwise) missing(word);
    return otherwise;
  }
  const Value v = values_.read(b_, text_, position_);
  if (!v.ok) return missing(word);
  position_ = v.end;
  return v.number;
}

std::nullopt_t StringFormula::missing(std::string_view what) {
  b_.report(ig::diag("HEI-0119"), where_of_line(text_, std::min(position_, text_.size())), what);
  return std::nullopt;
}

}  // namespace heidenhain
