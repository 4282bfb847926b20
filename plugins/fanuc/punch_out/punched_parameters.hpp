/// The parameters that FanucParameterTable gives a meaning, with the kind of their values; the table holds counts of
/// increments, which a file may hold in mm or inches. Fanuc parameter manual (0i, 30i).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace fanuc {

enum class ParameterKind {
  bits,           // eight digits
  number,         // without a unit
  counted,        // the table has increments of mm
  counted_angle,  // the table has increments of degrees
  position,       // the table has mm or degrees
  rate,           // the table has mm/min or degrees/min
  work_offset     // a row of IsoCoordinateTable
};

/// What unit a length without a letter has: that of the machine (1001 bit 0) or that of the input (0000 bit 2).
enum class LengthSystem { machine, input };

struct KnownParameter {
  std::int64_t first, last;
  ParameterKind kind;
  bool has_axes;
  LengthSystem system = LengthSystem::machine;

  /// A count without a decimal point has the same number in each unit.
  constexpr bool is_length(bool is_rotary, bool has_point) const {
    const bool is_measured =
        kind == ParameterKind::position || kind == ParameterKind::rate || kind == ParameterKind::work_offset;
    return kind == ParameterKind::counted ? has_point : is_measured && !is_rotary;
  }
};

inline constexpr std::array known_parameters{
    KnownParameter{1006, 1006, ParameterKind::bits, true},
    KnownParameter{1008, 1008, ParameterKind::bits, true},
    KnownParameter{1013, 1013, ParameterKind::bits, false},
    KnownParameter{1202, 1202, ParameterKind::bits, false},
    KnownParameter{1220, 1226, ParameterKind::work_offset, true, LengthSystem::input},
    KnownParameter{1240, 1243, ParameterKind::position, true},
    KnownParameter{1320, 1321, ParameterKind::position, true},
    KnownParameter{1420, 1420, ParameterKind::rate, true},
    KnownParameter{3401, 3401, ParameterKind::bits, false},
    KnownParameter{3410, 3410, ParameterKind::counted, false, LengthSystem::input},
    KnownParameter{5101, 5101, ParameterKind::bits, false},
    KnownParameter{5114, 5115, ParameterKind::counted, false, LengthSystem::input},
    KnownParameter{5148, 5148, ParameterKind::number, true},
    KnownParameter{5149, 5149, ParameterKind::number, false},
    KnownParameter{5200, 5200, ParameterKind::bits, false},
    KnownParameter{5211, 5211, ParameterKind::number, false},
    KnownParameter{5213, 5213, ParameterKind::counted, false, LengthSystem::input},
    KnownParameter{5400, 5400, ParameterKind::bits, false},
    KnownParameter{5410, 5410, ParameterKind::counted_angle, false},
    KnownParameter{5411, 5411, ParameterKind::number, false},
    KnownParameter{5440, 5440, ParameterKind::counted, true, LengthSystem::input},
    KnownParameter{6001, 6001, ParameterKind::bits, false},
    KnownParameter{6050, 6059, ParameterKind::number, false},
    KnownParameter{6071, 6079, ParameterKind::number, false},
    KnownParameter{6080, 6089, ParameterKind::number, false},
};

inline const KnownParameter* known_parameter(std::int64_t number) {
  const auto found = std::find_if(known_parameters.begin(), known_parameters.end(),
                                  [&](const KnownParameter& k) { return number >= k.first && number <= k.last; });
  return found == known_parameters.end() ? nullptr : &*found;
}

/// Eight digits, the leftmost is bit 7; nothing for other texts.
inline std::optional<unsigned> bits_of(std::string_view digits) {
  if (digits.size() != 8 || digits.find_first_not_of("01") != std::string_view::npos) return std::nullopt;
  unsigned bits = 0;
  for (const char c : digits) bits = bits << 1 | (c == '1' ? 1u : 0u);
  return bits;
}

}  // namespace fanuc
