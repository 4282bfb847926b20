#include "frames/mirror_and_rotation.hpp"

#include "language/block_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

void MirrorAndRotation::mirror(ig::Block& b, std::string_view text, std::size_t position, ig::Where where,
                               Mirroring which) const {
  if (which == Mirroring::anew && b.has(mirror_term_)) put_code(b, mirror_.code(0), where.begin, where.end);
  // A rotation that was defined in a mirror image has been turned in the opposite sense.
  if (b.is(tilt_, g68_) && b.has(mirrored_rotation_))
    b.report(ig::diag("HEI-0161"), where, 8.0, std::string_view("the rotation in force keeps its sense"));
  const std::size_t tool = plane_(b).tool;
  for (std::size_t i = skip(text, position); i < text.size(); i = skip(text, i + 1)) {
    const std::size_t axis = std::string_view("XYZ").find(to_upper(text[i]));
    if (axis > 2 || axis == tool) {
      b.report(ig::diag("HEI-0161"), ig::Where::columns(i, i + 1), 8.0,
               std::string_view(axis > 2 ? "only X, Y and Z can be mirrored here" : "the tool axis is not mirrored"));
    } else {
      put_code(b, mirror_.code(1), i, i + 1);
      put_word(b, mirror_.row(1)[axis], i, i + 1, 0);
    }
  }
}

void MirrorAndRotation::turn(ig::Block& b, ig::Where where, double angle) const {
  const bool is_mirrored = is_mirrored_in_plane(b);
  if (b.is(tilt_, g68_2_))
    return put_word(b, plane_rotation_.id(), where.begin, where.end, is_mirrored ? -angle : angle);
  if (b.has(turned_in_plane_))
    put_word(b, plane_rotation_.id(), where.begin, where.end, 0);  // of a plane that has ended
  if (angle == 0) {
    if (b.is(tilt_, g68_)) put_code(b, rotation_end_.id(0), where.begin, where.end);
    return;
  }
  if (is_mirrored)
    b.set(mirrored_rotation_, true);
  else if (b.has(mirrored_rotation_))
    b.erase(mirrored_rotation_);
  put_code(b, rotation_.code(0), where.begin, where.end);
  const PlaneAxes plane = plane_(b);
  for (const std::size_t axis : {plane.first, plane.second})
    put_word(b, rotation_.word(0, "XYZ"[axis]), where.begin, where.end, 0);
  put_word(b, rotation_.word(0, 'R'), where.begin, where.end, angle);
}

void MirrorAndRotation::turn_further(ig::Block& b, ig::Where where, double step) const {
  const double in_force = b.is(tilt_, g68_2_) ? b.get_or(turned_in_plane_, 0.0)
                          : b.is(tilt_, g68_) ? b.get_or(turned_, 0.0)
                                              : 0;
  // IsoG68RotationSyntax turns in the opposite sense in a mirrored system, and keeps the angle that it turns.
  turn(b, where, step + (is_mirrored_in_plane(b) ? -in_force : in_force));
}

void MirrorAndRotation::end(ig::Block& b, ig::Where where) const {
  if (b.is(tilt_, g68_)) put_code(b, rotation_end_.id(0), where.begin, where.end);
  if (b.has(mirror_term_)) put_code(b, mirror_.code(0), where.begin, where.end);
}

bool MirrorAndRotation::is_mirrored_in_plane(const ig::Block& b) const {
  if (!b.has(mirror_term_)) return false;
  const std::size_t tool = plane_(b).tool;
  const ig::PartialVec3 mirror = b.get(mirror_image_);
  int mirrored = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) mirrored += axis != tool && mirror.has(axis) ? 1 : 0;
  return mirrored == 1;
}

}  // namespace heidenhain
