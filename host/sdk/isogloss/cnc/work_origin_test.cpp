#include "isogloss/cnc/work_origin.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"
#include "isogloss/cnc/work_offset_service.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// A control with G54 and G55.
struct OffsetPair {
  WorkOffsetColumns columns;
  ig::Table table;
  bool has(std::string_view id) const { return id == "G54" || id == "G55"; }
};

struct AskedOffsets {
  BlockDocument document;
  OffsetPair table = document.member<OffsetPair>();
  ig_work_offset_1 provided = WorkOffsetService<OffsetPair>::of(&table);
  ig::Service<ig_work_offset_1> service = bind();

  ig::Service<ig_work_offset_1> bind() {
    document.services["isogloss.work-offset/1"] = &provided;
    return document.create([] { return ig::Service<ig_work_offset_1>("isogloss.work-offset/1"); });
  }
};

}  // namespace

TEST_CASE("an origin that was written is read back") {
  AskedOffsets s;
  CHECK(set_linear_origin(s.service, "G55", {100, -20.5, 3}));
  CHECK(set_rotary_origin(s.service, "G55", {0, 45, -90}));
  CHECK(linear_origin(s.service, "G55") == ig::Vec3{100, -20.5, 3});
  CHECK(rotary_origin(s.service, "G55") == Angles{0, 45, -90});
  CHECK(linear_origin(s.service, "G54") == ig::Vec3{});
}

TEST_CASE("an origin that the table does not have is neither read nor written") {
  AskedOffsets s;
  CHECK_FALSE(linear_origin(s.service, "G59").has_value());
  CHECK_FALSE(rotary_origin(s.service, "G59").has_value());
  CHECK_FALSE(axis_origin(s.service, "G59", 0).has_value());
  CHECK_FALSE(set_linear_origin(s.service, "G59", {1, 2, 3}));
  CHECK_FALSE(set_axis_origin(s.service, "G59", 4, 5));
}

TEST_CASE("the origin of one axis is written without a change of the others") {
  AskedOffsets s;
  set_linear_origin(s.service, "G54", {1, 2, 3});
  set_rotary_origin(s.service, "G54", {4, 5, 6});
  CHECK(set_axis_origin(s.service, "G54", 1, 20));
  CHECK(set_axis_origin(s.service, "G54", 5, 60));
  CHECK(linear_origin(s.service, "G54") == ig::Vec3{1, 20, 3});
  CHECK(rotary_origin(s.service, "G54") == Angles{4, 5, 60});
  CHECK(axis_origin(s.service, "G54", 1) == 20.0);
  CHECK(axis_origin(s.service, "G54", 5) == 60.0);
}

TEST_CASE("a table of the first revision keeps no origin of rotary axes, and is not asked for one") {
  AskedOffsets s;
  s.provided.struct_size = offsetof(ig_work_offset_1, get_rotary);
  s.provided.get_rotary = nullptr;
  s.provided.set_rotary = nullptr;
  CHECK_FALSE(rotary_origin(s.service, "G54").has_value());
  CHECK_FALSE(axis_origin(s.service, "G54", 3).has_value());
  CHECK_FALSE(set_rotary_origin(s.service, "G54", {1, 2, 3}));
  CHECK(set_axis_origin(s.service, "G54", 0, 7));
}
