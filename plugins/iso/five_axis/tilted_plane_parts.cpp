/// A plane of several blocks: three points (P2) or two vectors (P3), until the last of them has come.
#include "five_axis/tilted_plane.hpp"

#include <algorithm>
#include <cmath>

#include <isogloss/cnc/units.hpp>
#include <isogloss/cnc/whole_number.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

constexpr double widest_from_square = 5;  // degrees, of the vectors of P3

}  // namespace

void TiltedPlane::by_parts(ig::Block& b, std::size_t row, std::int64_t p) const {
  const auto q_word = take_word(b, row, 'Q');
  const auto q = whole_number(q_word.value_or(0));
  if (!q || *q > (p == 2 ? 3 : 2) || (p == 3 && *q == 0)) {
    no_such_q(b, row, p, q_word.value_or(0));
    return;
  }
  const auto part = static_cast<std::size_t>(*q);
  const ig::Xyz& known = p == 2 ? points_[part] : vectors_[part - 1];
  if (b.get(known).complete())
    b.report(ig::diag("ISO-0426"), at(row), b.text(tilt_.name(row)), static_cast<double>(p), static_cast<double>(*q));
  b.set(open_p_, p);
  b.set(open_term_, tilt_.name(row));
  if (p == 3 && part == 1) b.set(points_[1], origin_words(b, row));
  b.set(known, take_words(b, row, p == 2 ? "XYZ" : "IJK").or_else({}));
  if (p == 2 && part == 0)
    if (const auto turn = take_word(b, row, 'R')) b.set(open_turn_, *turn);
  if (missing(b).empty()) finish(b, row, p);
}

std::string_view TiltedPlane::missing(const ig::Block& b) const {
  if (b.get_or(open_p_, std::int64_t{0}) == 2) {
    if (!b.get(points_[1]).complete()) return "Q1";
    if (!b.get(points_[2]).complete()) return "Q2";
    return b.get(points_[3]).complete() ? "" : "Q3";
  }
  if (!b.get(vectors_[0]).complete()) return "Q1";
  return b.get(vectors_[1]).complete() ? "" : "Q2";
}

void TiltedPlane::finish(ig::Block& b, std::size_t row, std::int64_t p) const {
  const double turn = b.get_or(open_turn_, 0.0);
  const bool is_turned = b.has(open_turn_);
  const bool is_square = are_square(b, row);
  const auto plane = p == 2 ? through_points(b, turn) : along_vectors(b);
  forget_parts(b);
  if (!is_square) return;
  if (!plane) {
    alarm(b, ig::diag("ISO-0431"), at(row), b.text(tilt_.name(row)), static_cast<double>(p),
          std::string_view(p == 2 ? "points" : "vectors"));
    return;
  }
  if (!put_in_force(b, row, *plane)) return;
  write(b, row, origin(*plane), p);
  if (is_turned) b.set(turn_, turn);
}

std::optional<Mat4> TiltedPlane::through_points(const ig::Block& b, double turn) const {
  const ig::Vec3 first = b.get(points_[1]).value, shift = b.get(points_[0]).or_else({});
  const auto plane = from_x_and_side(b.get(points_[2]).value - first, b.get(points_[3]).value - first);
  if (!plane) return std::nullopt;
  const bool is_origin = q0_ == Q0::origin && b.get(points_[0]).complete();
  if (is_origin) return at_origin(product(turn_about(2, turn), *plane), shift);
  return product(at_origin(turn_about(2, turn), shift), at_origin(*plane, first));
}

std::optional<Mat4> TiltedPlane::along_vectors(const ig::Block& b) const {
  const auto plane = from_z_and_x(b.get(vectors_[1]).value, b.get(vectors_[0]).value);
  return plane ? std::optional(at_origin(*plane, b.get(points_[1]).or_else({}))) : std::nullopt;
}

bool TiltedPlane::are_square(ig::Block& b, std::size_t row) const {
  const auto x = unit(b.get(vectors_[0]).value), z = unit(b.get(vectors_[1]).value);
  if (!x || !z) return true;
  const double angle = std::acos(std::clamp(scalar_product(*x, *z), -1.0, 1.0)) * degrees_per_radian;
  constexpr double rounding = 1e-9;
  if (std::fabs(angle - 90) <= widest_from_square + rounding) return true;
  alarm(b, ig::diag("ISO-0432"), at(row), b.text(tilt_.name(row)), angle);
  return false;
}

bool TiltedPlane::moves(const ig::Block& b) const {
  ig_value unused[3];
  return b.find(movers_) || b.find(program_end_) || b.get_many(words_.ids(), 3, unused) != 0 ||
         b.get_many(rotary_words_.data(), 3, unused) != 0;
}

void TiltedPlane::give_up(ig::Block& b) const {
  alarm(b, ig::diag("ISO-0425"), ig::Where::block(), b.text(b.get_or(open_term_, ig::Symbol{})),
        static_cast<double>(b.get_or(open_p_, std::int64_t{0})), missing(b));
  forget_parts(b);
}

void TiltedPlane::forget_parts(ig::Block& b) const {
  b.erase(open_p_);
  b.erase(open_term_);
  b.erase(open_turn_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const ig::Xyz& point : points_) b.erase(point.id(axis));
    for (const ig::Xyz& vector : vectors_) b.erase(vector.id(axis));
  }
}

}  // namespace iso
