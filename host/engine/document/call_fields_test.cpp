#include "isogloss/engine/call_fields.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

using namespace isogloss;

namespace {

constexpr std::uint32_t count = 4;

/// Places of four fields each whose ways are the same, each with other fields.
std::vector<const ig_field*> places_that_share(std::vector<ig_field>& room, std::size_t wanted) {
  room.resize(100'000);
  std::iota(room.begin(), room.end(), 0u);
  std::vector<const ig_field*> out;
  const std::size_t ways = FoundByPlace<FieldGroup>::home(room.data()) / FoundByPlace<FieldGroup>::ways;
  for (std::size_t at = 0; at + count <= room.size() && out.size() < wanted; at += count)
    if (FoundByPlace<FieldGroup>::home(&room[at]) / FoundByPlace<FieldGroup>::ways == ways) out.push_back(&room[at]);
  REQUIRE(out.size() == wanted);
  return out;
}

/// As a block that makes all these calls: how many of them found nothing.
std::size_t call_each(FoundByPlace<FieldGroup>& found, const std::vector<const ig_field*>& places) {
  std::size_t unknown = 0;
  for (const ig_field* const place : places) {
    if (found.at(place).is(place, count)) continue;
    FieldGroup& group = found.beside(place, count);
    if (group.is(place, count)) continue;
    ++unknown;
    group.count = count;
    std::copy_n(place, count, group.fields.begin());
  }
  return unknown;
}

}  // namespace

TEST_CASE("As many places as there are ways are found again, wherever they lie in memory") {
  std::vector<ig_field> room;
  const std::vector<const ig_field*> places = places_that_share(room, FoundByPlace<FieldGroup>::ways);
  FoundByPlace<FieldGroup> found;
  CHECK(call_each(found, places) == places.size());
  CHECK(call_each(found, places) == 0);
  CHECK(call_each(found, places) == 0);
}

TEST_CASE("Where more places share the ways than there are, each is found again when it is called twice in a row") {
  constexpr std::size_t more = 3;
  std::vector<ig_field> room;
  const std::vector<const ig_field*> places = places_that_share(room, FoundByPlace<FieldGroup>::ways + more);
  FoundByPlace<FieldGroup> found;
  CHECK(call_each(found, places) == places.size());
  CHECK(call_each(found, places) >= more);
  for (const ig_field* const place : places) {
    call_each(found, {place});
    CHECK(call_each(found, {place}) == 0);
  }
}

TEST_CASE("Other fields at a place that is known are not taken for those that stood there") {
  std::vector<ig_field> room;
  const std::vector<const ig_field*> places = places_that_share(room, 1);
  FoundByPlace<FieldGroup> found;
  CHECK(call_each(found, places) == 1);
  room[static_cast<std::size_t>(places[0] - room.data())] = 99'999;
  CHECK(call_each(found, places) == 1);
  CHECK(call_each(found, places) == 0);
}
