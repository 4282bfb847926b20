#include "export/text_buffer.hpp"

#include <catch2/catch.hpp>

#include "test_document.hpp"

using namespace isogloss;

TEST_CASE("what is no UTF-8 becomes U+FFFD") {
  const std::pair<std::string, std::string> table[] = {
      {"plain", "plain"},
      {"\xc3\xa4\xe2\x82\xac\xf0\x9f\x99\x82", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x99\x82"},
      {"a\xff", "a\xef\xbf\xbd"},
      {"\xc3", "\xef\xbf\xbd"},                                                  // cut off
      {"\xc0\x80", "\xef\xbf\xbd\xef\xbf\xbd"},                                  // overlong
      {"\xe0\x80\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"},                  // overlong
      {"\xed\xa0\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"},                  // surrogate
      {"\xf4\x90\x80\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"},  // past U+10FFFF
      {"\xe2\x82g", "\xef\xbf\xbd\xef\xbf\xbdg"},
  };
  for (const auto& [in, out] : table) {
    CHECK(valid_utf8(in) == out);
    CHECK(json_string(in) == '"' + out + '"');
  }
}

TEST_CASE("JSON strings escape what JSON asks for") {
  CHECK(json_string("a\"b\\c/\n\r\t") == R"("a\"b\\c/\n\r\t")");
  CHECK(json_string(std::string("\0\x1f\x7f", 3)) == R"("\u0000\u001f\u007f")");
  CHECK(json_string("") == "\"\"");
}

TEST_CASE("the buffer keeps the order of what it is given") {
  StringOutput out;
  TextBuffer buffer(out);
  std::string expected;
  for (std::size_t size :
       {std::size_t{3}, std::size_t{100000}, std::size_t{100000}, std::size_t{500000}, std::size_t{1}}) {
    const std::string piece(size, static_cast<char>('a' + expected.size() % 26));
    buffer.append(piece);
    expected += piece;
  }
  CHECK(buffer.flush());
  CHECK(out.text == expected);
}

TEST_CASE("a closed output is told once and stays closed") {
  StringOutput out;
  out.is_open = false;
  TextBuffer buffer(out);
  buffer.append("lost");
  CHECK(buffer.ok());
  CHECK_FALSE(buffer.flush());
  out.is_open = true;
  buffer.append("late");
  CHECK_FALSE(buffer.flush());
  CHECK(out.text.empty());
}
