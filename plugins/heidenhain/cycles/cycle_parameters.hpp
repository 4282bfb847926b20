/// The definition of a cycle in the block document: CYCL DEF writes it, the cycles read it. mm, mm/min, seconds.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace heidenhain {

/// A parameter of the cycles that are executed, and its unit.
struct CycleParameter {
  std::uint32_t q;
  const char* name;
  const char* unit;
  const char* doc;
};

inline constexpr std::array cycle_parameters{
    // Parts of the older cycles, CYCL DEF 1.1 to 1.5; signs and units are as written.
    CycleParameter{1, "Part1", "", "SET UP of cycles 1, 2 and 17."},
    CycleParameter{2, "Part2", "", "DEPTH of them."},
    CycleParameter{3, "Part3", "", "PECKING of cycle 1, DWELL of 2, PITCH of 17."},
    CycleParameter{4, "Part4", "", "DWELL of cycle 1, F of 2."},
    CycleParameter{5, "Part5", "", "F of cycle 1."},
    CycleParameter{200, "Q200", "mm", "Set-up clearance, above the surface."},
    CycleParameter{201, "Q201", "mm", "Depth below the surface, negative."},
    CycleParameter{202, "Q202", "mm", "Infeed."},
    CycleParameter{203, "Q203", "mm", "The surface."},
    CycleParameter{204, "Q204", "mm", "Second set-up clearance, above the surface."},
    CycleParameter{205, "Q205", "mm", "Least infeed."},
    CycleParameter{206, "Q206", "mm/min", "Feed of plunging."},
    CycleParameter{208, "Q208", "mm/min", "Feed of the retract."},
    CycleParameter{210, "Q210", "s", "Dwell at the top."},
    CycleParameter{211, "Q211", "s", "Dwell at the bottom."},
    CycleParameter{212, "Q212", "mm", "By how much each infeed is smaller."},
    CycleParameter{213, "Q213", "", "Chip breaks before a retract."},
    CycleParameter{214, "Q214", "", "Direction off the wall: 1 -first axis, 2 -second, 3 +first, 4 +second."},
    CycleParameter{239, "Q239", "mm", "Pitch, negative for a left-hand thread."},
    CycleParameter{249, "Q249", "mm", "Depth of the counterbore, from the underside."},
    CycleParameter{250, "Q250", "mm", "Thickness of the material."},
    CycleParameter{251, "Q251", "mm", "Off-centre distance of the bar."},
    CycleParameter{252, "Q252", "mm", "From the underside of the bar to the edge."},
    CycleParameter{253, "Q253", "mm/min", "Feed of pre-positioning."},
    CycleParameter{254, "Q254", "mm/min", "Feed of counterboring."},
    CycleParameter{255, "Q255", "s", "Dwell at the counterbore."},
    CycleParameter{256, "Q256", "mm", "Retract of a chip break."},
    CycleParameter{257, "Q257", "mm", "Infeed up to a chip break."},
    CycleParameter{258, "Q258", "mm", "Advanced stop distance, first infeed."},
    CycleParameter{259, "Q259", "mm", "Advanced stop distance, last infeed."},
    CycleParameter{334, "Q334", "mm", "Infeed of one turn of the helix."},
    CycleParameter{335, "Q335", "mm", "Diameter of the hole."},
    CycleParameter{336, "Q336", "deg", "Angle of the oriented stop."},
    CycleParameter{342, "Q342", "mm", "Diameter that is there already."},
    CycleParameter{343, "Q343", "", "1: the depth follows from the diameter."},
    CycleParameter{344, "Q344", "mm", "Diameter of the centre."},
    CycleParameter{351, "Q351", "", "+1: climb milling, -1: conventional."},
    CycleParameter{367, "Q367", "", "Where the pocket or slot lies about the tool; 0: the tool stands at its centre."},
    CycleParameter{370, "Q370", "", "Overlap of the passes."},
    CycleParameter{379, "Q379", "mm", "Deepened starting point."},
    CycleParameter{395, "Q395", "", "1: the depth is that of the full diameter."},
    CycleParameter{401, "Q401", "%", "Factor of the feed below the dwell depth."},
    CycleParameter{403, "Q403", "", "Factor of the speed at the retract."},
    CycleParameter{435, "Q435", "mm", "Dwell depth, from the surface."},
};

/// FMAX as the value of a parameter that is a feed, in mm/min.
inline constexpr double fmax_feed = 99'999;

/// The fields of a section for the parameters of `table`. A parameter that the table lacks has no value.
template <const auto& table>
class CycleParameters {
 public:
  /// `section` ends in a point.
  CycleParameters(std::string_view section, ig::Access access, ig::Life life) {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      fields_[i] =
          ig::detail::declare_field({{section, table[i].name}, IG_NUMBER, access, {life, table[i].unit, table[i].doc}});
  }

  static constexpr bool holds(std::uint32_t q) { return index_of(q) < table.size(); }
  static constexpr std::string_view name(std::uint32_t q) { return table[index_of(q)].name; }
  static constexpr std::string_view unit(std::uint32_t q) { return table[index_of(q)].unit; }

  std::optional<double> get(const ig::Block& b, std::uint32_t q) const {
    ig_value v;
    const std::size_t i = index_of(q);
    return i < fields_.size() && b.get(fields_[i], v) ? std::optional(v.number) : std::nullopt;
  }
  void set(ig::Block& b, std::uint32_t q, double value) const {
    if (const std::size_t i = index_of(q); i < fields_.size()) b.set(fields_[i], value);
  }
  void clear(ig::Block& b) const {
    for (const ig_field field : fields_) b.erase(field);
  }

 private:
  static constexpr std::size_t index_of(std::uint32_t q) { return q < indices.size() ? indices[q] : table.size(); }

  /// A cycle reads a parameter for each step of each hole.
  static constexpr std::array<std::uint8_t, 512> indices = [] {
    std::array<std::uint8_t, 512> all{};
    all.fill(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) all[table[i].q] = static_cast<std::uint8_t>(i);
    return all;
  }();

  std::array<ig_field, table.size()> fields_{};
};

/// A member of the syntaxes that write or read the definition.
class CycleDefinition : public CycleParameters<cycle_parameters> {
 public:
  explicit CycleDefinition(ig::Access access) : CycleParameters("CycleDefinition.", access, ig::Life::modal) {}
};

}  // namespace heidenhain
