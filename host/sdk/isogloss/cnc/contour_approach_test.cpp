#include "isogloss/cnc/contour_approach.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"
#include "isogloss/cnc/contour_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// The contour goes on along +u from 10,0, and the tool is on its left.
std::optional<ContourApproach::Path> approach_path(const ContourApproach::Way& way, const Point2& from = {}) {
  return ContourApproach::path(way, from, {10, 0}, {1, 0}, {0, 1});
}

}  // namespace

TEST_CASE("an approach on a line begins `length` before the contour, on its extension or on its normal") {
  const auto straight = approach_path({.shape = ContourApproach::Shape::line, .length = 4});
  check_point(straight->begin, {6, 0});
  CHECK_FALSE(straight->center.has_value());
  const auto normal = approach_path({.shape = ContourApproach::Shape::normal, .length = 4});
  check_point(normal->begin, {10, 4});
  CHECK_FALSE(normal->center.has_value());
}

TEST_CASE("an approach on an arc ends tangentially, on the tool's side for a positive radius") {
  const auto left = approach_path({.shape = ContourApproach::Shape::arc, .radius = 5, .angle_deg = 90});
  check_point(left->begin, {5, 5});
  check_point(left->center.value(), {10, 5});
  CHECK(left->is_ccw);
  const auto right = approach_path({.shape = ContourApproach::Shape::arc, .radius = -5, .angle_deg = 90});
  check_point(right->begin, {5, -5});
  check_point(right->center.value(), {10, -5});
  CHECK_FALSE(right->is_ccw);
}

TEST_CASE("an approach on a line and an arc meets the circle tangentially and in its sense") {
  const ContourApproach::Way way{.shape = ContourApproach::Shape::line_and_arc, .radius = 5};
  for (const Point2 from : {Point2{-20, 5}, Point2{10, 30}, Point2{40, -7}}) {
    CAPTURE(from.u, from.v);
    const auto path = approach_path(way, from);
    REQUIRE(path.has_value());
    check_point(path->center.value(), {10, 5});
    CHECK(path->is_ccw);
    const Point2 spoke = path->begin - *path->center, way_in = path->begin - from;
    CHECK(spoke.length() == Approx(5));
    CHECK(spoke.u * way_in.u + spoke.v * way_in.v == Approx(0).margin(1e-9));
    CHECK(spoke.u * way_in.v - spoke.v * way_in.u > 0);  // the tool goes on counter-clockwise
  }
}

TEST_CASE("no line reaches the circle of the approach from inside it or from a point on it") {
  const ContourApproach::Way way{.shape = ContourApproach::Shape::line_and_arc, .radius = 5};
  CHECK_FALSE(approach_path(way, {10, 5}).has_value());
  CHECK_FALSE(approach_path(way, {12, 6}).has_value());
  CHECK_FALSE(approach_path(way, {15, 5}).has_value());
}

TEST_CASE("the section ContourApproach keeps what was set; without it there is no approach") {
  BlockDocument document;
  const auto approach = document.member<ContourApproach>(ig::read | ig::write);
  ig::Block block = document.block();
  CHECK_FALSE(approach.get(block).has_value());
  approach.set(block, {.shape = ContourApproach::Shape::line_and_arc, .length = 3, .radius = -5, .angle_deg = 30});
  auto way = approach.get(block);
  REQUIRE(way.has_value());
  CHECK(document.name("ContourApproach.Shape") == "LineAndArc");
  CHECK(way->shape == ContourApproach::Shape::line_and_arc);
  CHECK(way->length == 3);
  CHECK(way->radius == -5);
  CHECK(way->angle_deg == 30);
  CHECK_FALSE(way->is_rapid);
  CHECK_FALSE(way->feed_mmds.has_value());
  approach.set(block, {.shape = ContourApproach::Shape::normal, .is_rapid = true, .feed_mmds = 25});
  way = approach.get(block);
  CHECK(way->shape == ContourApproach::Shape::normal);
  CHECK(way->is_rapid);
  CHECK(way->feed_mmds == 25);
}

TEST_CASE("a departure needs the centre and the end of its arc") {
  BlockDocument document;
  const auto departure = document.member<ContourDeparture>(ig::read | ig::write);
  ig::Block block = document.block();
  CHECK_FALSE(departure.get(block).has_value());
  departure.set(block, {{1, 2, 3}, {4, 5, 6}, true});
  const auto arc = departure.get(block);
  REQUIRE(arc.has_value());
  CHECK(arc->center == ig::Vec3{1, 2, 3});
  CHECK(arc->end == ig::Vec3{4, 5, 6});
  CHECK(arc->is_ccw);
  document.forget("ContourDeparture.ArcEnd.Z");
  CHECK_FALSE(departure.get(block).has_value());
}
