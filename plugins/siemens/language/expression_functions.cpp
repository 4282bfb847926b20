/// The functions of an expression: SIN(30), POT(R1), MINVAL(1,2), STRLEN("AB"). Angles are in degrees. Characters of a
/// text are counted from 0, and -1 is the place of one that is not found.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <isogloss/cnc/degrees.hpp>
#include <isogloss/cnc/units.hpp>

#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

using Arguments = std::array<Value, 3>;

struct Function {
  std::string_view name;
  std::size_t least;
  std::string_view takes;  ///< n: a number of any type, t: a text; one letter for each parameter
  /// A number that is not finite: there is no result. Null for ISVAR, which asks for more than its parameters.
  Value (*compute)(const Arguments& v);
};

constexpr double no_result = std::numeric_limits<double>::quiet_NaN();
constexpr double not_given = std::numeric_limits<double>::infinity();  ///< of a parameter that the call leaves out

/// The number at the beginning of a text, 1.5EX-3 too, and where it ends.
struct NumberOfText {
  double value = no_result;
  std::size_t end = 0;
};
NumberOfText number_in(std::string_view text) {
  const ig::Decimal d = ig::read_decimal(text, skip_blanks(text, 0));
  if (!d.ok) return {};
  NumberOfText out{d.value, d.end};
  if (!equals_ignoring_case(piece(text, d.end, std::min(d.end + 2, text.size())), "EX")) return out;
  const std::size_t sign = d.end + 2;
  const std::size_t digits = at(text, sign) == '+' || at(text, sign) == '-' ? sign + 1 : sign;
  const std::size_t end = skip_digits(text, digits);
  if (end == digits) return out;
  const double power = std::fmin(ig::read_decimal(text, digits).value, 9999);
  out.value *= std::pow(10, at(text, sign) == '-' ? -power : power);
  out.end = end;
  return out;
}

bool is_number(std::string_view text) {
  const NumberOfText number = number_in(text);
  return number.end > 0 && skip_blanks(text, number.end) >= text.size();
}

Value place(std::size_t found) { return Value::integer(found == std::string::npos ? -1 : static_cast<double>(found)); }

/// SUBSTR("ABCD",1,2) is BC; behind the last character there is nothing.
Value part_of(const std::string& text, double first, double length) {
  if (!(first >= 0) || !(length >= 0)) return Value::real(no_result);
  if (first >= static_cast<double>(text.size())) return Value::string("");
  return Value::string(text.substr(static_cast<std::size_t>(first),
                                   static_cast<std::size_t>(std::fmin(length, static_cast<double>(text.size())))));
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return text;
}

