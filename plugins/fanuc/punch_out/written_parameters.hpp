/// Blocks of parameters as a control puts them out, from the tables of a machine.
#pragma once

#include <cstdint>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace fanuc {

struct WrittenParameters {
  std::string_view axes;  ///< letters of the axes 1, 2, 3 and so on
  std::int64_t path = 1;  ///< that the values without an axis belong to
  bool is_inch = false;   ///< lengths are written in inches (I), otherwise in mm (M)
};

/// Writes the parameters of FanucParameterTable and the work offsets of IsoCoordinateTable, ordered by number. Names
/// what has no place in the file.
void write_parameters(ig::Export& out, const WrittenParameters& how);

}  // namespace fanuc
