// Frames as system variables: $P_UIFR[1,X,TR], $P_CHBFR, $P_UBFR, $P_IFRAME, $P_PFRAME. They are rows of the table of
// work offsets, except the programmable frame, which is in the document.
#include <cmath>

#include <isogloss/cnc/work_origin.hpp>

#include "frames/settable_frames.hpp"
#include "language/system_data.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

std::pair<std::string_view, std::string_view> axis_and_part(const SystemData::Name& name) {
  const std::size_t first = name.base == "$P_UIFR" || name.base == "$P_CHBFR" ? 1 : 0;
  if (name.count != first + 2) return {};
  return {name.index[first], name.index[first + 1]};
}

std::optional<ShapePart> shape_part(std::string_view part) {
  if (part == "FI") return ShapePart::fine;
  if (part == "RT") return ShapePart::rotation;
  if (part == "SC") return ShapePart::scale;
  if (part == "MI") return ShapePart::mirror;
  return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> SystemData::code_of(std::string_view text) {
  const Name name(text);
  const auto n = name.number(0);
  if (name.base != "$P_UIFR" || name.count != 1 || !n || *n < 0 || *n > 99) return std::nullopt;
  return static_cast<std::uint32_t>(settable_code(*n));
}

std::optional<std::string> SystemData::frame_of(const ig::Block& b, const Name& name) const {
  const bool is_numbered = name.base == "$P_UIFR" || name.base == "$P_CHBFR";
  const auto n = name.number(0);
  if (is_numbered && (!n || *n < 0 || *n > 99)) return std::nullopt;
  if (name.base == "$P_UIFR") return "G" + std::to_string(settable_code(*n));
  if (name.base == "$P_IFRAME") return std::string(b.text(b.get_or(offset_id_, ig::Symbol{})));
  if (name.base == "$P_UBFR" || (name.base == "$P_CHBFR" && *n == 0)) return "BASE";
  return std::nullopt;
}

std::optional<double> SystemData::part_of_frame(const ig::Block& b, const Name& name, const std::string& frame) const {
  const auto [axis, part] = axis_and_part(name);
  const std::size_t i = axis_of(axis);
  if (i == std::string_view::npos || !offsets_) return std::nullopt;
  if (const auto shape = shape_part(part)) {
    if (i > 2) return default_of(*shape);
    return shapes_.get(frame)[*shape][i] / (*shape == ShapePart::fine ? unit(b) : 1);
  }
  if (part != "TR") return std::nullopt;
  const double origin = axis_origin(offsets_, frame, i).value_or(0);
  return i > 2 ? origin : origin / unit(b);
}

Written SystemData::write_frame(const ig::Block& b, const Name& name, const std::string& frame, double value) const {
  const auto [axis, part] = axis_and_part(name);
  const std::size_t i = axis_of(axis);
  if (i == std::string_view::npos || !offsets_) return Written::no;
  if (const auto shape = shape_part(part)) return write_shape(b, frame, *shape, i, value);
  if (part != "TR") return value == 0 ? Written::without_effect : Written::no;
  const double own = i > 2 ? value : value * unit(b);
  if (!(std::fabs(own) < 1e9)) return Written::no;
  return set_axis_origin(offsets_, frame, i, own) ? Written::taken : Written::no;
}

Written SystemData::write_shape(const ig::Block& b, const std::string& frame, ShapePart part, std::size_t axis,
                                double value) const {
  const double own = part == ShapePart::fine     ? value * unit(b)
                     : part == ShapePart::mirror ? (value != 0 ? 1 : 0)
                                                 : value;
  if (axis > 2 || !(std::fabs(own) < 1e9)) return own == default_of(part) ? Written::without_effect : Written::no;
  if (shapes_.set(frame, part, axis, own)) return Written::taken;
  return own == default_of(part) ? Written::without_effect : Written::no;
}

bool SystemData::write_whole(const ig::Block& b, std::string_view text, const FrameValue& value) const {
  const Name name(text);
  const auto frame = frame_of(b, name);
  if (!frame || name.base == "$P_IFRAME" || name.count > (name.base == "$P_UBFR" ? 0u : 1u) || !offsets_) return false;
  ig::Vec3 mm;
  Angles degrees{};
  SettableShape shape = value.shape;
  for (std::size_t i = 0; i < 3; ++i) {
    mm[i] = value.shift[i] * unit(b);
    degrees[i] = value.shift[3 + i];
    shape[ShapePart::fine][i] *= unit(b);
    if (!(std::fabs(mm[i]) < 1e9 && std::fabs(degrees[i]) < 1e9 && std::fabs(shape[ShapePart::fine][i]) < 1e9))
      return false;
  }
  for (std::uint32_t part = 0; part < shape_parts; ++part)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double own = shape[ShapePart{part}][axis];
      if (!shapes_.set(*frame, ShapePart{part}, axis, own) && own != default_of(ShapePart{part})) return false;
    }
  set_rotary_origin(offsets_, *frame, degrees);
  return set_linear_origin(offsets_, *frame, mm);
}

std::optional<FrameValue> SystemData::frame(const ig::Block& b, std::string_view text) const {
  const Name name(text);
  if (name.base == "$P_PFRAME" && name.count == 0) return programmed(b);
  const auto id = frame_of(b, name);
  const bool is_numbered = name.base == "$P_UIFR" || name.base == "$P_CHBFR";
  if (!id || !offsets_ || name.count != (is_numbered ? 1u : 0u)) return std::nullopt;
  const auto mm = linear_origin(offsets_, *id);
  const auto degrees = rotary_origin(offsets_, *id);
  if (!mm || !degrees) return std::nullopt;
  FrameValue out;
  out.shape = shapes_.get(*id);
  for (std::size_t i = 0; i < 3; ++i) {
    out.shift[i] = (*mm)[i] / unit(b);
    out.shift[3 + i] = (*degrees)[i];
    out.shape[ShapePart::fine][i] /= unit(b);
  }
  return out;
}

std::optional<FrameValue> SystemData::programmed(const ig::Block& b) const {
  if (const auto assigned = assigned_.get(b)) return assigned;
  Mat4 m;
  if (!b.get(frame_, m)) m = identity_frame;
  for (std::size_t i = 12; i < 15; ++i) m[i] /= unit(b);
  return FrameValue::of(m, programmable_.get(b).value);
}

std::optional<double> SystemData::part_of_programmed(const ig::Block& b, const Name& name) const {
  const auto [axis, part] = axis_and_part(name);
  const std::size_t i = axis_of(axis);
  const auto link = frame_component_link(part);
  const auto frame = link && i < 6 ? programmed(b) : std::nullopt;
  return frame ? std::optional(frame->get(*link, i)) : std::nullopt;
}

std::optional<FrameValue> SystemData::changed_programmed(const ig::Block& b, std::string_view text,
                                                         double value) const {
  const Name name(text);
  const auto [axis, part] = axis_and_part(name);
  const auto link = frame_component_link(part);
  auto frame = link ? programmed(b) : std::nullopt;
  return frame && frame->set(*link, axis_of(axis), value) ? frame : std::nullopt;
}

}  // namespace siemens
