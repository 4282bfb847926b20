/// The pole CC, and the words PR, PA, IPR and IPA about it. mm and degrees.
#pragma once

#include "motion/klartext_way.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that makes a path of the words.
class PolarCoordinates {
 public:
  /// False, with a diagnostic, where no pole has been programmed.
  bool is_known(ig::Block& b, const KlartextWay& way) const;
  ig::Vec3 pole(const ig::Block& b) const { return b.get(pole_).value; }
  Point2 pole(const ig::Block& b, const KlartextWay& way) const {
    const ig::Vec3 p = pole(b);
    return {p[way.plane.first], p[way.plane.second]};
  }

  /// Takes the words and makes the end point of `way` of them; false, with a diagnostic, without a pole. For CP it
  /// notes the whole circles beyond the arc.
  bool resolve(ig::Block& b, KlartextWay& way) const;

 private:
  static ig_field word(std::string_view name, const char* unit) {
    return ig::detail::declare_field({{"Parsing.", name}, IG_NUMBER, ig::take, {ig::Life::word, unit, ""}});
  }
  /// IPA may exceed a whole circle. Its sign is the sense of rotation.
  void note_circles(ig::Block& b, const KlartextWay& way, const Point2& center, double turned) const;

  std::array<ig_field, 4> words_{word("PR", "mm"), word("PA", "deg"), word("IPR", "mm"), word("IPA", "deg")};
  ig::Xyz pole_{"KlartextPath.Pole", ig::read, {ig::Life::modal, "mm", "The pole CC, in its plane."}};
  ig::In<bool> is_ccw_{"KlartextPath.IsCcw"};
  ig::Out<std::int64_t> circles_{"KlartextPath.Circles", {ig::Life::block, "", "Whole circles of CP beyond the arc."}};
  ig::Name cp_{"CP"};
};

}  // namespace heidenhain
