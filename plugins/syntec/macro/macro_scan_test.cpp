#include "macro/macro_scan.hpp"

#include <catch2/catch.hpp>

using namespace syntec;

TEST_CASE("the first word of a block tells which statement it is") {
  CHECK(statement_at("IF #1 = 1 THEN", 0) == Keyword::if_);
  CHECK(statement_at("endif;", 0) == Keyword::end_if);
  CHECK(statement_at("#1 := 1;", 0) == Keyword::assignment);
  CHECK(statement_at("AR[1] := 1;", 0) == Keyword::function);
  CHECK(statement_at("WAIT();", 0) == Keyword::function);
  CHECK(statement_at("2, 3: G00", 0) == Keyword::case_label);
  for (const char* const words : {"G01X1.", "X1=5.", "SP1=5.", "2 G00", "2 := 3", "\"TEXT\"", ";", ""})
    CHECK(statement_at(words, 0) == Keyword::none);
}

TEST_CASE("a statement ends with ; outside texts and comments") {
  StatementCollector s;
  MacroComment comment;
  const std::string_view line = "N1 #1 := \"A;B\" (* ; *) + 1; #2 := 2;";
  CHECK(s.add(line, 3, Keyword::assignment, comment) == line.find("; #2") + 1);
  CHECK(s.is_complete());
  CHECK(s.begin() == 3);
  CHECK(s.text() == "   #1 := \"A;B\"         + 1");
}

TEST_CASE("an opening ends with its word, and a statement may reach over lines and comments") {
  StatementCollector s;
  MacroComment comment;
  CHECK(s.add("IF #1 = 1 (* A", 0, Keyword::if_, comment) == 14);
  CHECK(s.is_begun());
  CHECK(comment.is_open);
  const std::string_view rest = "B *) OR #2 THEN G00 X1.;";
  CHECK(s.add(rest, 0, Keyword::if_, comment) == rest.find(" G00"));
  CHECK(s.is_complete());
  CHECK_FALSE(comment.is_open);
  CHECK(s.text().substr(s.offset()) == "     OR #2 THEN");
}

TEST_CASE("words stand for themselves, not for the beginning of others") {
  CHECK(find_word("#1 := TOOL TO 3", 0, "TO") == 11);
  CHECK(find_word("\"TO\" 3", 0, "TO") == 6);
  CHECK(is_word("DO", 0, "DO"));
  CHECK_FALSE(is_word("DONE", 0, "DO"));
}
