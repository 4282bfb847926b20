// The tool offsets: length (H) and radius (D) of each offset number, as geometry and wear. H and D share one row; the
// row is the offset number that a program gives with H and D, not the number of the tool in the magazine. A row 5.1 has
// the further length and radius that tool 5 has with index 1.
#include <isogloss_tool.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <unordered_map>
#include <vector>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

enum class Unlisted { zero, missing };

struct ToolOffsetTable {
  static constexpr auto spec = ig::dependency("ToolOffsetTable", "Tool lengths and radii by offset number.")
                                   .rows("Tool", "id")
                                   .provides("isogloss.tool-offset/1", "isogloss.tool-name/1");

  ig::IntegerOption size{"size", "400", {1, 99'999}, "The highest offset number of the control; the lowest is 1."};
  ig::Choice<Unlisted> unlisted{
      "unlisted", "zero|missing", "zero",
      "What a number without a row means: an offset of zero, or no offset, which is reported."};
  ig::Column length{"H", "0", "mm", {}, "Length, geometry."};
  ig::Column length_wear{"HWear", "0", "mm", {}, "Length, wear; added to H."};
  ig::Column radius{"D", "0", "mm", {}, "Radius, geometry."};
  ig::Column radius_wear{"DWear", "0", "mm", {}, "Radius, wear; added to D."};
  ig::Column corner{"CornerRadius", nullptr, "mm", {0, 1e9}, "Radius of the corner, geometry; that of a ball is D."};
  ig::Column corner_wear{"CornerRadiusWear", nullptr, "mm", {}, "Radius of the corner, wear; added to CornerRadius."};
  ig::Column tip_angle{"TipAngle", nullptr, "deg", {0, 180}, "The whole angle at the tip of a drill."};
  ig::Column teeth{"Teeth", nullptr, "", {0, 1000}, "How many teeth or cutting edges the tool has."};
  ig::Column speed{"MaximumSpeed", nullptr, "rpm", {0, 1e9}, "The highest speed that the tool may turn with."};
  ig::Column type{"Type", nullptr, "", {0, 9999}, "The number that the control has for the type of the tool."};
  ig::Column cutting_length{"CuttingLength", nullptr, "mm", {0, 1e9}, "Length of the cutting edge."};
  ig::Column plunge_angle{"PlungeAngle", nullptr, "deg", {0, 90}, "The largest angle at which the tool may plunge."};
  ig::Column life{"Life", nullptr, "min", {0, 1e9}, "How long the tool may cut."};
  ig::Column call_life{"LifeAtCall", nullptr, "min", {0, 1e9}, "After which use a call no longer takes the tool."};
  ig::Column used_life{"UsedLife", nullptr, "min", {0, 1e9}, "How long it has cut already."};
  ig::Column name{"Name", nullptr, "", {}, "What a program calls the tool; sister tools have one name.", true};
  ig::Table table;
  ig::RowNames rows;

  ToolOffsetTable() {
    for (const std::string& row : rows) {
      const std::optional<std::int64_t> id = number_of(row);
      if (!id || !has(*id)) continue;
      place.emplace(*id, place.size());
      const std::string_view written = table.text(row, name);
      if (written.empty()) continue;
      wanted = written;
      make_capitals(wanted);
      by_name[wanted].push_back(*id);
      by_name[""].push_back(*id);
    }
  }

  const void* service(std::string_view id) const {
    if (id == "isogloss.tool-offset/1") return &offsets;
    return id == "isogloss.tool-name/1" ? &names : nullptr;
  }

  std::string row_fault(std::string_view row) const {
    const std::optional<std::int64_t> id = number_of(row);
    if (!id)
      return "a row is an offset number, 1, 2, 3 and so on without zeros, or such a number with an index from 1 to 99, "
             "as 5.1";
    return has(*id) ? "" : "the control has the numbers 1 to " + std::to_string(size) + " (option size)";
  }

 private:
  static constexpr std::int64_t most_indices = 99;

  /// "5" of number 5, "5.1" of index 1 of tool 5.
  struct RowName {
    std::array<char, 24> digits{};
    std::size_t count;
    explicit RowName(std::int64_t id) {
      char* const end = digits.data() + digits.size();
      char* p = std::to_chars(digits.data(), end, id % IG_TOOL_INDEX_STEP).ptr;
      if (id >= IG_TOOL_INDEX_STEP) {
        *p++ = '.';
        p = std::to_chars(p, end, id / IG_TOOL_INDEX_STEP).ptr;
      }
      count = static_cast<std::size_t>(p - digits.data());
    }
    std::string_view text() const { return {digits.data(), count}; }
  };

  static std::optional<std::int64_t> number_of(std::string_view row) {
    const char* const end = row.data() + row.size();
    std::int64_t tool = 0, index = 0;
    auto read = std::from_chars(row.data(), end, tool);
    if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '.') read = std::from_chars(read.ptr + 1, end, index);
    if (read.ec != std::errc{} || read.ptr != end || tool < 0 || tool >= IG_TOOL_INDEX_STEP || index < 0 ||
        index > most_indices)
      return std::nullopt;
    const std::int64_t id = tool + index * IG_TOOL_INDEX_STEP;
    return RowName(id).text() == row ? std::optional(id) : std::nullopt;
  }

  const ig::Column* column(std::uint32_t index) const {
    const std::array columns{&length,         &length_wear,  &radius, &radius_wear, &corner,
                             &corner_wear,    &tip_angle,    &teeth,  &speed,       &type,
                             &cutting_length, &plunge_angle, &life,   &call_life,   &used_life};
    return index < columns.size() ? columns[index] : nullptr;
  }
  bool has(std::int64_t id) const {
    const std::int64_t tool = id % IG_TOOL_INDEX_STEP;
    return id >= 1 && tool >= 1 && tool <= size && id / IG_TOOL_INDEX_STEP <= most_indices;
  }

  static std::int32_t get(void* self, std::int64_t id, std::uint32_t index, double* mm) {
    const auto& t = *static_cast<const ToolOffsetTable*>(self);
    const ig::Column* const column = t.column(index);
    if (column == nullptr || !t.has(id)) return 0;
    const auto value = t.table.value(RowName(id).text(), *column);
    // An index that no row has is no edge of the tool.
    const bool is_zero_without = t.unlisted == Unlisted::zero && index <= IG_TOOL_RADIUS_WEAR;
    if (!value && (!is_zero_without || id >= IG_TOOL_INDEX_STEP)) return 0;
    *mm = value.value_or(0);
    return 1;
  }
  static std::int32_t set(void* self, std::int64_t id, std::uint32_t index, double mm) {
    const auto& t = *static_cast<const ToolOffsetTable*>(self);
    const ig::Column* const column = t.column(index);
    if (column == nullptr || !t.has(id)) return 0;
    return t.table.set_value(RowName(id).text(), *column, mm) ? 1 : 0;
  }

  static void make_capitals(std::string& text) {
    std::transform(text.begin(), text.end(), text.begin(), ig::cnc::to_upper);
  }
  static std::int64_t find(void* self, ig_text name, std::int64_t after) {
    auto& t = *static_cast<ToolOffsetTable*>(self);
    t.wanted = ig::to_view(name);
    make_capitals(t.wanted);
    const auto sisters = t.by_name.find(t.wanted);
    if (sisters == t.by_name.end()) return 0;
    const std::vector<std::int64_t>& ids = sisters->second;
    if (after == 0) return ids.front();
    const auto last = t.place.find(after);
    if (last == t.place.end()) return 0;
    const auto next =
        std::partition_point(ids.begin(), ids.end(), [&](std::int64_t id) { return t.place.at(id) <= last->second; });
    return next == ids.end() ? 0 : *next;
  }
  static ig_text name_of(void* self, std::int64_t id) {
    const auto& t = *static_cast<const ToolOffsetTable*>(self);
    return ig::to_text(t.has(id) ? t.table.text(RowName(id).text(), t.name) : std::string_view());
  }

  /// By name in capitals, for controls do not tell them from small letters; the empty name has all tools with a name.
  std::unordered_map<std::string, std::vector<std::int64_t>> by_name;
  /// By number: which row of the table it is.
  std::unordered_map<std::int64_t, std::size_t> place;
  std::string wanted;  // kept between calls for its room
  ig_tool_name_1 names{sizeof(ig_tool_name_1), 0, this, &find, &name_of};
  ig_tool_offset_1 offsets{sizeof(ig_tool_offset_1), 0, this, &get, &set};
};

const ig::Register<ToolOffsetTable> tool_offset_table;

}  // namespace
}  // namespace iso
