/// The origins in a table of work offsets, read and written through its service isogloss.work-offset/1. In machine
/// coordinates; lengths in mm, angles in degrees. The table must be there: a syntax with an optional service asks
/// first.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/rotary_words.hpp"

namespace ig::cnc {

/// The origin of the work offset `id`; nothing where the table has no such offset.
inline std::optional<Vec3> linear_origin(const Service<ig_work_offset_1>& table, std::string_view id) {
  double mm[3];
  if (table->get(table->self, to_text(id), mm) == 0) return std::nullopt;
  return Vec3{mm[0], mm[1], mm[2]};
}
/// Writes the origin of `id`; false where the table has no such offset, or cannot keep it.
inline bool set_linear_origin(const Service<ig_work_offset_1>& table, std::string_view id, const Vec3& to) {
  const double mm[3] = {to.x, to.y, to.z};
  return table->set(table->self, to_text(id), mm) != 0;
}

namespace detail {

inline bool has_rotary(const ig_work_offset_1& table) {
  constexpr std::size_t with_rotary = offsetof(ig_work_offset_1, set_rotary) + sizeof table.set_rotary;
  return table.struct_size >= with_rotary && table.get_rotary != nullptr && table.set_rotary != nullptr;
}

}  // namespace detail

/// The rotary origin of the work offset `id`; nothing where the table has no such offset, or keeps none for rotary
/// axes.
inline std::optional<Angles> rotary_origin(const Service<ig_work_offset_1>& service, std::string_view id) {
  const ig_work_offset_1& table = *service.operator->();
  Angles out{};
  if (!detail::has_rotary(table) || table.get_rotary(table.self, to_text(id), out.data()) == 0) return std::nullopt;
  return out;
}
/// Writes the rotary origin of `id`; false where the table cannot keep it.
inline bool set_rotary_origin(const Service<ig_work_offset_1>& service, std::string_view id, const Angles& to) {
  const ig_work_offset_1& table = *service.operator->();
  return detail::has_rotary(table) && table.set_rotary(table.self, to_text(id), to.data()) != 0;
}

/// The origin of the program under the work offset `id`: its own and that of the row EXT, which is added to each.
/// Nothing where the table has no such offset.
inline std::optional<Vec3> linear_program_origin(const Service<ig_work_offset_1>& table, std::string_view id) {
  const auto own = linear_origin(table, id);
  return own ? std::optional(*own + linear_origin(table, "EXT").value_or(Vec3{})) : std::nullopt;
}
inline Angles rotary_program_origin(const Service<ig_work_offset_1>& table, std::string_view id) {
  Angles out = rotary_origin(table, id).value_or(Angles{});
  const Angles external = rotary_origin(table, "EXT").value_or(Angles{});
  for (std::size_t axis = 0; axis < out.size(); ++axis) out[axis] += external[axis];
  return out;
}

/// The origin of one axis, 0 to 5 for X Y Z A B C; nothing where the table has no such offset, or keeps none for it.
inline std::optional<double> axis_origin(const Service<ig_work_offset_1>& table, std::string_view id,
                                         std::size_t axis) {
  if (axis < 3) {
    const auto linear = linear_origin(table, id);
    return linear ? std::optional((*linear)[axis]) : std::nullopt;
  }
  const auto rotary = rotary_origin(table, id);
  return rotary ? std::optional((*rotary)[axis - 3]) : std::nullopt;
}
/// Writes the origin of one axis and keeps those of the others; false where the table cannot keep it.
inline bool set_axis_origin(const Service<ig_work_offset_1>& table, std::string_view id, std::size_t axis, double to) {
  if (axis < 3) {
    Vec3 linear = linear_origin(table, id).value_or(Vec3{});
    linear[axis] = to;
    return set_linear_origin(table, id, linear);
  }
  Angles rotary = rotary_origin(table, id).value_or(Angles{});
  rotary[axis - 3] = to;
  return set_rotary_origin(table, id, rotary);
}

}  // namespace ig::cnc
