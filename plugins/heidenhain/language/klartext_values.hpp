/// Values in a program: numbers, Q parameters, formulas. Angles in degrees.
#pragma once

#include <charconv>
#include <numbers>
#include <optional>

#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "language/klartext_text.hpp"
#include "language/q_store.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A value read at a position; `end` is the position itself where there is no value.
struct Value {
  double number = 0;
  std::size_t end = 0;
  bool ok = false;
};

/// A member of each syntax that reads values.
class Values {
 public:
  bool is_indexing() const { return flow_.is_indexing(); }
  const ig::Flow& flow() const { return flow_; }
  QStore* store() const { return const_cast<QStore*>(store_.operator->()); }

  /// Q5, QL1 or QR3 at a position. QS parameters hold texts and are not read here.
  static std::optional<QNumber> q_at(std::string_view text, std::size_t position, std::size_t& end) {
    if (to_upper(at(text, position)) != 'Q') return std::nullopt;
    QNumber q;
    std::size_t digits = position + 1;
    if (const char kind = to_upper(at(text, digits)); kind == 'L' || kind == 'R') {
      q.kind = kind == 'L' ? QKind::local : QKind::retained;
      ++digits;
    }
    digits = skip_blanks(text, digits);
    end = skip_digits(text, digits);
    if (end == digits) return std::nullopt;
    const char* const last = text.data() + end;
    if (std::from_chars(text.data() + digits, last, q.number).ec != std::errc{}) q.number = ~0u;
    return q;
  }

  /// A number or a Q parameter, with any number of signs before it.
  Value read(ig::Block& b, std::string_view text, std::size_t position) const {
    bool negative = false;
    std::size_t i = position;
    for (;; ++i) {
      if (at(text, i) == '-')
        negative = !negative;
      else if (at(text, i) != '+' && !is_blank(at(text, i)))
        break;
    }
    Value v = operand(b, text, i);
    if (!v.ok) v.end = position;
    if (negative) v.number = -v.number;
    return v;
  }

  /// True when the parameter has a value.
  bool has(ig::Block& b, const QNumber& q) const {
    const QStore* const s = store();
    return s != nullptr && QStore::exists(q) && !std::isnan(s->get(q, program(b)));
  }
  double get(ig::Block& b, const QNumber& q, std::string_view name, ig::Where where) const {
    const QStore* const s = store();
    if (s == nullptr || !QStore::exists(q)) {
      b.report(ig::diag("HEI-0114"), where, name);
      return 0;
    }
    const double value = s->get(q, program(b));
    if (!std::isnan(value)) return value;
    if (store()->is_first_time(115, name)) b.report(ig::diag("HEI-0115"), where, name);
    return 0;
  }
  void set(ig::Block& b, const QNumber& q, std::string_view name, ig::Where where, double value) const {
    QStore* const s = store();
    if (s != nullptr && QStore::exists(q))
      s->set(q, program(b), value);
    else
      b.report(ig::diag("HEI-0114"), where, name);
  }

  /// Text in brackets is a comment on other controls and in simulators: it is reported once.
  void say_brackets(ig::Block& b, ig::Where where) const {
    if (QStore* const s = store(); s == nullptr || s->is_first_time(0, "(")) b.report(ig::diag("HEI-0189"), where);
  }

  /// A formula to the end of its statement; nothing, with a diagnostic, where it has no result.
  std::optional<double> formula(ig::Block& b, std::string_view text, std::size_t position, std::size_t end) const {
    Parser parser{*this, b, text.substr(0, end), position, 0, false};
    const double result = parser.sum();
    if (parser.failed) return std::nullopt;
    parser.position = skip(parser.text, parser.position);
    if (parser.position < end) {
      if (parser.text[parser.position] == ')')
        b.report(ig::diag("HEI-0110"), ig::Where::columns(parser.position, parser.position + 1), std::string_view(")"));
      else
        parser.no_value();
      return std::nullopt;
    }
    if (std::isfinite(result)) return result + 0.0;
    b.report(ig::diag("HEI-0113"), ig::Where::columns(position, end), trim(piece(text, position, end)));
    b.alarm();
    return std::nullopt;
  }

 private:
  /// The value without signs before it.
  Value operand(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t end = position;
    if (const auto q = q_at(text, position, end))
      return {is_indexing() ? 0 : get(b, *q, piece(text, position, end), ig::Where::columns(position, end)), end, true};
    const ig::Decimal d = read_number(text, position);
    return {d.value, d.end, d.ok && d.end > position};
  }

