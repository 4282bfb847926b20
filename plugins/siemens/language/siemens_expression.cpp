// Priorities follow the manual "Job planning", arithmetic functions: NOT binds first, comparisons last.
#include "language/siemens_expression.hpp"
#include <isogloss/cnc/units.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace siemens {

using namespace ig::cnc;

namespace {

struct Operator {
  std::string_view text;
  int priority;  // 1 binds first
};
// Longer operators come before those that they begin with.
constexpr Operator operators[] = {{"*", 1},     {"/", 1},    {"DIV", 1}, {"MOD", 1}, {"+", 2},  {"-", 2},  {"B_AND", 3},
                                  {"B_XOR", 4}, {"B_OR", 5}, {"AND", 6}, {"XOR", 7}, {"OR", 8}, {"<<", 9}, {"==", 10},
                                  {"<>", 10},   {">=", 10},  {"<=", 10}, {">", 10},  {"<", 10}};
constexpr int join_priority = 9, loosest = 10;

std::string text_of(const Value& v) {
  if (v.is_text()) return v.text;
  if (v.type == Type::boolean) return v.number != 0 ? "1" : "0";
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), v.number).ptr;
  return {digits.data(), end};
}

bool is_bits(double n) { return n == std::floor(n) && std::fabs(n) <= 2147483648.0 * 2; }

}  // namespace

std::optional<Value> Expression::value() {
  auto v = level(loosest);
  return failed_ ? std::nullopt : v;
}

