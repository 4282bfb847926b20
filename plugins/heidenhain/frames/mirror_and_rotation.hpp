/// Cycles 8 and 10: the mirror image and the rotation, each of which changes the sense of the other. Angles in degrees;
/// positions are byte offsets into the text of the block.
#pragma once

#include <isogloss/cnc/plane.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// Whether axes are mirrored in place of those in force, or in addition to them.
enum class Mirroring { anew, further };

/// A member of the syntax that executes the cycles. `where` is the statement, for words and diagnostics.
class MirrorAndRotation {
 public:
  /// Mirrors the axes that the text names from `position` on about the datum; without axes the mirror image ends.
  void mirror(ig::Block& b, std::string_view text, std::size_t position, ig::Where where, Mirroring which) const;

  /// A rotation about the datum by `angle`, in the plane; 0 ends it.
  void turn(ig::Block& b, ig::Where where, double angle) const;
  /// Adds to the rotation in force.
  void turn_further(ig::Block& b, ig::Where where, double step) const;

  /// Ends mirror image and rotation; a tilted plane stays in force.
  void end(ig::Block& b, ig::Where where) const;

 private:
  bool is_mirrored_in_plane(const ig::Block& b) const;

  ig::Call rotation_{{"G68"}, "X Y Z R[deg]", ig::write};
  ig::Codes rotation_end_{{"G69"}, ig::write};
  ig::Field<bool> mirrored_rotation_{"KlartextRotation.IsMirrored",
                                     ig::read | ig::write,
                                     {ig::Life::modal, "", "The rotation was defined in a mirror image."}};
  ig::Call mirror_{{"G50.1", "G51.1"}, "X Y Z", ig::write};
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Xyz mirror_image_{"MirrorImage", ig::read};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::In<double> turned_{"TiltTransform.R"};
  ig::Field<double> turned_in_plane_{"PlaneFrame.R", ig::previous, {ig::Life::modal, "deg", ""}};
  ig::Field<double> plane_rotation_{"Parsing.PLANE_ROTATION", ig::write, {ig::Life::word, "deg", ""}};
  PlaneInForce plane_;
  ig::Name g68_{"G68"}, g68_2_{"G68.2"};
};

}  // namespace heidenhain
