// The links of a frame act from left to right: each in the coordinates that those before it give. Manual Job planning,
// "Frames".
#include "frames/frame_value.hpp"

#include <charconv>
#include <cmath>

#include "archive/data_line.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr double frame_limit = 1e9;  // mm or degrees

constexpr std::array<const char*, 5> link_names{"CTRANS", "CFINE", "CROT", "CSCALE", "CMIRROR"};
constexpr std::string_view frame_axes = "XYZABC";

ShapePart part_of(FrameLink link) { return static_cast<ShapePart>(static_cast<std::uint32_t>(link) - 1); }

bool is_idle(const ig::Vec3& v, double idle) { return v.x == idle && v.y == idle && v.z == idle; }

/// The angles whose rotation about the fixed axes X, Y and Z the matrix is. Its first row is (cos Y cos Z, cos Y sin Z,
/// -sin Y), and its last column (-sin Y, sin X cos Y, cos X cos Y).
ig::Vec3 angles_of(const Mat4& m) {
  constexpr double least_cosine = 1e-9;
  const auto rounded = [](double radians) { return std::round(radians / radians_per_degree * 1e10) / 1e10 + 0.0; };
  const double cosine = std::hypot(m[0], m[1]);
  const double y = rounded(std::atan2(-m[2], cosine));
  if (cosine < least_cosine) return {0, y, rounded(std::atan2(-m[4], m[5]))};
  return {rounded(std::atan2(m[6], m[10])), y, rounded(std::atan2(m[1], m[0]))};
}

ig::Vec3 rotated(const ig::Vec3& first, const ig::Vec3& second) {
  if (is_idle(second, 0)) return first;
  if (is_idle(first, 0)) return second;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ig::Vec3 a = first, b = second;
    a[axis] = b[axis] = 0;
    if (!is_idle(a, 0) || !is_idle(b, 0)) continue;
    ig::Vec3 sum;
    sum[axis] = first[axis] + second[axis];
    return sum;
  }
  const auto turn = [](const ig::Vec3& angles) { return roll_pitch_yaw(angles, {0, 1, 2}, TurnedAxes::fixed); };
  return angles_of(product(turn(second), turn(first)));
}

void append_link(std::string& out, FrameLink link, const FrameValue& frame) {
  const bool is_shift = link == FrameLink::shift;
  std::string arguments;
  for (std::size_t axis = 0; axis < (is_shift ? 6u : 3u); ++axis) {
    const double value = frame.get(link, axis);
    if (value == (link == FrameLink::scale ? 1 : 0)) continue;
    arguments += (arguments.empty() ? "" : ",") + std::string(1, frame_axes[axis]);
    if (link == FrameLink::mirror) continue;
    std::array<char, 512> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
    arguments.append(",").append(digits.data(), end);
  }
  if (arguments.empty() && !is_shift) return;
  if (!out.empty()) out += ':';
  out.append(link_names[static_cast<std::size_t>(link)]).append("(").append(arguments).append(")");
}

bool read_link(FrameValue& frame, FrameLink link, std::string_view arguments) {
  if (trim(arguments).empty()) return true;
  Cursor cursor(arguments);
  do {
    const std::string_view name = cursor.until(",");
    const std::size_t axis = name.size() == 1 ? frame_axes.find(to_upper(name[0])) : std::string_view::npos;
    std::optional<double> value = 1.0;
    if (link != FrameLink::mirror) value = cursor.accept(',') ? number_of(cursor.until(",")) : std::nullopt;
    if (axis == std::string_view::npos || !value || !frame.set(link, axis, *value)) return false;
  } while (cursor.accept(','));
  return true;
}

}  // namespace

std::optional<FrameLink> frame_link(std::string_view name) {
  for (std::size_t i = 0; i < link_names.size(); ++i)
    if (equals_ignoring_case(name, link_names[i])) return static_cast<FrameLink>(i);
  return std::nullopt;
}

std::optional<FrameLink> frame_component_link(std::string_view component) {
  constexpr std::array<std::string_view, 5> names{"TR", "FI", "RT", "SC", "MI"};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (component == names[i]) return static_cast<FrameLink>(i);
  return std::nullopt;
}

bool FrameValue::set(FrameLink link, std::size_t axis, double value) {
  const bool is_scale = link == FrameLink::scale;
  if (!(std::fabs(value) < frame_limit) ||
      (is_scale && !(value >= settable_scales.minimum && value <= settable_scales.maximum)))
    return false;
  if (link == FrameLink::shift && axis < 6) return shift[axis] = value + 0.0, true;
  if (link == FrameLink::fine && axis > 2 && axis < 6) return shift[axis] += value, true;
  if (axis > 2) return value == (is_scale ? 1 : 0);
  shape[part_of(link)][axis] = link == FrameLink::mirror ? (value != 0 ? 1 : 0) : value + 0.0;
  return true;
}

