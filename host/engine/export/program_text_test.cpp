#include "isogloss/engine/program_text.hpp"

#include <catch2/catch.hpp>
#include <map>

namespace isogloss {
namespace {

std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string out = "> ";
  const bool is_whole = BlockTemplate(text).fill(
      [&](std::string_view name, std::string_view format, std::string& to) {
        const auto found = values.find(name);
        if (found == values.end()) return false;
        to += format.empty() ? found->second : std::string(format) + "=" + found->second;
        return true;
      },
      out);
  return (is_whole ? "" : "nothing ") + out;
}

TEST_CASE("a template puts values in their places") {
  CHECK(filled("GO X{X} Y{Y:n}", {{"X", "1."}, {"Y", "2"}}) == "> GO X1. Yn=2");
  CHECK(filled("END", {}) == "> END");
  CHECK(filled("", {}) == "> ");
}

TEST_CASE("a part in brackets is left out without its value, and no other part") {
  CHECK(filled("GO[ X{X}][ Y{Y}] WET", {{"Y", "2."}}) == "> GO Y2. WET");
  CHECK(filled("[A{A}B{B} C]D", {{"A", "1"}}) == "> D");
  CHECK(filled("[A{A}]D", {{"A", "1"}}) == "> A1D");
}

TEST_CASE("a block without a value that it needs is not written") {
  CHECK(filled("GO X{X}", {}) == "nothing > ");
  CHECK(filled("[A{A}] X{X}", {{"A", "1"}}) == "nothing > ");
}

TEST_CASE("numbers of a block have a point, no exponent and no minus zero") {
  CHECK(block_number(100, false) == "100.");
  CHECK(block_number(-0.0, false) == "0.");
  CHECK(block_number(-1e-9, false) == "0.");
  CHECK(block_number(1.0000004, false) == "1.");
  CHECK(block_number(1.2500001, false) == "1.25");
  CHECK(block_number(12, false, true) == "12");
  CHECK(block_number(12.5, false, true) == "12.5");
  CHECK(block_number(1e-7, true) == "0.0000001");
  CHECK(block_number(0.1, true) == "0.1");
  CHECK(block_number(1e20, true) == "100000000000000000000.");
}

}  // namespace
}  // namespace isogloss
