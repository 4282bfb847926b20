#include "isogloss/cnc/scale_and_mirror.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

TEST_CASE("a scaled axis keeps the centre, and a mirrored axis the mirror") {
  CHECK(AxisMap{}.position(7) == 7);
  const AxisMap scaled = AxisMap{}.scaled(2, 10);
  CHECK(scaled.position(10) == 10);
  CHECK(scaled.position(15) == 20);
  CHECK(scaled.programmed(20) == 15);
  const AxisMap mirrored = AxisMap{}.mirrored(5);
  CHECK(mirrored.position(5) == 5);
  CHECK(mirrored.position(7) == 3);
  CHECK(mirrored.programmed(3) == 7);
}

TEST_CASE("the scaling acts before the mirror image that follows it") {
  CHECK(AxisMap{}.scaled(2, 0).mirrored(10).position(3) == 14);
  CHECK(AxisMap{}.mirrored(10).scaled(2, 0).position(3) == 34);
}

TEST_CASE("the holes of a polar repeat turn counter-clockwise about the pole, at the level of the first hole") {
  const PolarRepeats repeats{90, {10, 0, 99}, {}, {}};
  CHECK(repeats.hole({20, 0, 5}, 0, xy_plane) == ig::Vec3{20, 0, 5});
  CHECK(repeats.hole({20, 0, 5}, 1, xy_plane) == ig::Vec3{10, 10, 5});
  CHECK(repeats.hole({20, 0, 5}, 2, xy_plane) == ig::Vec3{0, 0, 5});
  CHECK(repeats.hole({20, 0, 5}, 4000, xy_plane) == ig::Vec3{20, 0, 5});
  CHECK(PolarRepeats{90, {}, {}, {}}.hole({0, 5, 10}, 1, zx_plane) == ig::Vec3{10, 5, 0});  // from Z to X
}

TEST_CASE("the holes of a polar repeat turn before the program is mirrored") {
  const PolarRepeats repeats{90, {10, 0, 0}, AxisMap{}.mirrored(0), {}};
  CHECK(repeats.hole({-20, 0, 5}, 1, xy_plane) == ig::Vec3{-10, 10, 5});
}

namespace {

struct MirroredProgram {
  BlockDocument document;
  ScaleAndMirror maps = document.member<ScaleAndMirror>();
  PolarRepeatsInForce repeats = document.member<PolarRepeatsInForce>();
  ig::Block block = document.block();
  void scale_x(double factor, double center) {
    document.carry_name("Scaling.Term", "G51");
    document.carry("Scaling.Factor.X", factor);
    document.carry("Scaling.Center.X", center);
  }
  void mirror(const char* axis, double at) {
    document.carry_name("MirrorImage.Term", "G51.1");
    document.carry(std::string("MirrorImage.") + axis, at);
  }
};

}  // namespace

TEST_CASE("without scaling and mirror image a point is the programmed one") {
  const MirroredProgram p;
  CHECK(p.maps.programmed(p.block, {1, 2, 3}) == ig::Vec3{1, 2, 3});
  CHECK_FALSE(p.maps.swaps_sense(p.block, xy_plane));
}

TEST_CASE("programmed() takes mirror image and scaling off each axis") {
  MirroredProgram p;
  p.scale_x(2, 4);
  p.mirror("X", 10);
  p.mirror("Y", 0);
  CHECK(p.maps.axis(p.block, 0).position(4) == 16);  // the centre, mirrored
  CHECK(p.maps.axis(p.block, 0).position(3) == 18);
  CHECK(p.maps.programmed(p.block, {18, -2, 3}) == ig::Vec3{3, 2, 3});
}

TEST_CASE("arcs turn in the opposite sense where exactly one axis of the plane is mirrored") {
  MirroredProgram p;
  p.mirror("X", 0);
  CHECK(p.maps.swaps_sense(p.block, xy_plane));
  CHECK(p.maps.swaps_sense(p.block, zx_plane));
  CHECK_FALSE(p.maps.swaps_sense(p.block, yz_plane));
  p.mirror("Y", 0);
  CHECK_FALSE(p.maps.swaps_sense(p.block, xy_plane));
}

TEST_CASE("a negative scaling factor mirrors, and cancels the mirror image of its axis") {
  MirroredProgram p;
  p.scale_x(-1, 0);
  CHECK(p.maps.swaps_sense(p.block, xy_plane));
  p.mirror("X", 0);
  CHECK_FALSE(p.maps.swaps_sense(p.block, xy_plane));
}

TEST_CASE("holes of a repeat are rotated only where the program has an angle for them") {
  MirroredProgram p;
  CHECK_FALSE(p.repeats(p.block, xy_plane).has_value());
  p.mirror("X", 0);
  p.document.carry("PolarCoordinate.Turn_deg", 90);
  CHECK(p.repeats(p.block, xy_plane)->hole({-10, 0, 5}, 1, xy_plane) == ig::Vec3{0, 10, 5});
}

TEST_CASE("the angle of a hole pattern is used before that of G16, and without the mirror image") {
  MirroredProgram p;
  p.mirror("X", 0);
  p.document.carry("PolarCoordinate.Turn_deg", 90);
  p.document.carry("HolePattern.Turn_deg", 180);
  for (const char* axis : {"X", "Y", "Z"}) p.document.carry(std::string("HolePattern.Center.") + axis, 1);
  CHECK(p.repeats(p.block, xy_plane)->hole({3, 1, 5}, 1, xy_plane) == ig::Vec3{-1, 1, 5});
}
