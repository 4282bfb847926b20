/// The datum tables of the machine, which cycle 7 #n and TRANS DATUM TABLE read. HeidenhainDatums provides them.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tables/named_tables.hpp"

namespace heidenhain {

inline constexpr const char* datum_table_service = "heidenhain.datum-table/1";

/// What a row gives for X Y Z A B C, in mm and degrees; bit i of `mask` is set where axis i has a value.
struct DatumRow {
  std::uint32_t mask = 0;
  std::array<double, 6> value{};
  std::string name{};  ///< of the row, as the user wrote it
};

using DatumTables = NamedTables<DatumRow>;

}  // namespace heidenhain
