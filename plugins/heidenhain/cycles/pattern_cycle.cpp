#include "cycles/pattern_cycle.hpp"

namespace heidenhain {

using namespace ig::cnc;

void PatternCycle::define(ig::Block& b, const CycleText& definition, std::string_view text, const CycleNumber& number,
                          ig::Where where) const {
  const std::int64_t cycle = number.cycle;
  definition.parameters(b, text, number.end, cycle, [&](std::uint32_t q, double value) {
    if (!PatternParameters::holds(q)) return;
    definition.set(b, pattern_.parameters(), q, value);
    // Clearances and surface are parameters of the cycle as well: they stay for the calls after the pattern.
    if (b.get_or(in_force_, std::int64_t{0}) >= 200) definition.set(b, definition_, q, value);
  });
  static constexpr std::array<std::uint32_t, 4> of_circle{216, 217, 244, 241};
  static constexpr std::array<std::uint32_t, 6> of_rows{225, 226, 237, 238, 242, 243};
  const std::span<const std::uint32_t> needed =
      cycle == 220 ? std::span<const std::uint32_t>(of_circle) : std::span<const std::uint32_t>(of_rows);
  for (const std::uint32_t q : needed)
    if (!pattern_.get(b, q)) {
      b.report(ig::diag("HEI-0163"), where, static_cast<double>(cycle), PatternParameters::name(q));
      return;
    }
  if (pattern_.get(b, 365).value_or(0) != 0) b.report(ig::diag("HEI-0180"), where);
  pattern_.set_number(b, cycle);
  b.set(call_, true);
}

}  // namespace heidenhain
