/// The definition of a cycle in the block document: what CYCL DEF wrote, and the cycles read. mm, mm/min, seconds.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace heidenhain {

/// Parameters of the cycles that are executed, and what they count.
struct CycleParameter {
  std::uint32_t q;
  const char* unit;
  const char* doc;
};

inline constexpr std::array cycle_parameters{
    CycleParameter{200, "mm", "Set-up clearance, above the surface."},
    CycleParameter{201, "mm", "Depth below the surface, negative."},
    CycleParameter{202, "mm", "Infeed."},
    CycleParameter{203, "mm", "The surface."},
    CycleParameter{204, "mm", "Second set-up clearance, above the surface."},
    CycleParameter{205, "mm", "Least infeed."},
    CycleParameter{206, "mm/min", "Feed of plunging."},
    CycleParameter{208, "mm/min", "Feed of the retract."},
    CycleParameter{210, "s", "Dwell at the top."},
    CycleParameter{211, "s", "Dwell at the bottom."},
    CycleParameter{212, "mm", "By how much each infeed is smaller."},
    CycleParameter{213, "", "Chip breaks before a retract."},
    CycleParameter{256, "mm", "Retract of a chip break."},
    CycleParameter{343, "", "1: the depth follows from the diameter."},
    CycleParameter{344, "mm", "Diameter of the centre."},
    CycleParameter{395, "", "1: the depth is that of the full diameter."},
};

constexpr std::size_t index_of_parameter(std::uint32_t q) {
  for (std::size_t i = 0; i < cycle_parameters.size(); ++i)
    if (cycle_parameters[i].q == q) return i;
  return cycle_parameters.size();
}

/// A member of the syntaxes that write or read the definition.
class CycleDefinition {
 public:
  explicit CycleDefinition(ig::Access access) {
    for (std::size_t i = 0; i < fields_.size(); ++i)
      fields_[i] = ig::detail::declare_field({{"CycleDefinition.Q", name(cycle_parameters[i].q)},
                                              IG_NUMBER,
                                              access,
                                              {ig::Life::modal, cycle_parameters[i].unit, cycle_parameters[i].doc}});
  }
  std::optional<double> get(const ig::Block& b, std::uint32_t q) const {
    ig_value v;
    const std::size_t i = index_of_parameter(q);
    return b.host()->get(b.raw(), fields_[i], &v) != 0 ? std::optional(v.number) : std::nullopt;
  }
  double get_or(const ig::Block& b, std::uint32_t q, double fallback) const { return get(b, q).value_or(fallback); }
  void set(ig::Block& b, std::uint32_t q, double value) const {
    b.host()->set(b.raw(), fields_[index_of_parameter(q)], {.number = value});
  }
  void clear(ig::Block& b) const {
    for (const ig_field field : fields_) b.host()->erase(b.raw(), field);
  }

 private:
  static std::string_view name(std::uint32_t q) {
    static constexpr std::string_view names[] = {"200", "201", "202", "203", "204", "205", "206", "208",
                                                 "210", "211", "212", "213", "256", "343", "344", "395"};
    static_assert(std::size(names) == cycle_parameters.size());
    return names[index_of_parameter(q)];
  }
  std::array<ig_field, cycle_parameters.size()> fields_{};
};

}  // namespace heidenhain
