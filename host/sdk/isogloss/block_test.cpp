#include "isogloss/block.hpp"

#include <array>

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using isogloss_test::BlockDocument;

TEST_CASE("a block that is shown tells whether one of several fields has a value, or was written") {
  struct Shown {
    ig_view view;  // an ig_block begins with it
    std::array<ig_view_bits, 2> bits{};
  } shown;
  shown.view = {shown.bits.data(), nullptr, 100, 0};
  ig_host host{};
  host.flags = IG_HOST_SHOWS_BLOCKS;
  const ig::Block block(&host, reinterpret_cast<ig_block*>(&shown));

  constexpr ig_field of_a_record = 1u << 20;
  const ig::AnyOf some{3, 70, IG_NO_FIELD, 64}, with_a_record{3, 70, of_a_record, 64};
  CHECK_FALSE(block.has_any(some));
  CHECK_FALSE(block.has_any(with_a_record));
  CHECK_FALSE(ig::Block(&host, reinterpret_cast<ig_block*>(&shown)).has_any(ig::AnyOf{}));
  for (const ig_field other : {2u, 4u, 6u, 65u, 69u, 71u})
    shown.bits[other / 64].present |= std::uint64_t{1} << other % 64;
  CHECK_FALSE(block.has_any(some));
  CHECK_FALSE(block.has_any(with_a_record));
  for (const ig_field one : {3u, 64u, 70u}) {
    CAPTURE(one);
    const std::uint64_t bit = std::uint64_t{1} << one % 64;
    shown.bits[one / 64].present |= bit;
    CHECK(block.has_any(some));
    CHECK(block.has_any(with_a_record));
    CHECK_FALSE(block.is_any_fresh(some));
    shown.bits[one / 64].fresh |= bit;
    CHECK(block.is_any_fresh(some));
    CHECK(block.is_any_fresh(with_a_record));
    shown.bits[one / 64].present &= ~bit;
    shown.bits[one / 64].fresh &= ~bit;
  }
}

TEST_CASE("a block that is not shown is asked about each of several fields") {
  BlockDocument document;
  struct Members {
    ig::In<double> x{"MachineCoordinate.X"}, y{"MachineCoordinate.Y"};
    ig::AnyOf both{x.id(), y.id()};
  };
  const Members members = document.member<Members>();
  CHECK_FALSE(document.block().has_any(members.both));
  document.carry("MachineCoordinate.Y", 3);
  CHECK(document.block().has_any(members.both));
  CHECK_FALSE(document.block().is_any_fresh(members.both));
  document.put_word("MachineCoordinate.X", 3);
  CHECK(document.block().is_any_fresh(members.both));
}
