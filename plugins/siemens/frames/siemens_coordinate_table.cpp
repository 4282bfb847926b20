// The settable frames of a SINUMERIK: G54 to G57, G505 to G599, and the base frame, which acts with each of them and
// alone under G500.
#include <charconv>
#include <cmath>

#include <isogloss/cnc/work_offset_service.hpp>

#include "frames/settable_shape.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

/// No column has a default, so that a saved table names only values that were given or written.
struct ShapeColumns {
  std::array<ig::Column, 3> fine{ig::Column{"FX", nullptr, "mm", {}, "Fine offset, added to X."},
                                 ig::Column{"FY", nullptr, "mm", {}, "Fine offset, added to Y."},
                                 ig::Column{"FZ", nullptr, "mm", {}, "Fine offset, added to Z."}};
  std::array<ig::Column, 3> rotation{ig::Column{"RX", nullptr, "deg", {-1e9, 1e9}, "Rotation about X, the third one."},
                                     ig::Column{"RY", nullptr, "deg", {-1e9, 1e9}, "Rotation about Y, the second one."},
                                     ig::Column{"RZ", nullptr, "deg", {-1e9, 1e9}, "Rotation about Z, the first one."}};
  std::array<ig::Column, 3> scale{ig::Column{"SX", nullptr, "", settable_scales, "Scale of X; none: 1."},
                                  ig::Column{"SY", nullptr, "", settable_scales, "Scale of Y; none: 1."},
                                  ig::Column{"SZ", nullptr, "", settable_scales, "Scale of Z; none: 1."}};
  std::array<ig::Column, 3> mirror{ig::Column{"MX", nullptr, "", {0, 1}, "1: X is mirrored."},
                                   ig::Column{"MY", nullptr, "", {0, 1}, "1: Y is mirrored."},
                                   ig::Column{"MZ", nullptr, "", {0, 1}, "1: Z is mirrored."}};

  const ig::Column& of(std::uint32_t part, std::uint32_t axis) const {
    const std::array<const std::array<ig::Column, 3>*, shape_parts> all{&fine, &rotation, &scale, &mirror};
    return (*all[part])[axis];
  }
};

struct SiemensCoordinateTable {
  static constexpr auto spec =
      ig::dependency("SiemensCoordinateTable", "Settable frames: G54 to G57, G505 to G599, and the base frame BASE.")
          .rows("Offset", "id")
          .provides("isogloss.work-offset/1", settable_shape_service);

  WorkOffsetColumns columns;
  ShapeColumns shape;
  ig::Table table;

  const void* service(std::string_view id) const {
    if (id == settable_shape_service) return &shapes;
    return id == "isogloss.work-offset/1" ? &offsets : nullptr;
  }

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
  static std::int32_t get(void* self, ig_text id, std::uint32_t part, std::uint32_t axis, double* value) {
    const auto& own = *static_cast<const SiemensCoordinateTable*>(self);
    if (!has(ig::to_view(id)) || part >= shape_parts || axis > 2) return 0;
    *value = own.table.value(ig::to_view(id), own.shape.of(part, axis)).value_or(default_of(ShapePart{part}));
    return 1;
  }
  /// Writes only values that change, so that a saved table names only what a program has set.
  static std::int32_t set(void* self, ig_text id, std::uint32_t part, std::uint32_t axis, double value) {
    const auto& own = *static_cast<const SiemensCoordinateTable*>(self);
    double present = 0;
    if (get(self, id, part, axis, &present) == 0 || !std::isfinite(value)) return 0;
    const bool is_scale = ShapePart{part} == ShapePart::scale;
    if (is_scale && !(value >= settable_scales.minimum && value <= settable_scales.maximum)) return 0;
    return value == present || own.table.set_value(ig::to_view(id), own.shape.of(part, axis), value) ? 1 : 0;
  }

  ig_work_offset_1 offsets = WorkOffsetService<SiemensCoordinateTable>::of(this);
  SettableShapes shapes{sizeof(SettableShapes), 0, this, &get, &set};
};

const ig::Register<SiemensCoordinateTable> siemens_coordinate_table;

}  // namespace
}  // namespace siemens