std::optional<double> Expression::number() {
  const std::size_t begin = at_;
  const auto v = value();
  if (!v) return std::nullopt;
  if (v->is_text()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  return v->number;
}

std::optional<bool> Expression::truth() {
  const auto n = number();
  return n ? std::optional(*n != 0) : std::nullopt;
}

/// Takes the operator of that priority at the present position; "" where there is none.
std::string_view Expression::take_operator(int priority) {
  skip_blanks();
  for (const Operator& o : operators) {
    const std::string_view here = text_.substr(at_, o.text.size());
    if (!equals_ignoring_case(here, o.text)) continue;
    if (is_name_start(o.text[0]) && is_name_part(ig::cnc::at(text_, at_ + o.text.size()))) continue;
    if (o.text == "<" && ig::cnc::at(text_, at_ + 1) == '<') continue;
    if (o.priority != priority) return {};
    at_ += o.text.size();
    return o.text;
  }
  return {};
}

std::optional<Value> Expression::level(int priority) {
  if (priority == 0) return unary();
  skip_blanks();
  const std::size_t begin = at_;
  auto left = level(priority - 1);
  for (int count = 0; left; ++count) {
    const std::string_view op = take_operator(priority);
    if (op.empty()) break;
    if (count == 1 && priority == loosest)
      environment_.report_once(b_, ig::diag("SIE-0108"), ig::Where::columns(begin, at_), begin, shown(begin));
    const auto right = level(priority - 1);
    if (!right) return std::nullopt;
    left = apply(op, *left, *right, begin);
  }
  return left;
}

/// Signs and NOT, any number of them.
std::optional<Value> Expression::unary() {
  std::string prefix;  // applied from its end
  skip_blanks();
  for (;; skip_blanks()) {
    const char c = peek();
    if (c == '-' || c == '+') {
      prefix += c;
      ++at_;
    } else if (const std::size_t end = skip_name(text_, at_);
               equals_ignoring_case(ig::cnc::piece(text_, at_, end), "NOT")) {
      prefix += '!';
      at_ = end;
    } else if (equals_ignoring_case(ig::cnc::piece(text_, at_, end), "B_NOT")) {
      prefix += '~';
      at_ = end;
    } else if (text_.substr(at_, 2) == "<<") {
      return as_text();
    } else {
      break;
    }
  }
  const std::size_t begin = at_;
  auto v = operand();
  if (!v) return std::nullopt;
  if (v->is_text() && !prefix.empty()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  for (std::size_t i = prefix.size(); i-- > 0;) {
    if (prefix[i] == '-') v->number = -v->number + 0.0;
    if (prefix[i] == '!') v = Value::truth(v->number == 0);
    if (prefix[i] == '~') {
      if (!is_bits(v->number)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
      v = Value::integer(static_cast<double>(~static_cast<std::int32_t>(static_cast<std::int64_t>(v->number))));
    }
  }
  return v;
}

/// <<5 alone: the operand after it, as a text.
std::optional<Value> Expression::as_text() {
  at_ += 2;
  if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), at_, static_cast<double>(deepest));
  const auto v = level(join_priority - 1);
  --depth_;
  return v ? std::optional(Value::string(text_of(*v))) : std::nullopt;
}

std::optional<Value> Expression::operand() {
  const std::size_t begin = at_;
  const char c = peek();
  if (c == '(') {
    if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
    ++at_;
    auto v = level(loosest);
    --depth_;
    if (!v) return std::nullopt;
    skip_blanks();
    if (peek() != ')') return fail(ig::diag("SIE-0102"), begin);
    ++at_;
    return v;
  }
  if (is_digit(c) || c == '.' || c == '"' || c == '\'') return literal();
  if (is_name_start(c)) {
    const std::size_t end = skip_name(text_, at_);
    const std::string name = upper(ig::cnc::piece(text_, at_, end));
    if (name == "TRUE" || name == "FALSE") {
      at_ = end;
      return Value::truth(name == "TRUE");
    }
    if (name == "PI") {
      at_ = end;
      return Value::real(std::numbers::pi);
    }
    if (const std::string* const macro = environment_.store().macro(name)) {
      at_ = end;
      return of_macro(begin, *macro);
    }
    if (const std::size_t open = ig::cnc::skip_blanks(text_, end); ig::cnc::at(text_, open) == '(') {
      at_ = open;
      return call(name, begin);
    }
  } else if (c != '$') {
    return fail(ig::diag("SIE-0101"), begin, next_text(begin));
  }
  const auto r = reference();
  return r ? read(*r) : std::nullopt;
}

/// The value of the DEFINE text of the name that was read.
std::optional<Value> Expression::of_macro(std::size_t begin, const std::string& macro) {
  if (depth_ > 0 && depth_ >= deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
  const std::string padded = std::string(begin, ' ') + macro;
  Expression e(b_, environment_, padded, begin);
  e.depth_ = depth_ + 1;
  e.is_in_macro_ = true;
  auto v = is_in_macro_ ? std::nullopt : e.value();
  if (!is_in_macro_ && !v) {
    failed_ = true;
    return std::nullopt;
  }
  if (!v || ig::cnc::skip_blanks(padded, e.position()) < padded.size())
    return fail(ig::diag("SIE-0288"), begin, std::string_view(macro));
  return v;
}

std::optional<Value> Expression::literal() {
  const std::size_t begin = at_;
  if (peek() == '"') {
    const std::size_t close = text_.find('"', begin + 1);
    at_ = close == std::string_view::npos ? text_.size() : close + 1;
    if (close == std::string_view::npos) return fail(ig::diag("SIE-0102"), begin);
    return Value::string(std::string(ig::cnc::piece(text_, begin + 1, close)));
  }
  if (peek() == '\'') {  // 'HFF' and 'B101'
    const std::size_t close = std::min(text_.find('\'', begin + 1), text_.size());
    const std::string_view digits = ig::cnc::piece(text_, std::min(begin + 2, close), close);
    const char base = to_upper(ig::cnc::at(text_, begin + 1));
    std::uint32_t n = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n, base == 'H' ? 16 : 2);
    at_ = std::min(close + 1, text_.size());
    if ((base != 'H' && base != 'B') || error != std::errc{} || end != digits.data() + digits.size())
      return fail(ig::diag("SIE-0101"), begin, shown(begin));
    return Value::integer(n);
  }
  const ig::Decimal d = ig::read_decimal(text_, at_);
  at_ = std::max(d.end, begin + 1);
  if (!d.ok) return fail(ig::diag("SIE-0101"), begin, shown(begin));
  double value = d.value;
  bool is_whole = !d.has_point;
  if (equals_ignoring_case(text_.substr(at_, 2), "EX")) {
    const ig::Decimal power = ig::read_decimal(text_, at_ + 2);
    if (power.ok) {
      at_ = power.end;
      value *= std::pow(10, std::clamp(power.value, -400.0, 400.0));
      is_whole = false;
    }
  }
  if (!std::isfinite(value)) return fail(ig::diag("SIE-0105"), begin, shown(begin));
  return is_whole ? Value::integer(value) : Value::real(value);
}

bool Expression::indices(std::string& name) {
  const std::size_t open = at_;
  ++at_;
  name += '[';
  for (;;) {
    skip_blanks();
    const std::size_t begin = at_, end = skip_name(text_, at_);
    const char behind = ig::cnc::at(text_, ig::cnc::skip_blanks(text_, end));
    const std::string word = upper(ig::cnc::piece(text_, begin, end));
    const bool stands_alone = !word.empty() && word.size() <= 2 && (behind == ',' || behind == ']');
    const bool names_axis = stands_alone && std::string_view("ABCUVWXYZ").find(word[0]) != std::string_view::npos &&
                            environment_.store().find(word) == nullptr;
    const bool is_axis =
        names_axis || (stands_alone && name[0] == '$' && is_letter(word[0]) && (word[0] != 'R' || word == "RT"));
    if (is_axis) {  // $AA_IM[X]
      name += word;
      at_ = end;
    } else {
      if (++depth_ > deepest) {
        fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
        return false;
      }
      const auto index = level(loosest);
      --depth_;
      if (!index) return false;
      if (index->is_text()) {
        name += index->text;
      } else if (!(std::fabs(index->number) < 1e9)) {
        fail(ig::diag("SIE-0104"), open, name);
        return false;
      } else {
        name += std::to_string(static_cast<std::int64_t>(std::round(index->number)));
      }
    }
    skip_blanks();
    if (peek() == ',') {
      name += ',';
      ++at_;
      continue;
    }
    if (peek() != ']') {
      fail(ig::diag("SIE-0102"), open);
      return false;
    }
    ++at_;
    name += ']';
    return true;
  }
}

std::optional<Expression::Reference> Expression::reference() {
  Reference out;
  out.begin = at_;
  if (peek() == '$') ++at_;
  at_ = skip_name(text_, at_);
  std::string name = upper(ig::cnc::piece(text_, out.begin, at_));
  if (name.starts_with("$R") && (name.size() == 2 || is_digit(name[2]))) name.erase(0, 1);
  const bool has_number = name.size() > 1 && name[0] == 'R' && skip_digits(name, 1) == name.size();
  if (const std::size_t open = ig::cnc::skip_blanks(text_, at_); ig::cnc::at(text_, open) == '[') {
    at_ = open;
    if (!indices(name)) return std::nullopt;
  }
  out.end = at_;
  out.is_r = has_number || name.starts_with("R[");
  if (out.is_r) {
    std::uint32_t number = 0;
    const char* const first = name.data() + (has_number ? 1 : 2);
    const auto [end, error] = std::from_chars(first, name.data() + name.size(), number);
    if (error != std::errc{} || environment_.store().r(number) == nullptr)
      return fail(ig::diag("SIE-0104"), out.begin, std::string_view(name));
    out.r = number;
    name = "R" + std::to_string(number);
  }
  out.name = std::move(name);
  return out;
}

std::optional<Value> Expression::read(const Reference& r) {
  VariableStore& store = environment_.store();
  environment_.enter(b_);
  if (r.is_r) {
    VariableStore::RParameter& p = *store.r(r.r);
    if (!p.is_given && store.say_once(r.name))
      b_.report(ig::diag("SIE-0112"), ig::Where::columns(r.begin, r.end), std::string_view(r.name));
    return Value::real(p.value);
  }
  if (const Variable* const v = store.find(r.name)) return v->value;
  const std::size_t bracket = r.name.find('[');
  if (bracket != std::string::npos) {
    const std::string base = r.name.substr(0, bracket);
    if (const Variable* const array = store.find(base); array != nullptr && array->is_array) {
      at_ = r.end;
      if (!array->sizes.empty() && !array->number_of(std::string_view(r.name).substr(bracket)))
        return fail(ig::diag("SIE-0304"), r.begin, std::string_view(r.name), std::string_view(array->shown_as(base)));
      return array->value;
    }
  }
  if (const auto n = store.given(r.name)) return Value::real(*n);
  if (r.name == "$PI") return Value::real(std::numbers::pi);
  if (r.name[0] == '$')
    if (const auto n = environment_.system.read(b_, r.name)) return Value::real(*n);
  at_ = r.end;
  const auto where = ig::Where::columns(r.begin, r.end);
  if (!failed_ && r.name[0] == '$')
    environment_.report_once(b_, ig::diag("SIE-0110"), where, r.begin, std::string_view(r.name));
  else if (!failed_)
    environment_.report_name(b_, ig::diag("SIE-0111"), where, r.name);
  failed_ = true;
  return std::nullopt;
}

/// True for functions that ask a running control about tools, curves, axes, files and protection zones.
static bool asks_control(std::string_view name) {
  for (const std::string_view known :
       {"GETT",     "GETACTT",  "GETACTTD",   "GETDNO",     "GETEXET",    "GETSELT", "GETTCOR",  "NEWT",    "CHKDNO",
        "CTAB",     "CTABINV",  "CTABTSV",    "CTABTEV",    "CTABTSP",    "CTABTEP", "CTABSSV",  "CTABSEV", "CTABTMIN",
        "CTABTMAX", "CTABID",   "CTABEXISTS", "CTABPERIOD", "CTABISLOCK", "ISFILE",  "CALCPOSI", "GETTENV", "TCARR",
        "MODAXVAL", "POSRANGE", "SPI",        "AXTOSPI",    "GETTCOR",    "LENTOAX", "STRINGIS", "COLLPAIR"})
    if (known == name) return true;
  return false;
}

std::optional<Value> Expression::call(const std::string& name, std::size_t begin) {
  struct Function {
    std::string_view name;
    std::size_t least, most;
  };
  static constexpr Function functions[] = {
      {"SIN", 1, 1},    {"COS", 1, 1},     {"TAN", 1, 1},     {"ASIN", 1, 1},   {"ACOS", 1, 1},  {"ATAN2", 2, 2},
      {"SQRT", 1, 1},   {"ABS", 1, 1},     {"POT", 1, 1},     {"TRUNC", 1, 1},  {"ROUND", 1, 1}, {"ROUNDUP", 1, 1},
      {"LN", 1, 1},     {"EXP", 1, 1},     {"MINVAL", 2, 2},  {"MAXVAL", 2, 2}, {"BOUND", 3, 3}, {"STRLEN", 1, 1},
      {"NUMBER", 1, 1}, {"TOUPPER", 1, 1}, {"TOLOWER", 1, 1}, {"AXNAME", 1, 1}};
  const auto* const f = std::find_if(std::begin(functions), std::end(functions),
                                     [&](const Function& known) { return known.name == name; });
  if (f == std::end(functions)) {
    at_ = skip_call(text_, at_);
    return fail(asks_control(name) ? ig::diag("SIE-0321") : ig::diag("SIE-0109"), begin, std::string_view(name));
  }
  if (++depth_ > deepest) return fail(ig::diag("SIE-0103"), begin, static_cast<double>(deepest));
  const std::size_t open = at_++;
  std::array<Value, 3> v;
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
  const bool wants_text =
      name == "STRLEN" || name == "NUMBER" || name == "TOUPPER" || name == "TOLOWER" || name == "AXNAME";
  for (std::size_t i = 0; i < count; ++i)
    if (v[i].is_text() != wants_text) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  if (name == "TOUPPER" || name == "AXNAME") return Value::string(upper(v[0].text));
  if (name == "TOLOWER") {
    for (char& c : v[0].text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
    return Value::string(v[0].text);
  }
  const double x = v[0].number, y = v[1].number;
  double out = 0;
  if (name == "SIN") out = std::sin(std::remainder(x, 360) * radians_per_degree);
  if (name == "COS") out = std::cos(std::remainder(x, 360) * radians_per_degree);
  if (name == "SIN" || name == "COS") {  // quarter turns are exact
    const double quarter = std::remainder(name == "SIN" ? x : x + 90, 360);
    if (quarter == 0 || std::fabs(quarter) == 180) out = 0;
    if (quarter == 90) out = 1;
    if (quarter == -90) out = -1;
  }
  if (name == "TAN") {
    if (std::fabs(std::remainder(x, 180)) == 90) return fail(ig::diag("SIE-0106"), begin, shown(begin));
    out = std::tan(std::remainder(x, 180) * radians_per_degree);
  }
  if (name == "ASIN") out = std::asin(x) / radians_per_degree;
  if (name == "ACOS") out = std::acos(x) / radians_per_degree;
  if (name == "ATAN2") out = std::atan2(x, y) / radians_per_degree;
  if (name == "SQRT") out = std::sqrt(x);
  if (name == "ABS") out = std::fabs(x);
  if (name == "POT") out = x * x;
  if (name == "TRUNC") out = std::trunc(x);
  if (name == "ROUND") out = std::round(x);
  if (name == "ROUNDUP") out = std::ceil(x);
  if (name == "LN") out = x > 0 ? std::log(x) : std::nan("");
  if (name == "EXP") out = std::exp(x);
  if (name == "MINVAL") out = std::fmin(x, y);
  if (name == "MAXVAL") out = std::fmax(x, y);
  if (name == "BOUND") out = std::fmin(std::fmax(v[2].number, x), y);
  if (name == "STRLEN") out = static_cast<double>(v[0].text.size());
  if (name == "NUMBER") {
    const ig::Decimal d = ig::read_decimal(v[0].text, ig::cnc::skip_blanks(v[0].text, 0));
    if (!d.ok) return fail(ig::diag("SIE-0106"), begin, shown(begin));
    out = d.value;
  }
  if (!std::isfinite(out)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
  return Value::real(out + 0.0);
}

std::optional<Value> Expression::apply(std::string_view op, const Value& l, const Value& r, std::size_t begin) {
  if (op == "<<") {
    std::string joined = text_of(l) + text_of(r);
    if (joined.size() > 4096) return fail(ig::diag("SIE-0105"), begin, std::string_view("<<"));
    return Value::string(std::move(joined));
  }
  if (l.is_text() && r.is_text()) {
    if (op == "==") return Value::truth(l.text == r.text);
    if (op == "<>") return Value::truth(l.text != r.text);
  }
  if (l.is_text() || r.is_text()) return fail(ig::diag("SIE-0107"), begin, shown(begin));
  const double a = l.number, c = r.number;
  if (op == "==") return Value::truth(a == c);
  if (op == "<>") return Value::truth(a != c);
  if (op == "<") return Value::truth(a < c);
  if (op == ">") return Value::truth(a > c);
  if (op == "<=") return Value::truth(a <= c);
  if (op == ">=") return Value::truth(a >= c);
  if (op == "AND") return Value::truth(a != 0 && c != 0);
  if (op == "OR") return Value::truth(a != 0 || c != 0);
  if (op == "XOR") return Value::truth((a != 0) != (c != 0));
  if (op.starts_with("B_")) {
    if (!is_bits(a) || !is_bits(c)) return fail(ig::diag("SIE-0106"), begin, shown(begin));
    const auto x = static_cast<std::int64_t>(a), y = static_cast<std::int64_t>(c);
    return Value::integer(static_cast<double>(op == "B_AND" ? x & y : op == "B_OR" ? x | y : x ^ y));
  }
  if ((op == "/" || op == "DIV" || op == "MOD") && c == 0) return fail(ig::diag("SIE-0307"), begin, shown(begin));
  const bool whole = l.type != Type::real && r.type != Type::real;
  double out = 0;
  if (op == "+") out = a + c;
  if (op == "-") out = a - c;
  if (op == "*") out = a * c;
  if (op == "/") out = a / c;
  if (op == "DIV") out = std::trunc(a / c);
  if (op == "MOD") out = std::fmod(a, c);
  if (!std::isfinite(out)) return fail(ig::diag("SIE-0105"), begin, shown(begin));
  const bool is_whole = op == "DIV" || op == "MOD" || (whole && op != "/");
  return is_whole ? Value::integer(out) : Value::real(out);
}

}  // namespace siemens