double FrameValue::get(FrameLink link, std::size_t axis) const {
  if (link == FrameLink::shift) return axis < 6 ? shift[axis] : 0;
  if (axis > 2) return default_of(part_of(link));
  return shape[part_of(link)][axis];
}

std::string FrameValue::text() const {
  std::string out;
  for (std::size_t link = 0; link < link_names.size(); ++link) append_link(out, static_cast<FrameLink>(link), *this);
  return out;
}

std::optional<FrameValue> FrameValue::read(std::string_view links) {
  FrameValue out;
  Cursor cursor(links);
  if (cursor.is_at_end()) return out;
  do {
    const auto link = frame_link(cursor.word());
    if (!link || !cursor.accept('(')) return std::nullopt;
    FrameValue own;
    if (!read_link(own, *link, cursor.until(")")) || !cursor.accept(')')) return std::nullopt;
    const auto both = chained(out, own);
    if (!both) return std::nullopt;
    out = *both;
  } while (cursor.accept(':'));
  return cursor.is_at_end() ? std::optional(out) : std::nullopt;
}

std::optional<FrameValue> FrameValue::of(const Mat4& m, const std::array<double, 3>& rotary) {
  constexpr double negligible = 1e-9;
  FrameValue out;
  Mat4 turn = identity_frame;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.shift[axis] = m[12 + axis];
    out.shift[3 + axis] = rotary[axis];
    const double scale = std::hypot(m[4 * axis], m[4 * axis + 1], m[4 * axis + 2]);
    if (!(scale > 0)) return std::nullopt;
    for (std::size_t column = 0; column < 3; ++column) turn[4 * axis + column] = m[4 * axis + column] / scale;
    out.shape[ShapePart::scale][axis] = std::fabs(scale - 1) < negligible ? 1 : scale;
  }
  const ig::Vec3 x{turn[0], turn[1], turn[2]}, y{turn[4], turn[5], turn[6]}, z{turn[8], turn[9], turn[10]};
  if (scalar_product(vector_product(x, y), z) < 0) {  // one mirrored axis is as good as another: MIRROR X
    out.shape[ShapePart::mirror].x = 1;
    for (std::size_t column = 0; column < 3; ++column) turn[column] = 0.0 - turn[column];
  }
  out.shape[ShapePart::rotation] = angles_of(turn);
  const Mat4 again = out.shape.matrix();
  for (std::size_t i = 0; i < 12; ++i)
    if (std::fabs(again[i] - m[i]) > negligible * (1 + std::fabs(m[i]))) return std::nullopt;
  return out.is_within_range() ? std::optional(out) : std::nullopt;
}

bool FrameValue::is_within_range() const {
  for (const double s : shift)
    if (!(std::fabs(s) < frame_limit)) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double scale = shape[ShapePart::scale][axis];
    if (!(std::fabs(shape[ShapePart::fine][axis]) < frame_limit) ||
        !(std::fabs(shape[ShapePart::rotation][axis]) < frame_limit) ||
        !(scale >= settable_scales.minimum && scale <= settable_scales.maximum))
      return false;
  }
  return true;
}

std::optional<FrameValue> chained(const FrameValue& first, const FrameValue& second) {
  const ig::Vec3 &scale = first.shape[ShapePart::scale], &mirror = first.shape[ShapePart::mirror],
                 &turn = second.shape[ShapePart::rotation];
  const bool keeps_shape = is_idle(mirror, 0) && scale.x == scale.y && scale.y == scale.z;
  if (!is_idle(turn, 0) && !keeps_shape) return std::nullopt;
  FrameValue out = first;
  const Mat4 own = first.shape.matrix();
  ig::Vec3 way{second.shift[0], second.shift[1], second.shift[2]};
  if (own == identity_frame)
    out.shape[ShapePart::fine] = first.shape[ShapePart::fine] + second.shape[ShapePart::fine];
  else
    way = way + second.shape[ShapePart::fine];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.shift[axis] += way.x * own[axis] + way.y * own[4 + axis] + way.z * own[8 + axis];
    out.shift[3 + axis] += second.shift[3 + axis];
    out.shape[ShapePart::scale][axis] *= second.shape[ShapePart::scale][axis];
    out.shape[ShapePart::mirror][axis] = mirror[axis] == second.shape[ShapePart::mirror][axis] ? 0 : 1;
  }
  out.shape[ShapePart::rotation] = rotated(first.shape[ShapePart::rotation], turn);
  return out.is_within_range() ? std::optional(out) : std::nullopt;
}

}  // namespace siemens
