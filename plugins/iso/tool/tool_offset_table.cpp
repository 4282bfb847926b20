// The tool offsets: length (H) and radius (D) of each offset number, as geometry and wear. H and D share one row; the
// row is the offset number that a program gives with H and D, not the number of the tool in the magazine.
#include <charconv>

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

enum class Unlisted { zero, missing };

struct ToolOffsetTable {
  static constexpr auto spec = ig::dependency("ToolOffsetTable", "Tool lengths and radii by offset number.")
                                   .rows("Tool", "id")
                                   .provides("isogloss.tool-offset/1");

  ig::IntegerOption size{"size", "400", {1, 99'999}, "The highest offset number of the control; the lowest is 1."};
  ig::Choice<Unlisted> unlisted{
      "unlisted", "zero|missing", "zero",
      "What a number without a row means: an offset of zero, or no offset, which is reported."};
  ig::Column length{"H", "0", "mm", {}, "Length, geometry."};
  ig::Column length_wear{"HWear", "0", "mm", {}, "Length, wear; added to H."};
  ig::Column radius{"D", "0", "mm", {}, "Radius, geometry."};
  ig::Column radius_wear{"DWear", "0", "mm", {}, "Radius, wear; added to D."};
  ig::Table table;

  const void* service(std::string_view id) const { return id == "isogloss.tool-offset/1" ? &offsets : nullptr; }

  std::string row_fault(std::string_view row) const {
    std::int64_t id = 0;
    const auto [end, error] = std::from_chars(row.data(), row.data() + row.size(), id);
    const bool is_number = error == std::errc{} && end == row.data() + row.size();
    if (!is_number || RowName(id).text() != row) return "a row is an offset number: 1, 2, 3 and so on, without zeros";
    return has(id) ? "" : "the control has the numbers 1 to " + std::to_string(size) + " (option size)";
  }

 private:
  struct RowName {
    std::array<char, 20> digits{};
    std::size_t count;
    explicit RowName(std::int64_t id)
        : count(static_cast<std::size_t>(std::to_chars(digits.data(), digits.data() + digits.size(), id).ptr -
                                         digits.data())) {}
    std::string_view text() const { return {digits.data(), count}; }
  };

  const ig::Column* column(std::uint32_t index) const {
    const ig::Column* const columns[] = {&length, &length_wear, &radius, &radius_wear};
    return index < 4 ? columns[index] : nullptr;
  }
  bool has(std::int64_t id) const { return id >= 1 && id <= size; }

  static std::int32_t get(void* self, std::int64_t id, std::uint32_t index, double* mm) {
    const auto& t = *static_cast<const ToolOffsetTable*>(self);
    const ig::Column* const column = t.column(index);
    if (column == nullptr || !t.has(id)) return 0;
    const auto value = t.table.value(RowName(id).text(), *column);
    if (!value && t.unlisted == Unlisted::missing) return 0;
    *mm = value.value_or(0);
    return 1;
  }
  static std::int32_t set(void* self, std::int64_t id, std::uint32_t index, double mm) {
    const auto& t = *static_cast<const ToolOffsetTable*>(self);
    const ig::Column* const column = t.column(index);
    if (column == nullptr || !t.has(id)) return 0;
    return t.table.set_value(RowName(id).text(), *column, mm) ? 1 : 0;
  }

  ig_tool_offset_1 offsets{sizeof(ig_tool_offset_1), 0, this, &get, &set};
};

const ig::Register<ToolOffsetTable> tool_offset_table;

}  // namespace
}  // namespace iso
