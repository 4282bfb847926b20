// The machine's axes: which exist and what programs call them, where home, the reference positions and the builder's
// other positions are, the travel and the rapid rate of each, and how the rotary axes turn.
#include <isogloss_axis.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

constexpr const char* shipped_axes[] = {"X|Home=0", "Y|Home=0", "Z|Home=0"};
constexpr std::string_view axis_letters = "XYZABC", further_letters = "UVW";

bool is_one_of(std::string_view name, std::string_view known) {
  return name.size() == 1 && known.find(name[0]) != std::string_view::npos;
}

/// C1, SP1 and ROTC, but not M1, S1, T1 and D1, which are words of a spindle or a tool, nor I1, of an arc.
bool is_long_name(std::string_view name) {
  const auto is_part = [](char c) { return (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_'; };
  if (name.size() < 2 || name.size() > 31 || is_digit(name[0]) || skip_while(name, 0, is_part) != name.size())
    return false;
  const bool is_numbered = skip_digits(name, 1) == name.size();
  return !is_numbered || std::string_view("ABCQUVWXYZ").find(name[0]) != std::string_view::npos;
}

struct MachineAxes {
  static constexpr auto spec = ig::dependency("MachineAxes", "The axes of the machine, in machine coordinates.")
                                   .rows("Axis", "name")
                                   .provides("isogloss.machine-axis/1", "isogloss.axis-name/1")
                                   .ships(shipped_axes);

  ig::Column home_position{"Home", "0", "mm, deg", {}, "Position of the axis before the first block."};
  std::array<ig::Column, 4> references{
      ig::Column{"Reference1", "0", "mm, deg", {}, "First reference position (G28)."},
      ig::Column{"Reference2", nullptr, "mm, deg", {}, "Second reference position (G30, G30 P2)."},
      ig::Column{"Reference3", nullptr, "mm, deg", {}, "Third reference position (G30 P3)."},
      ig::Column{"Reference4", nullptr, "mm, deg", {}, "Fourth reference position (G30 P4)."}};
  ig::Column minimum{"Minimum", nullptr, "mm, deg", {}, "Lower end of the travel."};
  ig::Column maximum{"Maximum", nullptr, "mm, deg", {}, "Upper end of the travel."};
  ig::Column rapid_rate{"RapidRate", nullptr, "mm/min, deg/min", {0, HUGE_VAL}, "Speed of a rapid."};
  ig::Column rollover_mode{"Rollover",
                           nullptr,
                           "",
                           {0, 2},
                           "How a rotary axis turns: 0 linear count, 1 shortest way, 2 the sign is the direction."};
  ig::Column further_names{"Names", nullptr, "", {}, "What programs call the axis besides its own name: C1 C2.", true};
  ig::Column kind{"Type", nullptr, "", {}, "Of an axis that is none of X Y Z A B C: linear or rotary.", true};
  ig::Column datum{"Datum", nullptr, "mm, deg", {}, "The builder's additional datum (M92)."};
  ig::Column retract{"Retract", nullptr, "mm, deg", {}, "Where the axis retracts before others swivel (CYCLE800)."};
  std::array<ig::Column, 4> fixed_points{ig::Column{"FixedPoint1", nullptr, "mm, deg", {}, "First fixed point (G75)."},
                                         ig::Column{"FixedPoint2", nullptr, "mm, deg", {}, "Fixed point of G75 FP=2."},
                                         ig::Column{"FixedPoint3", nullptr, "mm, deg", {}, "Fixed point of G75 FP=3."},
                                         ig::Column{"FixedPoint4", nullptr, "mm, deg", {}, "Fixed point of G75 FP=4."}};
  ig::Table table;
  ig::RowNames rows;

  MachineAxes() {
    for (const char letter : axis_letters) names.emplace_back(1, letter);
    for (const std::string& name : rows) {
      if (is_one_of(name, axis_letters)) continue;
      if (!is_one_of(name, further_letters) && !is_long_name(name))
        throw std::runtime_error("axis '" + name +
                                 "': its name is X, Y, Z, A, B or C; of a further axis U, V, W or, as Q1, longer");
      names.push_back(name);
    }
    for (const std::string& row : rows)
      for_each_name(row, [&](const std::string& name) {
        if (name == row || is_long_name(name)) claims.emplace(name, row);
      });
    if (names.size() > first_further_axis + most_further_axes)
      throw std::runtime_error("more than six axes beside X, Y, Z, A, B and C");
    for (std::uint32_t axis = 0; axis < names.size(); ++axis) {
      std::string& list = lists.emplace_back();
      for_each_name(names[axis], [&](const std::string& name) {
        axis_of.emplace(name, axis);
        if (name != names[axis]) list.append(list.empty() ? "" : " ").append(name);
      });
    }
  }

  const void* service(std::string_view id) const {
    if (id == "isogloss.axis-name/1") return &axis_names;
    return id == "isogloss.machine-axis/1" ? &axes : nullptr;
  }

  std::string row_fault(std::string_view row) const {
    std::string fault;
    for_each_name(row, [&](const std::string& name) {
      if (name != row && !is_long_name(name)) {
        fault = "Names=\"" + name + "\" is no name of an axis: write letters and digits, as C1 or SP1";
        return;
      }
      for (auto [claim, last] = claims.equal_range(name); claim != last; ++claim)
        if (claim->second != row)
          fault = "the rows " + std::string(row) + " and " + claim->second + " both name " + name;
    });
    const std::string_view type = table.text(row, kind);
    if (is_one_of(row, axis_letters))
      return !type.empty() ? "Type has no effect on an axis X Y Z A B C: remove it" : fault;
    if (!type.empty() && type != "linear" && type != "rotary") return "Type is linear or rotary";
    if (const std::string_view unused = unused_column(row); !unused.empty())
      return std::string(unused) + " has no effect on a further axis: remove it";
    return fault;
  }

 private:
  /// Calls each(name) for the own name of the axis and for its further ones, in capital letters.
  template <class Each>
  void for_each_name(std::string_view row, Each&& each) const {
    each(std::string(row));
    for (std::string_view rest = trim(table.text(row, further_names)); !rest.empty(); rest = trim(rest)) {
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
      each(in_capitals(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
  }

  /// A further axis only goes to the positions of its words and of G28 and G30: other columns would have no effect.
  std::string_view unused_column(std::string_view row) const {
    struct Use {
      const ig::Column& column;
      std::string_view name;
    };
    for (const Use& use :
         {Use{rapid_rate, "RapidRate"}, Use{datum, "Datum"}, Use{rollover_mode, "Rollover"}, Use{retract, "Retract"},
          Use{fixed_points[0], "FixedPoint1"}, Use{fixed_points[1], "FixedPoint2"}, Use{fixed_points[2], "FixedPoint3"},
          Use{fixed_points[3], "FixedPoint4"}})
      if (table.value(row, use.column)) return use.name;
    return {};
  }

  bool exists(std::string_view name) const { return table.value(name, home_position).has_value(); }
  std::int32_t answer(std::string_view axis, const ig::Column& column, double* out) const {
    const auto value = table.value(axis, column);
    if (value) *out = *value;
    return value ? 1 : 0;
  }
  std::int32_t travel_of(std::string_view axis, double* low, double* high) const {
    *low = -HUGE_VAL;
    *high = HUGE_VAL;
    const bool any = (answer(axis, minimum, low) | answer(axis, maximum, high)) != 0;
    return any && *low <= *high ? 1 : 0;
  }

  // ---- isogloss.machine-axis/1

  static const MachineAxes& of(void* self) { return *static_cast<const MachineAxes*>(self); }
  static std::int32_t home(void* self, char axis, double* position) {
    return of(self).answer({&axis, 1}, of(self).home_position, position);
  }
  static std::int32_t reference(void* self, char axis, std::uint32_t which, double* position) {
    return which >= 1 && which <= 4 ? of(self).answer({&axis, 1}, of(self).references[which - 1], position) : 0;
  }
  static std::int32_t travel(void* self, char axis, double* low, double* high) {
    return of(self).travel_of({&axis, 1}, low, high);
  }
  static std::int32_t rollover(void* self, char axis, std::uint32_t* mode) {
    const MachineAxes& m = of(self);
    if (!is_one_of({&axis, 1}, "ABC") || !m.exists({&axis, 1})) return 0;
    double low = 0, high = 0;
    const bool is_limited = travel(self, axis, &low, &high) != 0;
    *mode = static_cast<std::uint32_t>(m.table.value({&axis, 1}, m.rollover_mode).value_or(is_limited ? 0 : 1));
    return 1;
  }
  static std::int32_t rapid(void* self, char axis, double* per_second) {
    if (of(self).answer({&axis, 1}, of(self).rapid_rate, per_second) == 0) return 0;
    *per_second /= 60;
    return 1;
  }

  // ---- isogloss.axis-name/1

  static std::int32_t find(void* self, ig_text name) {
    const auto axis = of(self).axis_of.find(in_capitals(ig::to_view(name)));
    return axis != of(self).axis_of.end() && of(self).exists(of(self).names[axis->second])
               ? static_cast<std::int32_t>(axis->second)
               : -1;
  }
  static ig_text name_of(void* self, std::uint32_t axis) {
    const auto& names = of(self).names;
    return ig::to_text(axis < names.size() && of(self).exists(names[axis]) ? std::string_view(names[axis]) : "");
  }
  static ig_text further_names_of(void* self, std::uint32_t axis) {
    const auto& names = of(self).names;
    return ig::to_text(axis < names.size() ? std::string_view(of(self).lists[axis]) : "");
  }
  static std::int32_t is_rotary(void* self, std::uint32_t axis) {
    const auto& names = of(self).names;
    if (axis >= names.size()) return 0;
    const std::string_view type = of(self).table.text(names[axis], of(self).kind);
    if (!type.empty()) return type == "rotary" ? 1 : 0;
    return std::string_view("ABCS").find(names[axis][0]) != std::string_view::npos ? 1 : 0;
  }
  static std::int32_t position(void* self, std::uint32_t axis, ig_axis_position which, double* out) {
    const MachineAxes& m = of(self);
    if (axis >= m.names.size()) return 0;
    const std::string& name = m.names[axis];
    if (which >= IG_AXIS_FIXED_POINT_1 && which <= IG_AXIS_FIXED_POINT_4)
      return m.answer(name, m.fixed_points[which - IG_AXIS_FIXED_POINT_1], out);
    if (which >= IG_AXIS_REFERENCE_1 && which <= IG_AXIS_REFERENCE_4)
      return m.answer(name, m.references[which - IG_AXIS_REFERENCE_1], out);
    switch (which) {
      case IG_AXIS_HOME: return m.answer(name, m.home_position, out);
      case IG_AXIS_DATUM: return m.answer(name, m.datum, out);
      case IG_AXIS_RETRACT: return m.answer(name, m.retract, out);
      default: return 0;
    }
  }
  static std::int32_t travel_at(void* self, std::uint32_t axis, double* low, double* high) {
    return axis < of(self).names.size() ? of(self).travel_of(of(self).names[axis], low, high) : 0;
  }

  std::vector<std::string> lists;                  // by number: the further names
  std::vector<std::string> names;                  // by number
  std::multimap<std::string, std::string> claims;  // the rows by each of their names
  std::map<std::string, std::uint32_t> axis_of;    // the first that claims the name
  ig_machine_axis_1 axes{sizeof(ig_machine_axis_1), 0, this, &home, &reference, &travel, &rapid, &rollover};
  ig_axis_name_1 axis_names{sizeof(ig_axis_name_1), 0,          this,      &find,     &name_of,
                            &further_names_of,      &is_rotary, &position, &travel_at};
};

const ig::Register<MachineAxes> machine_axes;

}  // namespace
}  // namespace iso
