#include "isogloss/cnc/program_name.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace ig::cnc;

TEST_CASE("a numbered name is a letter and a number, with zeros up to the digits that were asked for") {
  CHECK(NumberedName('O', 3).text() == "O3");
  CHECK(NumberedName('O', 3, 4).text() == "O0003");
  CHECK(NumberedName('\0', 3, 4).text() == "0003");
  CHECK(NumberedName('O', 12345, 4).text() == "O12345");
  CHECK(NumberedName('O', 7, 99).text() == "O00000000000000000007");  // never more than 20 digits
  CHECK(NumberedName('N', INT64_MAX).text() == "N9223372036854775807");
}

TEST_CASE("leading zeros of the program's text do not count in a name") {
  CHECK(numbered_name('O', "0003")->text() == "O3");
  CHECK(numbered_name('N', "000")->text() == "N0");
  CHECK(numbered_name('N', "9223372036854775807").has_value());
}

TEST_CASE("text that is not a whole number of 64 bits is no numbered name") {
  for (const char* text : {"", "A", "12A", "1.5", " 1", "+1", "9223372036854775808"}) {
    CAPTURE(text);
    CHECK_FALSE(numbered_name('O', text).has_value());
  }
}

namespace {

std::vector<std::string> file_names(std::int64_t number) {
  const ProgramFileNames names(number);
  std::vector<std::string> out;
  for (const ig_text& name : names.list()) out.emplace_back(ig::to_view(name));
  return out;
}

}  // namespace

TEST_CASE("a number with a sign names nothing") {
  CHECK_FALSE(numbered_name('O', "-5").has_value());
  CHECK_FALSE(numbered_name('O', "+5").has_value());
}

TEST_CASE("the file of a program may carry the O, and zeros to 4, 5 or 8 digits; each name is listed once") {
  using Names = std::vector<std::string>;
  CHECK(file_names(3) == Names{"O0003", "0003", "O3", "3", "O00003", "00003", "O00000003", "00000003"});
  CHECK(file_names(1234) == Names{"O1234", "1234", "O01234", "01234", "O00001234", "00001234"});
  CHECK(file_names(123456789) == Names{"O123456789", "123456789"});
}
