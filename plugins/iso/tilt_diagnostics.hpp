/// Diagnostics of tilted planes: the part of the plugin's table that follows rotary_diagnostics.hpp.
#pragma once

#include "rotary_diagnostics.hpp"

namespace iso {

inline constexpr std::array tilt_diagnostics{
    ig::diagnostic(IG_ERROR, "ISO-0421", "G68.2 P{0}: P is a whole number from 0 to 4; the plane stays as it was",
                   "P says how the words define the plane: Euler angles, roll pitch yaw, three points, two vectors, "
                   "projection angles.",
                   "G68.2 P7 X0 Y0 Z0 I0 J30. K0"),
};

consteval std::uint32_t tilt_diag(std::string_view code) {
  return index_of(tilt_diagnostics, code, diagnostics.size() + rotary_diagnostics.size());
}

}  // namespace iso
