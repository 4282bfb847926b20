// The settable work offsets of a SINUMERIK: G54 to G57, G505 to G599, and the base frame, which acts with each of them
// and alone under G500.
#include <charconv>

#include <isogloss/cnc/work_offset_service.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCoordinateTable {
  static constexpr auto spec =
      ig::dependency("SiemensCoordinateTable", "Work offsets: G54 to G57, G505 to G599, and the base frame BASE.")
          .rows("Offset", "id")
          .provides("isogloss.work-offset/1");

  WorkOffsetColumns columns;
  ig::Table table;

  const void* service(std::string_view id) const { return id == "isogloss.work-offset/1" ? &offsets : nullptr; }

  static std::string row_fault(std::string_view row) {
    return has(row) ? "" : "its rows are BASE, G500, G54 to G57 and G505 to G599";
  }

  static bool has(std::string_view id) {
    if (id == "BASE" || id == "G500" || id == "G54" || id == "G55" || id == "G56" || id == "G57") return true;
    int number = 0;
    if (id.size() != 4 || id[0] != 'G') return false;
    const auto [end, error] = std::from_chars(id.data() + 1, id.data() + 4, number);
    return error == std::errc{} && end == id.data() + 4 && number >= 505 && number <= 599;
  }

 private:
  ig_work_offset_1 offsets = WorkOffsetService<SiemensCoordinateTable>::of(this);
};

const ig::Register<SiemensCoordinateTable> siemens_coordinate_table;

}  // namespace
}  // namespace siemens
