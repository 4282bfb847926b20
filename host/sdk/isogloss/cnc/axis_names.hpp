/// Names that programs of one machine give its axes, and positions that its builder has set for each of them.
#pragma once

#include <isogloss_axis.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

inline constexpr std::string_view axis_letters = "XYZABC";

/// A member of a syntax: the axes of the machine by their names, through the service isogloss.axis-name/1. Axes 0 to 5
/// are X Y Z A B C; further ones follow.
class AxisNames {
 public:
  /// The axis that programs call so; without the service an axis is called by its letter alone.
  std::optional<std::uint32_t> find(std::string_view name) const {
    if (const std::size_t letter = name.size() == 1 ? axis_letters.find(name[0]) : std::string_view::npos; letter < 6)
      return static_cast<std::uint32_t>(letter);
    const std::int32_t axis = table_ && !name.empty() ? table_->find(table_->self, to_text(name)) : -1;
    return axis < 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(axis));
  }
  /// "C" of C1: the letter of the axis X Y Z A B C that programs call so. Other names are their own.
  std::string_view letter_of(std::string_view name) const {
    const auto axis = find(name);
    return axis && *axis < axis_letters.size() ? axis_letters.substr(*axis, 1) : name;
  }
  /// The own name of the axis; empty where the machine has no such axis.
  std::string_view name(std::uint32_t axis) const {
    return table_ ? to_view(table_->name(table_->self, axis)) : std::string_view{};
  }
  /// What programs call it besides, with one blank between two names.
  std::string_view further_names(std::uint32_t axis) const {
    return table_ ? to_view(table_->further_names(table_->self, axis)) : std::string_view{};
  }
  bool is_rotary(std::uint32_t axis) const { return table_ && table_->is_rotary(table_->self, axis) != 0; }
  /// In mm or degrees, in machine coordinates; nothing where the machine does not define it.
  std::optional<double> position(std::uint32_t axis, ig_axis_position which) const {
    double out = 0;
    if (!table_ || table_->position(table_->self, axis, which, &out) == 0) return std::nullopt;
    return out;
  }
  struct Travel {
    double minimum, maximum;
  };
  /// An end that is not known is infinite; nothing where neither is known.
  std::optional<Travel> travel(std::uint32_t axis) const {
    Travel out{};
    if (!table_ || table_->travel(table_->self, axis, &out.minimum, &out.maximum) == 0) return std::nullopt;
    return out;
  }

 private:
  Service<ig_axis_name_1> table_{"isogloss.axis-name/1", Need::optional, "Names and positions of the axes."};
};

}  // namespace ig::cnc
