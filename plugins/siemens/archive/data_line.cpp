// The grammar of data lines: [N10] NAME[1,2]=value ['checksum] [;comment].
#include "archive/data_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

bool is_hex(char c) { return is_digit(c) || letter_index(c) < 6; }

std::string_view without_control_characters(std::string_view t) {
  while (!t.empty() && static_cast<unsigned char>(t.front()) <= ' ') t.remove_prefix(1);
  while (!t.empty() && static_cast<unsigned char>(t.back()) <= ' ') t.remove_suffix(1);
  return t;
}

/// A checksum is an apostrophe and hexadecimal digits at the end. That of a text such as 'H2F' ends it, and is none.
std::string_view without_checksum(std::string_view t) {
  std::size_t i = t.size();
  while (i > 0 && is_hex(t[i - 1])) --i;
  if (i == t.size() || t.size() - i > 8 || i < 2 || t[i - 1] != '\'') return t;
  return trim(t.substr(0, i - 1));
}

std::optional<double> in_base(std::string_view digits, int base) {
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n, base);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return static_cast<double>(n);
}

std::optional<double> with_exponent(std::string_view mantissa, std::string_view exponent) {
  if (mantissa.starts_with('+')) mantissa.remove_prefix(1);
  if (exponent.starts_with('+')) exponent.remove_prefix(1);
  if (exponent.empty() || exponent.size() > 6) return std::nullopt;
  const std::string all = std::string(mantissa) + 'e' + std::string(exponent);
  double n = 0;
  const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), n);
  if (error != std::errc{} || end != all.data() + all.size() || !std::isfinite(n)) return std::nullopt;
  return n;
}

}  // namespace

std::string_view code_of(std::string_view line) {
  bool in_text = false;
  std::size_t end = 0;
  for (; end < line.size() && (in_text || line[end] != ';'); ++end) in_text = in_text != (line[end] == '"');
  std::string_view code = without_control_characters(line.substr(0, end));
  if (code.size() > 1 && to_upper(code[0]) == 'N') {
    const std::size_t digits = skip_digits(code, 1);
    if (digits > 1 && (digits == code.size() || is_blank(code[digits]))) code = trim(code.substr(digits));
  }
  return without_checksum(code);
}

std::optional<double> number_of(std::string_view value) {
  value = trim(value);
  if (value.size() > 3 && value.front() == '\'' && value.back() == '\'') switch (to_upper(value[1])) {
      case 'H': return in_base(value.substr(2, value.size() - 3), 16);
      case 'B': return in_base(value.substr(2, value.size() - 3), 2);
      default: return std::nullopt;
    }
  if (equals_ignoring_case(value, "TRUE")) return 1;
  if (equals_ignoring_case(value, "FALSE")) return 0;
  const ig::Decimal n = ig::read_decimal(value, 0);
  if (!n.ok) return std::nullopt;
  if (n.end == value.size()) return n.value;
  const std::string_view rest = value.substr(n.end);
  if (rest.size() < 3 || !equals_ignoring_case(rest.substr(0, 2), "EX")) return std::nullopt;
  return with_exponent(value.substr(0, n.end), rest.substr(2));
}

std::optional<std::string_view> quoted_text(std::string_view value) {
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return std::nullopt;
  return value.substr(1, value.size() - 2);
}

char Cursor::peek() {
  at_ = skip_blanks(text_, at_);
  return at(text_, at_);
}

bool Cursor::accept(char c) {
  if (is_at_end() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string_view Cursor::word() {
  if (!is_name_start(peek()) && peek() != '$') return {};
  const std::size_t begin = at_;
  at_ = skip_name(text_, text_[at_] == '$' ? at_ + 1 : at_);
  return piece(text_, begin, at_);
}

std::string_view Cursor::until(std::string_view ends) {
  at_ = skip_blanks(text_, at_);
  const std::size_t begin = at_;
  std::size_t depth = 0;
  bool in_text = false;
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '"') in_text = !in_text;
    if (in_text) continue;
    if (depth == 0 && ends.find(c) != std::string_view::npos) break;
    if (c == '(' || c == '[') ++depth;
    if ((c == ')' || c == ']') && depth > 0) --depth;
  }
  return trim(piece(text_, begin, at_));
}

std::vector<std::string_view> split(std::string_view list) {
  std::vector<std::string_view> out;
  Cursor cursor(list);
  do {
    out.push_back(cursor.until(","));
  } while (cursor.accept(','));
  return out;
}

std::string Assignment::full_name() const {
  std::string out = name;
  for (std::size_t i = 0; i < index.size(); ++i) out += (i == 0 ? '[' : ',') + index[i];
  return index.empty() ? out : out + ']';
}

