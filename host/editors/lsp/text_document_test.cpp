#include "lsp/text_document.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

namespace isogloss::editors {

TEST_CASE("places in UTF-16 and in bytes lead to the same bytes") {
  const std::string text = "a\xF0\x9F\x98\x80z\n\xC3\xA4G1\r\nend";
  const TextDocument wide(text, Columns::utf16), bytes(text, Columns::utf8);
  CHECK(wide.offset_of({0, 3}) == 5);
  CHECK(wide.position_of(5) == Position{0, 3});
  CHECK(bytes.offset_of({0, 5}) == 5);
  CHECK(wide.offset_of({1, 1}) == text.find("G1"));
  CHECK(wide.line(1) == "\xC3\xA4G1");
  for (std::size_t offset = 0; offset <= text.size(); ++offset) {
    if (offset < text.size() && ((text[offset] & 0xc0) == 0x80 || text[offset] == '\n')) continue;
    CHECK(wide.offset_of(wide.position_of(offset)) == offset);
    CHECK(bytes.offset_of(bytes.position_of(offset)) == offset);
  }
}

TEST_CASE("places outside the text are its nearest end") {
  const TextDocument text("G1\nX1\n", Columns::utf16);
  CHECK(text.offset_of({0, 99}) == 2);
  CHECK(text.offset_of({99, 0}) == 6);
  CHECK(text.position_of(99) == Position{2, 0});
  CHECK(TextDocument("", Columns::utf16).offset_of({5, 5}) == 0);
}

TEST_CASE("a run counts lines as its cursor does") {
  const TextDocument mixed("A\r\nB\rC\nD", Columns::utf16);
  CHECK(mixed.lines() == 4);
  CHECK(mixed.run_lines() == 3);
  CHECK(mixed.position_in_run(2, 3) == Position{2, 0});
  const TextDocument old("A\rB\r", Columns::utf16);
  CHECK(old.run_line(2) == "B");
  const TextDocument marked("\xEF\xBB\xBFG1", Columns::utf16);
  CHECK(marked.offset_in_run(1, 1) == 3);
}

TEST_CASE("changes give the same text as in one string, whatever their order of ends") {
  std::mt19937 random(5);
  const auto below = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  TextDocument document("G1 X1\nG2\n\nM30\n", Columns::utf16);
  for (int i = 0; i < 500; ++i) {
    const Position a{below(8), below(8)}, b{below(8), below(8)};
    const std::string with = std::string("X\nY").substr(below(3), below(3));
    std::string wanted = document.text();
    const auto [begin, end] = std::minmax({document.offset_of(a), document.offset_of(b)});
    wanted.replace(begin, end - begin, with);
    document.replace({a, b}, with);
    REQUIRE(document.text() == wanted);
    REQUIRE(document.lines() == TextDocument(wanted, Columns::utf16).lines());
  }
}

}  // namespace isogloss::editors