constexpr Function known_functions[] = {
    {"SIN", 1, "n", [](const Arguments& v) { return Value::real(sine(v[0].number)); }},
    {"COS", 1, "n", [](const Arguments& v) { return Value::real(cosine(v[0].number)); }},
    {"TAN", 1, "n", [](const Arguments& v) { return Value::real(tangent(v[0].number)); }},
    {"ASIN", 1, "n", [](const Arguments& v) { return Value::real(arc_sine(v[0].number)); }},
    {"ACOS", 1, "n", [](const Arguments& v) { return Value::real(arc_cosine(v[0].number)); }},
    {"ATAN2", 2, "nn",
     [](const Arguments& v) { return Value::real(std::atan2(v[0].number, v[1].number) / radians_per_degree); }},
    {"SQRT", 1, "n", [](const Arguments& v) { return Value::real(std::sqrt(v[0].number)); }},
    {"ABS", 1, "n", [](const Arguments& v) { return Value::real(std::fabs(v[0].number)); }},
    {"POT", 1, "n", [](const Arguments& v) { return Value::real(v[0].number * v[0].number); }},
    {"TRUNC", 1, "n", [](const Arguments& v) { return Value::real(std::trunc(v[0].number)); }},
    {"ROUND", 1, "n", [](const Arguments& v) { return Value::real(std::round(v[0].number)); }},
    {"ROUNDUP", 1, "n", [](const Arguments& v) { return Value::real(std::ceil(v[0].number)); }},
    {"LN", 1, "n", [](const Arguments& v) { return Value::real(v[0].number > 0 ? std::log(v[0].number) : no_result); }},
    {"EXP", 1, "n", [](const Arguments& v) { return Value::real(std::exp(v[0].number)); }},
    {"MINVAL", 2, "nn", [](const Arguments& v) { return Value::real(std::fmin(v[0].number, v[1].number)); }},
    {"MAXVAL", 2, "nn", [](const Arguments& v) { return Value::real(std::fmax(v[0].number, v[1].number)); }},
    {"BOUND", 3, "nnn",
     [](const Arguments& v) { return Value::real(std::fmin(std::fmax(v[2].number, v[0].number), v[1].number)); }},
    {"STRLEN", 1, "t", [](const Arguments& v) { return Value::real(static_cast<double>(v[0].text.size())); }},
    {"NUMBER", 1, "t", [](const Arguments& v) { return Value::real(number_in(v[0].text).value); }},
    {"TOUPPER", 1, "t", [](const Arguments& v) { return Value::string(upper(v[0].text)); }},
    {"TOLOWER", 1, "t", [](const Arguments& v) { return Value::string(lower(v[0].text)); }},
    {"ISVAR", 1, "t", nullptr},
    {"ISNUMBER", 1, "t", [](const Arguments& v) { return Value::truth(is_number(v[0].text)); }},
    {"INDEX", 2, "tt", [](const Arguments& v) { return place(v[0].text.find(v[1].text)); }},
    {"RINDEX", 2, "tt", [](const Arguments& v) { return place(v[0].text.rfind(v[1].text)); }},
    {"MINDEX", 2, "tt", [](const Arguments& v) { return place(v[0].text.find_first_of(v[1].text)); }},
    {"MATCH", 2, "tt", [](const Arguments& v) { return place(v[0].text.find(v[1].text)); }},
    {"SUBSTR", 2, "tnn", [](const Arguments& v) { return part_of(v[0].text, v[1].number, v[2].number); }},
    {"AXNAME", 1, "t", [](const Arguments& v) { return Value::string(upper(v[0].text)); }}};

/// True for functions that ask a running control about tools, curves, axes, files and protection zones.
bool asks_control(std::string_view name) {
  for (const std::string_view known :
       {"GETT",     "GETACTT",  "GETACTTD",   "GETDNO",     "GETEXET",    "GETSELT", "GETTCOR",  "NEWT",    "CHKDNO",
        "CTAB",     "CTABINV",  "CTABTSV",    "CTABTEV",    "CTABTSP",    "CTABTEP", "CTABSSV",  "CTABSEV", "CTABTMIN",
        "CTABTMAX", "CTABID",   "CTABEXISTS", "CTABPERIOD", "CTABISLOCK", "ISFILE",  "CALCPOSI", "GETTENV", "TCARR",
        "MODAXVAL", "POSRANGE", "SPI",        "AXTOSPI",    "GETTCOR",    "LENTOAX", "STRINGIS", "COLLPAIR"})
    if (known == name) return true;
  return false;
}

}  // namespace

std::optional<Value> Expression::call(const std::string& name, std::size_t begin) {
  const auto* const f = std::find_if(std::begin(known_functions), std::end(known_functions),
                                     [&](const Function& known) { return known.name == name; });
  if (f == std::end(known_functions)) {
    at_ = skip_call(text_, at_);
    return fail(asks_control(name) ? ig::diag("SIE-0321") : ig::diag("SIE-0109"), begin, std::string_view(name));
  }
  if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
  const std::size_t open = at_++;
  Arguments v;
  for (Value& missing : v) missing.number = not_given;
  std::size_t count = 0;
  for (;;) {
    const auto argument = level(loosest);
    if (!argument) return std::nullopt;
    if (count < v.size()) v[count] = *argument;
    ++count;
    skip_blanks();
    if (peek() != ',') break;
    ++at_;
  }
  --depth_;
  if (peek() != ')') return fail(ig::diag("SIE-0102"), open);
  ++at_;
  if (count < f->least || count > f->takes.size())
    return fail(ig::diag("SIE-0113"), begin, f->name, static_cast<double>(f->least));
  for (std::size_t i = 0; i < count; ++i)
    if (v[i].is_text() != (f->takes[i] == 't')) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  if (f->compute == nullptr) return is_variable(v[0].text, begin);
  Value out = f->compute(v);
  if (!std::isfinite(out.number)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
  out.number += 0.0;  // no negative zero
  return out;
}

}  // namespace siemens
