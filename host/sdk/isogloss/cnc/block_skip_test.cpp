#include "isogloss/cnc/block_skip.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

TEST_CASE("the layers of block skip are digits, with commas and blanks between them") {
  CHECK(read_skip_layers("").none());
  CHECK(read_skip_layers("1").to_ullong() == 2);
  CHECK(read_skip_layers("1, 3,9").to_ullong() == (1u << 1 | 1u << 3 | 1u << 9));
}

TEST_CASE("a layer that does not exist is refused") {
  for (const char* wrong : {"0", "1;2", "a", "-1"}) CHECK_THROWS_AS(read_skip_layers(wrong), std::invalid_argument);
}
