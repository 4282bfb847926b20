/// The functions of an expression: SIN(30), POT(R1), MINVAL(1,2), STRLEN("AB"). Angles are in degrees.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <isogloss/cnc/units.hpp>

#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

using Arguments = std::array<Value, 3>;

struct Function {
  std::string_view name;
  std::size_t least, most;
  Type takes;                            ///< real: numbers of any type
  Value (*compute)(const Arguments& v);  ///< a number that is not finite: there is no result
};

constexpr double no_result = std::numeric_limits<double>::quiet_NaN();

/// The sine at quarter turns, where it is exact; at other angles `otherwise`.
double exact_sine(double degrees, double otherwise) {
  const double quarter = std::remainder(degrees, 360);
  if (quarter == 0 || std::fabs(quarter) == 180) return 0;
  if (quarter == 90) return 1;
  return quarter == -90 ? -1 : otherwise;
}

double sine(double degrees) { return exact_sine(degrees, std::sin(std::remainder(degrees, 360) * radians_per_degree)); }

double cosine(double degrees) {
  return exact_sine(degrees + 90, std::cos(std::remainder(degrees, 360) * radians_per_degree));
}

double tangent(double degrees) {
  const double angle = std::remainder(degrees, 180);
  return std::fabs(angle) == 90 ? no_result : std::tan(angle * radians_per_degree);
}

double number_in(const std::string& text) {
  const ig::Decimal d = ig::read_decimal(text, skip_blanks(text, 0));
  return d.ok ? d.value : no_result;
}

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return text;
}

constexpr Function known_functions[] = {
    {"SIN", 1, 1, Type::real, [](const Arguments& v) { return Value::real(sine(v[0].number)); }},
    {"COS", 1, 1, Type::real, [](const Arguments& v) { return Value::real(cosine(v[0].number)); }},
    {"TAN", 1, 1, Type::real, [](const Arguments& v) { return Value::real(tangent(v[0].number)); }},
    {"ASIN", 1, 1, Type::real,
     [](const Arguments& v) { return Value::real(std::asin(v[0].number) / radians_per_degree); }},
    {"ACOS", 1, 1, Type::real,
     [](const Arguments& v) { return Value::real(std::acos(v[0].number) / radians_per_degree); }},
    {"ATAN2", 2, 2, Type::real,
     [](const Arguments& v) { return Value::real(std::atan2(v[0].number, v[1].number) / radians_per_degree); }},
    {"SQRT", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::sqrt(v[0].number)); }},
    {"ABS", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::fabs(v[0].number)); }},
    {"POT", 1, 1, Type::real, [](const Arguments& v) { return Value::real(v[0].number * v[0].number); }},
    {"TRUNC", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::trunc(v[0].number)); }},
    {"ROUND", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::round(v[0].number)); }},
    {"ROUNDUP", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::ceil(v[0].number)); }},
    {"LN", 1, 1, Type::real,
     [](const Arguments& v) { return Value::real(v[0].number > 0 ? std::log(v[0].number) : no_result); }},
    {"EXP", 1, 1, Type::real, [](const Arguments& v) { return Value::real(std::exp(v[0].number)); }},
    {"MINVAL", 2, 2, Type::real, [](const Arguments& v) { return Value::real(std::fmin(v[0].number, v[1].number)); }},
    {"MAXVAL", 2, 2, Type::real, [](const Arguments& v) { return Value::real(std::fmax(v[0].number, v[1].number)); }},
    {"BOUND", 3, 3, Type::real,
     [](const Arguments& v) { return Value::real(std::fmin(std::fmax(v[2].number, v[0].number), v[1].number)); }},
    {"STRLEN", 1, 1, Type::text, [](const Arguments& v) { return Value::real(static_cast<double>(v[0].text.size())); }},
    {"NUMBER", 1, 1, Type::text, [](const Arguments& v) { return Value::real(number_in(v[0].text)); }},
    {"TOUPPER", 1, 1, Type::text, [](const Arguments& v) { return Value::string(upper(v[0].text)); }},
    {"TOLOWER", 1, 1, Type::text, [](const Arguments& v) { return Value::string(lower(v[0].text)); }},
    {"AXNAME", 1, 1, Type::text, [](const Arguments& v) { return Value::string(upper(v[0].text)); }}};

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
  if (count < f->least || count > f->most)
    return fail(ig::diag("SIE-0113"), begin, f->name, static_cast<double>(f->least));
  for (std::size_t i = 0; i < count; ++i)
    if (v[i].is_text() != (f->takes == Type::text)) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  Value out = f->compute(v);
  if (!std::isfinite(out.number)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
  out.number += 0.0;  // no negative zero
  return out;
}

}  // namespace siemens
