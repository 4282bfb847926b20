/// G68.2 and G68.4 by angles, and how a plane comes into force and ends.
#include "five_axis/tilted_plane.hpp"

#include <isogloss/cnc/whole_number.hpp>

namespace iso {

using namespace ig::cnc;

ig::Status TiltedPlane::build(ig::Block& b) {
  const auto row = b.find(tilt_);
  const bool ends = b.take(g69_).has_value();
  const bool ends_last = ends && (!row || ordinal(b, g69_.id(0)) > ordinal(b, tilt_.code(*row)));
  if (row && ends)
    b.report(ig::diag("ISO-0201"), ig::Where::word(tilt_.code(*row)), b.text(ends_last ? g69_name_ : tilt_.name(*row)));
  const bool is_rotated_anew = ends && b.find(rotation_) && ordinal(b, rotation_.code(0)) > ordinal(b, g69_.id(0));
  if (is_rotated_anew)
    forget_tilt(b);
  else if (ends)
    cancel(b);
  const bool gives_up = b.has(open_p_) && (ends || moves(b));
  if (gives_up) give_up(b);
  if (row && ends_last)
    drop(b, *row);
  else if (row)
    define(b, *row);
  if (!row && !ends && is_tilted(b.get_or(term_before_, ig::Symbol{}))) warn_of_changes(b);
  return row || ends || gives_up ? ig::Status::changed : ig::Status::unchanged;
}

void TiltedPlane::define(ig::Block& b, std::size_t row) const {
  take_code(b, row);
  const auto cycle = b.get(cycle_);
  if (cycle && *cycle != g80_ && !b.find(cycle_end_))
    b.report(ig::diag("ISO-0434"), at(row), b.text(tilt_.name(row)), b.text(*cycle));
  for (const auto& term : geometry_)
    if (const auto code = b.get(term)) b.report(ig::diag("ISO-0383"), at(row), b.text(tilt_.name(row)), b.text(*code));
  const auto p_word = row == by_tool ? std::nullopt : take_word(b, row, 'P');
  const auto p = whole_number(p_word.value_or(0));
  if (!p || *p > 4) {
    alarm(b, ig::diag("ISO-0421"), at(row, 'P'), b.text(tilt_.name(row)), p_word.value_or(0));
    drop(b, row);
    return;
  }
  if (b.has(open_p_) && (b.get(open_p_) != p || !b.is(open_term_, tilt_.name(row)))) give_up(b);
  if (row == by_tool)
    by_tool_axis(b);
  else if (*p == 2 || *p == 3)
    by_parts(b, row, *p);
  else
    by_angles(b, row, *p);
}

void TiltedPlane::by_angles(ig::Block& b, std::size_t row, std::int64_t p) const {
  double order = 123;
  if (p == 1) order = take_word(b, row, 'Q').value_or(order);
  const auto axes = axes_of(order);
  if (!axes) {
    no_such_q(b, row, p, order);
    return;
  }
  const ig::Vec3 angles = take_words(b, row, "IJK").or_else({});
  const ig::Vec3 at_point = origin_words(b, row);
  const auto turned = p == 0   ? euler_zxz(angles)
                      : p == 1 ? roll_pitch_yaw(angles, *axes, turns_)
                               : from_projections(angles);
  if (!turned) {
    alarm(b, ig::diag("ISO-0431"), at(row), b.text(tilt_.name(row)), static_cast<double>(p),
          std::string_view("angles"));
    return;
  }
  if (!put_in_force(b, row, at_origin(*turned, at_point))) return;
  write(b, row, at_point, p);
  for (std::size_t i = 0; i < 3; ++i) b.set(angles_[i], angles[i]);
  if (p == 1) b.set(q_, static_cast<std::int64_t>(order));
}

std::optional<std::array<std::size_t, 3>> TiltedPlane::axes_of(double order) {
  constexpr std::array orders{123, 132, 213, 231, 312, 321};
  for (const int known : orders) {
    if (order != known) continue;
    const auto digit = [known](int by) { return static_cast<std::size_t>(known / by % 10 - 1); };
    return std::array{digit(100), digit(10), digit(1)};
  }
  return std::nullopt;
}

ig::Vec3 TiltedPlane::origin_words(ig::Block& b, std::size_t row) const {
  const ig::PartialVec3 named = take_words(b, row, "XYZ");
  if (unnamed_ == Unnamed::zero || named.complete()) return named.or_else({});
  const ig::Vec3 here = last_(b);
  return named.or_else(row == inside ? here : rounded(mapped(frame_.get(b), here)));
}

void TiltedPlane::no_such_q(ig::Block& b, std::size_t row, std::int64_t p, double q) const {
  alarm(b, ig::diag("ISO-0429"), at(row, 'Q'), b.text(tilt_.name(row)), static_cast<double>(p), q);
  drop(b, row);
}

bool TiltedPlane::put_in_force(ig::Block& b, std::size_t row, const Mat4& plane) const {
  const ig::Symbol before = b.get_or(term_, ig::Symbol{});
  const bool replaces = is_tilted(before) || before == g68_;
  const Mat4 m = row == inside ? product(plane, frame_.get(b)) : plane;
  if (!is_finite(m)) {
    alarm(b, ig::diag("ISO-0423"), at(row), b.text(tilt_.name(row)));
    return false;
  }
  if (row == inside && !replaces) b.report(ig::diag("ISO-0427"), at(row));
  if (row != inside && replaces) b.report(ig::diag("ISO-0422"), at(row), b.text(tilt_.name(row)), b.text(before));
  forget_plane(b);
  frame_.set(b, m);
  return true;
}

void TiltedPlane::write(ig::Block& b, std::size_t row, const ig::Vec3& at_point, std::int64_t p) const {
  b.set(term_, tilt_.name(row));
  b.set(origin_, at_point);
  if (p != 0) b.set(p_, p);
}

void TiltedPlane::cancel(ig::Block& b) const {
  forget_plane(b);
  b.set(term_, g69_name_);
  frame_.set(b, identity_frame);
}

void TiltedPlane::forget_plane(ig::Block& b) const {
  forget_tilt(b);
  for (std::size_t axis = 0; axis < 3; ++axis) b.erase(origin_.id(axis));
  b.erase(turn_);
  b.erase(about_tool_);
}

void TiltedPlane::forget_tilt(ig::Block& b) const {
  if (b.get_or(is_aligned_, false))
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(orientation_.id(axis));
  for (const auto& angle : angles_) b.erase(angle);
  b.erase(p_);
  b.erase(q_);
  b.erase(is_aligned_);
}

void TiltedPlane::warn_of_changes(ig::Block& b) const {
  if (offset_change_ == OffsetChange::allowed) return;
  if (const auto set = b.find(changes_))
    b.report(ig::diag("ISO-0424"), ig::Where::word(changes_.id(*set)), b.text(changes_.name(*set)));
  if (const auto code = b.find(changes_with_words_))
    b.report(ig::diag("ISO-0424"), ig::Where::word(changes_with_words_.code(*code)),
             b.text(changes_with_words_.name(*code)));
}

std::optional<double> TiltedPlane::take_word(ig::Block& b, std::size_t row, char letter) const {
  ig_value v;
  if (!b.take(tilt_.word(row, letter), v)) return std::nullopt;
  return v.number;
}

ig::PartialVec3 TiltedPlane::take_words(ig::Block& b, std::size_t row, std::string_view letters) const {
  ig::PartialVec3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto word = take_word(b, row, letters[i]);
    if (!word) continue;
    out.mask |= 1u << i;
    out.value[i] = *word;
  }
  return out;
}

void TiltedPlane::drop(ig::Block& b, std::size_t row) const {
  take_code(b, row);
  ig_value unused[32];
  b.take_many(tilt_.row(row), static_cast<std::uint32_t>(tilt_.letters().size()), unused);
}

void TiltedPlane::take_code(ig::Block& b, std::size_t row) const {
  const ig_field code = tilt_.code(row);
  b.take_code(&code, 1);
}

}  // namespace iso
