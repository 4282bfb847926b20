#include "inspection/turning_signs.hpp"

#include <catch2/catch.hpp>

namespace iso {
namespace {

std::string sign_in(std::string_view text, std::size_t piece = 7) {
  TurningSigns signs("T??? T???? G50+S G70+P+Q G71+P+Q", "M06", 'Y', 2);
  for (std::size_t at = 0; at < text.size(); at += piece)
    if (!signs.read(text.substr(at, piece))) return "mills";
  const auto found = signs.result();
  return found ? found->words + " in " + std::to_string(found->line) : "";
}

TEST_CASE("the signs of a turning program are found with their line", "[turning]") {
  CHECK(sign_in("%\nO1\nT0101\nG00 X20. Z2.\n") == "T0101 in 3");
  CHECK(sign_in("N1 t101 g0 x20.") == "T101 in 1");
  CHECK(sign_in("O1\r\nG21\r\nS2000 G50\r\n") == "G50 S2000 in 3");
  CHECK(sign_in("O1\rG71U2.R1.\rG071P10Q20U.5\r") == "G071 P10 Q20 in 3");
  CHECK(sign_in("T1 M6\nG70 P10 Q20\n") == "G70 P10 Q20 in 2");
}

TEST_CASE("a milling program has no sign", "[turning]") {
  CHECK(sign_in("T1 M06\nG00 X1. Y1.\nG50\nS2000 M03\nG70 I10. J0 L6\n").empty());
  CHECK(sign_in("T1001\nG00 Z5.\nM06\n").empty());
  CHECK(sign_in("T0101M6\n").empty());
  CHECK(sign_in("(T0101) G00 X1.\nG01 Z2. ; G50 S100\nT#101\nT12\nT12345\nT101.5\n").empty());
  CHECK(sign_in("#1=SQRT[2]\nPOPEN\nSETVN101\n").empty());
}

TEST_CASE("a third Y makes a text a milling program", "[turning]") {
  CHECK(sign_in("T0101\nG00 X1. Y1.\nY2.\n") == "T0101 in 1");
  CHECK(sign_in("T0101\nG00 X1. Y1.\nY2.\nY#3\n") == "mills");
  CHECK(sign_in("T0101\n(Y1 Y2 Y3)\nYES\n") == "T0101 in 1");
}

}  // namespace
}  // namespace iso
