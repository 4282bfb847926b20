/// Values in a program: numbers, Q parameters, formulas. Angles in degrees.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

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

  /// QS5 at a position; ~0 stands for a number that is too large.
  static std::optional<std::uint32_t> text_parameter_at(std::string_view text, std::size_t position, std::size_t& end) {
    if (to_upper(at(text, position)) != 'Q' || to_upper(at(text, position + 1)) != 'S') return std::nullopt;
    const std::size_t digits = skip_blanks(text, position + 2), last = skip_digits(text, digits);
    if (last == digits) return std::nullopt;
    end = last;
    std::uint32_t number = 0;
    const bool is_number = std::from_chars(text.data() + digits, text.data() + last, number).ec == std::errc{};
    return is_number ? number : ~0u;
  }
  /// The text of the string parameter at a position, alive until it is set; nothing, and reported, where it has none.
  std::optional<std::string_view> text(ig::Block& b, std::string_view text, std::size_t position,
                                       std::size_t& end) const {
    const auto number = text_parameter_at(text, position, end);
    const auto held = number && b.is_in_turn() && store() != nullptr ? store()->text(*number) : std::nullopt;
    if (held && used_.is_heard()) used_.read(b, "QS" + std::to_string(*number), *held);
    if (!held) b.report(ig::diag("HEI-0371"), ig::Where::columns(position, end), piece(text, position, end));
    return held;
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
    return s != nullptr && b.is_in_turn() && QStore::exists(q) && !std::isnan(s->get(q, program(b)));
  }
  double get(ig::Block& b, const QNumber& q, std::string_view name, ig::Where where) const {
    const QStore* const s = store();
    if (!b.is_in_turn()) return 0;
    if (s == nullptr || !QStore::exists(q)) {
      b.report(ig::diag("HEI-0114"), where, name);
      return 0;
    }
    const double value = s->get(q, program(b));
    if (rows_.is_heard())
      if (const std::string* const row = s->row_of(q)) rows_.add(b, *row);
    if (used_.is_heard()) used_.read(b, name_of(q).data(), value, scope(b, q));
    if (!std::isnan(value)) return value;
    if (!store()->is_first_time(115, name)) return 0;
    const bool is_radius = q.number == QStore::radius_of_tool, is_length = q.number == QStore::length_of_tool;
    if (q.kind == QKind::q && (is_radius || is_length))
      b.report(ig::diag("HEI-0390"), where, name, std::string_view(is_radius ? "radius" : "length"));
    else
      b.report(ig::diag("HEI-0115"), where, name);
    return 0;
  }
  void set(ig::Block& b, const QNumber& q, std::string_view name, ig::Where where, double value) const {
    QStore* const s = store();
    if (used_.is_heard()) used_.wrote(b, name_of(q).data(), value, scope(b, q));
    if (s != nullptr && QStore::exists(q))
      s->set(q, program(b), value);
    else
      b.report(ig::diag("HEI-0114"), where, name);
  }

  /// A statement other than an assignment has set the parameter: TOOL CALL, PLANE.
  void note(ig::Block& b, std::uint32_t number, double value) const {
    if (used_.is_heard()) used_.wrote(b, name_of({QKind::q, number}).data(), value);
  }
  void note_text(ig::Block& b, std::uint32_t number, std::string_view text) const {
    if (used_.is_heard()) used_.wrote(b, "QS" + std::to_string(number), text);
  }
  /// A condition, as the program writes it, has been examined; or a reason in words.
  const ig::ExaminedConditions& examined() const { return examined_; }

  /// What {Q240} is in a row of MachineCodes; nothing where the name is no parameter with a value.
  std::optional<double> in_row(ig::Block& b, std::string_view name, ig::Where where) const {
    std::size_t end = 0;
    const auto q = q_at(name, 0, end);
    return q && end == name.size() && has(b, *q) ? std::optional(get(b, *q, name, where)) : std::nullopt;
  }

  /// Text in brackets is a comment on other controls and in simulators: it is reported once.
  void report_brackets(ig::Block& b, ig::Where where) const {
    if (QStore* const s = store(); b.is_in_turn() && (s == nullptr || s->is_first_time(0, "(")))
      b.report(ig::diag("HEI-0189"), where);
  }

  /// A formula to the end of its statement; nothing, with a diagnostic, where it has no result.
  std::optional<double> formula(ig::Block& b, std::string_view text, std::size_t position, std::size_t end) const;

 private:
  /// The value without signs before it.
  Value operand(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t end = position;
    if (const auto q = q_at(text, position, end))
      return {is_indexing() ? 0 : get(b, *q, piece(text, position, end), ig::Where::columns(position, end)), end, true};
    const ig::Decimal d = read_number(text, position);
    return {d.value, d.end, d.ok && d.end > position};
  }

  static std::array<char, 16> name_of(const QNumber& q) {
    std::array<char, 16> out{'Q'};
    std::size_t size = 1;
    if (q.kind != QKind::q) out[size++] = q.kind == QKind::local ? 'L' : 'R';
    std::to_chars(out.data() + size, out.data() + out.size() - 1, q.number);
    return out;
  }
  std::uint64_t scope(const ig::Block& b, const QNumber& q) const { return q.kind == QKind::local ? program(b) : 0; }

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

  ig::Service<QStore> store_{q_store_service, ig::Need::required, "The Q parameters."};
  ig::AnsweredRows rows_{q_store_service};
  ig::UsedVariables used_;
  ig::ExaminedConditions examined_;
  ig::Flow flow_;
};

}  // namespace heidenhain