  /// QL parameters belong to a program, not to its labels.
  std::uint64_t program(const ig::Block& b) const {
    ig_frame frame = flow_.frame(b);
    while (frame.tag == called_label && frame.depth > 0) {
      const auto below = flow_.frame(b, frame.depth - 1);
      if (!below) break;
      frame = *below;
    }
    return frame.id;
  }

  static constexpr int deepest = 100;

  struct Parser {
    const Values& values;
    ig::Block& b;
    std::string_view text;
    std::size_t position;
    int depth;
    bool failed;

    double sum() {
      double left = product();
      while (!failed) {
        position = skip(text, position);
        const char c = at(text, position);
        if (c != '+' && c != '-') break;
        ++position;
        const double right = product();
        left = c == '+' ? left + right : left - right;
      }
      return left;
    }
    double product() {
      double left = power();
      while (!failed) {
        position = skip(text, position);
        const char c = at(text, position);
        const std::size_t div = keyword(text, position, "DIV");
        if (c == '*' || c == '/' || c == '%')
          ++position;
        else if (div != position)
          position = div;
        else
          break;
        const double right = power();
        if (c == '*')
          left *= right;
        else if (c == '%')
          left = std::fmod(left, right);
        else
          left /= right;
      }
      return left;
    }
    double power() {
      double left = value();
      while (!failed) {
        position = skip(text, position);
        if (at(text, position) != '^') break;
        ++position;
        const double right = value();
        left = std::pow(left, right);
      }
      return left;
    }
    double value() {
      position = skip(text, position);
      if (++depth > deepest) {
        if (!failed) b.report(ig::diag("HEI-0112"), ig::Where::columns(position, position + 1), double{deepest});
        failed = true;
      }
      if (failed) return 0;
      const double result = value_inside();
      --depth;
      return result;
    }
    double value_inside() {
      const char c = at(text, position);
      if (c == '+' || c == '-') {
        ++position;
        const double inner = value();
        return c == '-' ? -inner : inner;
      }
      if (c == '(') {
        const std::size_t open = position++;
        const double inner = sum();
        position = skip(text, position);
        if (failed) return 0;
        if (at(text, position) != ')') {
          b.report(ig::diag("HEI-0111"), ig::Where::columns(open, open + 1));
          failed = true;
          return 0;
        }
        ++position;
        return inner;
      }
      const Value v = values.operand(b, text, position);
      if (v.ok) {
        position = v.end;
        return v.number;
      }
      return function();
    }
    double function() {
      static constexpr std::array<std::string_view, 18> names{"SQRT", "SQ",   "SIN", "COS", "TAN",  "ASIN",
                                                              "ACOS", "ATAN", "ABS", "INT", "FRAC", "NEG",
                                                              "SGN",  "LN",   "LOG", "EXP", "PI",   "MOD"};
      const std::size_t end = letters_end(text, position);
      for (std::size_t i = 0; i < names.size() && end > position; ++i) {
        if (!equals_ignoring_case(piece(text, position, end), names[i])) continue;
        position = end;
        if (i == 16) return std::numbers::pi;
        return result_of(i, value());
      }
      no_value();
      return 0;
    }
    static double result_of(std::size_t function, double x) {
      switch (function) {
        case 0: return std::sqrt(x);
        case 1: return x * x;
        case 2: return std::sin(x * radians_per_degree);
        case 3: return std::cos(x * radians_per_degree);
        case 4: return std::tan(x * radians_per_degree);
        case 5: return std::asin(x) / radians_per_degree;
        case 6: return std::acos(x) / radians_per_degree;
        case 7: return std::atan(x) / radians_per_degree;
        case 8: return std::fabs(x);
        case 9: return std::trunc(x);
        case 10: return x - std::trunc(x);
        case 11: return -x;
        case 12: return x > 0 ? 1 : x < 0 ? -1 : 0;
        case 13: return std::log(x);
        case 14: return std::log10(x);
        case 15: return std::exp(x);
        default: return std::numeric_limits<double>::quiet_NaN();
      }
    }
    void no_value() {
      if (failed) return;
      failed = true;
      const std::size_t end = std::max(position + 1, skip_while(text, position, [](char c) { return !is_space(c); }));
      b.report(ig::diag("HEI-0110"), ig::Where::columns(position, end),
               text.substr(std::min(position, text.size()), end - position));
    }
  };

  ig::Service<QStore> store_{q_store_service, ig::Need::required, "The Q parameters."};
  ig::Flow flow_;
};

}  // namespace heidenhain
