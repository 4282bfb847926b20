#include "isogloss/cnc/work_offset_id.hpp"

#include <catch2/catch.hpp>

using ig::cnc::whole_number;
using ig::cnc::WorkOffsetId;

TEST_CASE("P of G10 L2 names the external offset and G54 to G59") {
  CHECK(WorkOffsetId::basic(0).text() == "EXT");
  CHECK(WorkOffsetId::basic(1).text() == "G54");
  CHECK(WorkOffsetId::basic(6).text() == "G59");
  for (const double p : {-1.0, 7.0, 1.5, 1e300}) CHECK(WorkOffsetId::basic(p).text().empty());
}

TEST_CASE("P of G54.1 numbers the additional work offsets from 1") {
  CHECK(WorkOffsetId::additional(1).text() == "G54.1P1");
  CHECK(WorkOffsetId::additional(300).text() == "G54.1P300");
  CHECK(WorkOffsetId::additional(99999999).text() == "G54.1P99999999");
  for (const double p : {0.0, -1.0, 2.5, 1e300}) CHECK(WorkOffsetId::additional(p).text().empty());
}

TEST_CASE("where one number covers all work offsets, G54.1 begins at 16") {
  CHECK(WorkOffsetId::of_all(0).text() == "EXT");
  CHECK(WorkOffsetId::of_all(1).text() == "G54");
  CHECK(WorkOffsetId::of_all(6).text() == "G59");
  CHECK(WorkOffsetId::of_all(7).text() == "G59.1");
  CHECK(WorkOffsetId::of_all(15).text() == "G59.9");
  CHECK(WorkOffsetId::of_all(16).text() == "G54.1P16");
  CHECK(WorkOffsetId::of_all(100).text() == "G54.1P100");
  for (const double p : {-1.0, 7.5, 1e300}) CHECK(WorkOffsetId::of_all(p).text().empty());
}

TEST_CASE("numbers that name something are whole and not negative") {
  CHECK(whole_number(0) == 0);
  CHECK(whole_number(42) == 42);
  for (const double n : {-1.0, 0.5, 1e9, static_cast<double>(NAN)}) CHECK_FALSE(whole_number(n).has_value());
}
