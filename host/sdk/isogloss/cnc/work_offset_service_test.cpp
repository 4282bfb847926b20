#include "isogloss/cnc/work_offset_service.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// A control with G54 and G55.
struct TwoOffsets {
  WorkOffsetColumns columns;
  ig::Table table;
  bool has(std::string_view id) const { return id == "G54" || id == "G55"; }
};

struct ServedOffsets {
  BlockDocument document;
  TwoOffsets table = document.member<TwoOffsets>();
  ig_work_offset_1 service = WorkOffsetService<TwoOffsets>::of(&table);

  using Offset = std::array<double, 3>;
  std::optional<Offset> get(std::string_view id) {
    Offset out{9, 9, 9};
    return service.get(service.self, ig::to_text(id), out.data()) != 0 ? std::optional(out) : std::nullopt;
  }
  std::optional<Offset> get_rotary(std::string_view id) {
    Offset out{9, 9, 9};
    return service.get_rotary(service.self, ig::to_text(id), out.data()) != 0 ? std::optional(out) : std::nullopt;
  }
  bool set(std::string_view id, const Offset& mm) { return service.set(service.self, ig::to_text(id), mm.data()) == 1; }
  bool set_rotary(std::string_view id, const Offset& degrees) {
    return service.set_rotary(service.self, ig::to_text(id), degrees.data()) == 1;
  }
};

constexpr std::uint32_t column_of_a = 3;

}  // namespace

TEST_CASE("a work offset that the control has but no row names is at machine zero") {
  ServedOffsets s;
  CHECK(s.get("G54") == ServedOffsets::Offset{0, 0, 0});
  CHECK(s.get_rotary("G54") == ServedOffsets::Offset{0, 0, 0});
}

TEST_CASE("a work offset that was set is read back, in the row of its name alone") {
  ServedOffsets s;
  CHECK(s.set("G55", {100, -20.5, 3}));
  CHECK(s.get("G55") == ServedOffsets::Offset{100, -20.5, 3});
  CHECK(s.get("G54") == ServedOffsets::Offset{0, 0, 0});
  CHECK(s.get_rotary("G55") == ServedOffsets::Offset{0, 0, 0});
}

TEST_CASE("a work offset that the control does not have is neither read nor written") {
  ServedOffsets s;
  CHECK_FALSE(s.get("G59").has_value());
  CHECK_FALSE(s.get_rotary("G59").has_value());
  CHECK_FALSE(s.set("G59", {1, 2, 3}));
  CHECK_FALSE(s.set_rotary("G59", {1, 2, 3}));
  CHECK_FALSE(s.document.cell("G59", 0).has_value());
}

TEST_CASE("only rotary axes whose origin changes are written to the row") {
  ServedOffsets s;
  CHECK(s.set_rotary("G54", {0, 45, 0}));
  CHECK(s.get_rotary("G54") == ServedOffsets::Offset{0, 45, 0});
  CHECK_FALSE(s.document.cell("G54", column_of_a).has_value());
  CHECK(s.document.cell("G54", column_of_a + 1) == 45);
  CHECK_FALSE(s.document.cell("G54", column_of_a + 2).has_value());
  CHECK(s.set_rotary("G54", {0, 0, 0}));
  CHECK(s.document.cell("G54", column_of_a + 1) == 0);
}

TEST_CASE("without a table no work offset can be set") {
  BlockDocument document;
  document.has_table = false;
  auto table = document.member<TwoOffsets>();
  const ig_work_offset_1 service = WorkOffsetService<TwoOffsets>::of(&table);
  const double offset[3] = {1, 2, 3};
  CHECK(service.set(service.self, ig::to_text("G54"), offset) == 0);
  CHECK(service.set_rotary(service.self, ig::to_text("G54"), offset) == 0);
}
