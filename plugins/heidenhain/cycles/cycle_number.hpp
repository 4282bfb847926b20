/// The number of a cycle in the text of CYCL DEF, and what the tables of the manuals say about a number.
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <isogloss/cnc/machine_codes.hpp>

namespace heidenhain {

/// CYCL DEF 200, CYCL DEF 7.1. The number may follow without a blank, and blanks may separate its parts: CYCL DEF9 .0
struct CycleNumber {
  std::uint32_t cycle = 0;
  std::optional<std::uint32_t> part;
  std::size_t end = 0;
  bool is_first() const { return !part || *part == 0; }

  /// The number at position `i`; nothing where none is there.
  static std::optional<CycleNumber> at(std::string_view text, std::size_t i);
};

/// Cycles that act where they are defined; all others wait for a call.
bool acts_where_defined(std::uint32_t cycle);

/// Cycles that wait for a call, from the tables of the manuals. For other cycles, those of machine builders among them,
/// it is not known when they act.
bool waits_for_call(std::uint32_t cycle);

/// The Q parameters of a cycle; empty where they are not known here.
std::span<const std::uint16_t> parameters_of(std::int64_t cycle);

/// What MachineCodes has for a cycle: a family answers only for cycles of the builder, not for those of the control.
inline const ig_machine_code* row_of_cycle(const ig::cnc::MachineCodes& machine, std::uint32_t cycle) {
  std::array<char, 24> text{"CYCL DEF "};
  const char* const end = std::to_chars(text.data() + 9, text.data() + text.size(), cycle).ptr;
  const std::string_view name(text.data(), end);
  if (const ig_machine_code* const row = machine.find(name)) return row;
  return acts_where_defined(cycle) || waits_for_call(cycle) ? nullptr : machine.family(name);
}

}  // namespace heidenhain
