#include "isogloss/cnc/scan.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace ig::cnc;

TEST_CASE("tape marks, skips, comments and the sequence number may stand before the first word") {
  for (const char* before : {"", "  ", "%", "/", "/3 ", "N10", "n 10 ", "(HOLE) ", "% /2 (A) N5 (B) "}) {
    CAPTURE(before);
    CHECK(stands_first(before, std::string_view(before).size()));
  }
  for (const char* before : {"X1", "N", "N#1", "(A", "G00 ", "/2 M08 ", ";"}) {
    CAPTURE(before);
    CHECK_FALSE(stands_first(before, std::string_view(before).size()));
  }
}

TEST_CASE("an expression ends where no operand follows") {
  const std::pair<std::string_view, std::string_view> cases[] = {{"#1 Y2", "#1"},
                                                                 {"#101Y2", "#101"},
                                                                 {"-#1", "-#1"},
                                                                 {"##1", "##1"},
                                                                 {"#[#1+2]Y2", "#[#1+2]"},
                                                                 {"#<a b> Y2", "#<a b>"},
                                                                 {"[1.+[2*3]] Y", "[1.+[2*3]]"},
                                                                 {"SIN[30.]X", "SIN[30.]"},
                                                                 {"#1+5.*#2 Y", "#1+5.*#2"},
                                                                 {"#1/2", "#1"},
                                                                 {"#1+Y", "#1"},
                                                                 {"[#1", "[#1"},
                                                                 {"12.5Y", "12.5"},
                                                                 {"", ""},
                                                                 {"Y2", ""},
                                                                 {"<a>", ""}};
  for (const auto& [text, expression] : cases) {
    CAPTURE(text);
    CHECK(text.substr(0, skip_expression(text, 0)) == expression);
  }
}

TEST_CASE("digits end at the first character that is none, wherever it stands in the text") {
  for (std::size_t digits = 0; digits < 20; ++digits)
    for (const std::string_view behind : {"", " ", "L", "/", ":", ".5", "\xb3 L", " L X+1 Y+2"}) {
      const std::string text = "N" + std::string(digits, '7') + std::string(behind);
      CAPTURE(text);
      CHECK(skip_digits(text, 1) == 1 + digits);
      CHECK(skip_digits(text, text.size()) == text.size());
    }
  static_assert(skip_digits("N12 L", 1) == 3);
}

TEST_CASE("an open bracket ends at a carriage return") {
  CHECK(skip_bracketed("[1+\r2]", 0) == 3);
  CHECK(block_end("G00\rX1", 0) == 3);
  CHECK(block_end("G00", 0) == 3);
}

TEST_CASE("a keyword makes an O-word; without one it is a program number") {
  for (const char* word : {"o100 sub", "O100SUB", "o<probe> call [1]", "o [#1] if [#2]", "o#1 endwhile"}) {
    CAPTURE(word);
    CHECK(begins_o_word(word, 0));
  }
  for (const char* word : {"O100", "O100 (SUB)", "O<PART>", "O100 SUBMIT", "O", "OSUB"}) {
    CAPTURE(word);
    CHECK_FALSE(begins_o_word(word, 0));
  }
}

TEST_CASE("characters are classified without case, and columns end at 65535") {
  CHECK(letter_index('A') == 0);
  CHECK(letter_index('z') == 25);
  for (const char c : {'@', '[', '`', '{', '1', ' ', '\0', '\xC4'}) CHECK(letter_index(c) > 25);
  CHECK(trim(" \ta b ") == "a b");
  CHECK(trim("  ").empty());
  CHECK(column(65534) == 65534);
  CHECK(column(70000) == 65535);
}

TEST_CASE("a name is read for 64 bytes, and no further than the text") {
  CHECK(skip_name_of("SIN[1]", 0, is_letter) == 3);
  CHECK(skip_name_of("SIN", 1, is_letter) == 3);
  CHECK(skip_name_of("SIN", 3, is_letter) == 3);
  CHECK(skip_name_of("1", 0, is_letter) == 0);
  const std::string letters(200, 'A');
  CHECK(skip_name_of(letters, 0, is_letter) == 64);
  CHECK(skip_name_of(letters, 100, is_letter) == 164);
  CHECK(skip_name_of(letters, 190, is_letter) == 200);
}

TEST_CASE("a block ends at a line feed or a carriage return, whichever comes first") {
  CHECK(block_end("X1", 0) == 2);
  CHECK(block_end("X1\rY2\n", 0) == 2);
  CHECK(block_end("X1\nY2\r", 0) == 2);
  CHECK(block_end("X1\nY2\r", 3) == 5);
  CHECK(block_end("X1", 2) == 2);
  CHECK(block_end("", 0) == 0);
}

TEST_CASE("a bracket that nothing closes goes to the end of the block") {
  CHECK(skip_bracketed("[1+[2]]X", 0) == 7);
  CHECK(skip_bracketed("[1+[2]X", 0) == 7);
  CHECK(skip_bracketed("(A\nX)", 0) == 2);
  CHECK(skip_bracketed("<<<", 1) == 3);
}
