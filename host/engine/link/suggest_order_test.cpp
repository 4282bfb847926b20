#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("one element moves where several could, and stays near its old place") {
  Plugin plugin("p");
  plugin.syntax("Late").after = {"A", "B", "C"};
  plugin.syntax("Early").before = {"A", "B"};
  for (const char* id : {"A", "B", "C", "D"}) plugin.syntax(id);
  Library library({});
  library.add(plugin.get());
  Hand late{"p"};
  for (const char* id : {"Late", "A", "B", "C", "D"}) late.add(id);
  CHECK(suggest_order(late.dialect, library) == Strings{"A", "B", "C", "Late", "D"});
  Hand early{"p"};
  for (const char* id : {"D", "A", "B", "C", "Early"}) early.add(id);
  CHECK(suggest_order(early.dialect, library) == Strings{"D", "Early", "A", "B", "C"});
}

TEST_CASE("an inherited element keeps its place where one of the dialect's own can move") {
  Plugin plugin("p");
  plugin.syntax("First").before = {"Second"};
  plugin.syntax("Between");
  plugin.syntax("Second");
  Library library({});
  library.add(plugin.get());
  for (const std::size_t own : {0, 2}) {
    Hand hand{"p"};
    hand.dialect.ancestors = {"base"};
    for (const char* id : {"Second", "Between", "First"}) hand.add(id).where.file = "base.xml";
    hand.dialect.chain[own].where.file = "hand.xml";
    const Strings expected = own == 0 ? Strings{"Between", "First", "Second"} : Strings{"First", "Second", "Between"};
    CHECK(suggest_order(hand.dialect, library) == expected);
  }
}

TEST_CASE("the shortest ring of constraints is told link by link") {
  Plugin plugin("p");
  plugin.syntax("A").before = {"B"};
  plugin.syntax("B").before = {"C"};
  plugin.syntax("C").before = {"A", "D"};
  plugin.syntax("D").before = {"B"};
  plugin.syntax("E").after = {"D"};
  Library library({});
  library.add(plugin.get());
  Hand hand{"p"};
  for (const char* id : {"A", "B", "D", "E"}) hand.add(id);
  CHECK(order_ring(hand.dialect, library).empty());
  hand.add("C");
  CHECK(order_ring(hand.dialect, library) == Strings{"A must stand before B: A declares it",
                                                     "B must stand before C: B declares it",
                                                     "C must stand before A: C declares it"});
}

TEST_CASE("a constraint against the order of the stages is a ring, too") {
  Plugin plugin("p");
  plugin.syntax("Reader").after = {"Mover"};
  plugin.syntax("Mover");
  Library library({});
  library.add(plugin.get());
  Hand hand{"p"};
  hand.add("Reader").stage = Stage::parsing;
  hand.add("Mover");
  CHECK(order_ring(hand.dialect, library) ==
        Strings{"Reader must stand before Mover: the stage Parsing comes before Logic",
                "Mover must stand before Reader: Reader declares it"});
}