std::int64_t Assignment::number(std::size_t position) const {
  std::int64_t n = -1;
  if (position >= index.size()) return n;
  const std::string& text = index[position];
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  return error == std::errc{} && end == text.data() + text.size() ? n : -1;
}

std::optional<Assignment> read_assignment(Cursor& cursor) {
  const std::string_view begin = (cursor.peek(), cursor.rest());
  Assignment out;
  out.name = upper(cursor.word());
  if (out.name.empty()) return std::nullopt;
  if (cursor.accept('[')) {
    for (const std::string_view part : split(cursor.until("]"))) {
      std::int64_t n = 0;
      const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), n);
      if (error == std::errc{} && end == part.data() + part.size() && n >= 0 && n < 1'000'000'000)
        out.index.push_back(std::to_string(n));
      else if (!part.empty() && is_name_start(part[0]) && skip_name(part, 0) == part.size())
        out.index.push_back(upper(part));
      else
        return std::nullopt;
    }
    if (!cursor.accept(']')) return std::nullopt;
  }
  if (!cursor.accept('=') || cursor.peek() == '=') return std::nullopt;
  // A blank ends the value, unless an operator or a bracket shows that it goes on.
  const std::string_view value = (cursor.peek(), cursor.rest());
  for (char last = '='; !cursor.is_at_end();) {
    const char next = cursor.peek();
    constexpr std::string_view joints = "=:(,+-*/<>";
    if (joints.find(last) == std::string_view::npos && joints.find(next) == std::string_view::npos) break;
    const std::string_view part = cursor.until(" \t");
    if (part.empty()) break;
    last = part.back();
  }
  const auto length = [&](std::string_view from) { return trim(from.substr(0, from.size() - cursor.rest().size())); };
  out.value = length(value);
  out.written = length(begin);
  return out;
}

bool FileHead::holds_programs() const {
  for (const std::string_view e : {"MPF", "SPF", "CYC", "CPF", "WPD", "JOB"})
    if (extension == e) return true;
  return false;
}

bool FileHead::holds_data() const {
  for (const std::string_view e :
       {"INI", "TOA", "TMA", "UFR", "RPA", "GUD", "TEA", "SEA", "PRO", "EEC", "CEC", "QEC", "DEF"})
    if (extension == e) return true;
  return false;
}

std::optional<FileHead> read_head(std::string_view line) {
  const std::string_view t = without_control_characters(line);
  if (t.size() < 4 || t[0] != '%') return std::nullopt;
  const std::string name = upper(t.substr(1, skip_name(t, 1) - 1));
  if (name.starts_with("MPF") || name.starts_with("SPF")) return FileHead{name, name.substr(0, 3)};
  if (!name.starts_with("_N_") || name.size() < 4) return std::nullopt;
  const std::size_t cut = name.rfind('_');
  return cut < 3 ? FileHead{name.substr(3), ""} : FileHead{name.substr(3, cut - 3), name.substr(cut + 1)};
}

bool is_file_end(std::string_view code) {
  for (const std::string_view e : {"M17", "M30", "M02", "M2", "RET", "%"})
    if (equals_ignoring_case(code, e)) return true;
  return false;
}

bool FlowFilter::leaves_out(ig::Import& file, std::string_view code) {
  Cursor cursor(code);
  const std::string word = upper(cursor.word());
  const auto is = [&](auto... words) { return ((word == words) || ...); };
  if (cursor.peek() == '=' || cursor.peek() == '[') return depth_ > 0 && (leave_out(file, code), true);
  const bool opens =
      is("FOR", "WHILE", "LOOP", "REPEAT") || (is("IF") && upper(code).find("GOTO") == std::string::npos);
  const bool closes = is("ENDIF", "ENDFOR", "ENDWHILE", "ENDLOOP", "UNTIL");
  const bool stands_alone = is("IF", "ELSE", "CASE", "CALL", "PCALL", "EXTCALL", "MCALL") || word.starts_with("GOTO");
  if (closes) depth_ -= depth_ > 0;
  if (depth_ > 0) leave_out(file, code);
  if (depth_ == 0 && (opens || stands_alone)) {
    const std::size_t begin = place_in(file, code);
    file.report(ig::diag("SIE-0341"), begin, begin + code.size(), shown(code));
  }
  if (opens) ++depth_;
  return depth_ > 0 || opens || closes || stands_alone;
}

void FlowFilter::leave_out(ig::Import& file, std::string_view code) {
  const std::size_t begin = place_in(file, code);
  file.unused("line under a condition", "conditions are not evaluated", begin, begin + code.size());
}

}  // namespace siemens
