/// DEP: how the tool departs from the contour, from the tool centre's position at its last point, to the side of RL or
/// RR. Lengths in mm, angles in degrees.
#pragma once

#include "frames/scaling.hpp"
#include "motion/klartext_departure.hpp"
#include "motion/klartext_way.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that makes a path of the words.
class DeparturePath {
 public:
  /// The field that a block with DEP has.
  ig_field shape() const { return words_.shape(); }
  /// The words of DEP; nothing where the block has none.
  std::optional<KlartextDeparture::Way> words(const ig::Block& b) const { return words_.get(b); }

  /// Changes the end point of `way`, and sets the departure that ends with an arc. `tangent` is the direction of the
  /// path before. False, with a diagnostic, where the tool leaves straight.
  bool follow(ig::Block& b, KlartextWay& way, const KlartextDeparture::Way& words,
              const ig::PartialVec3& tangent) const;

 private:
  KlartextDeparture words_{ig::read};
  ContourDeparture leave_{ig::write};
  ig::In<ig::Symbol> side_{"RadiusCompensation.Term"};
  ig::In<double> tool_radius_{"RadiusCompensation.Radius_mm"};
  ig::Name g41_{"G41"}, g42_{"G42"};
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ScalingInForce scaling_;
};

}  // namespace heidenhain
