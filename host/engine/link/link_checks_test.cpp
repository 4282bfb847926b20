#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("the written order is verified, for every instance, and both places are shown") {
  Plugin plugin("p");
  plugin.syntax("First").before = {"Second"};
  plugin.syntax("Second");
  plugin.syntax("Third").after = {"Second"};
  DiagnosticList found;
  Hand hand{"p"};
  hand.add("Third");
  hand.add("Second");
  hand.add("First");
  CHECK(faults(hand, {&plugin}, &found) == Strings{"IG-0206 2", "IG-0207 4"});
  CHECK(found.all[0].message == "Third must stand after Second (hand.xml:3:7)");
  CHECK(found.all[1].message == "First must stand before Second (hand.xml:3:7)");

  Hand twice{"p"};
  twice.add("First");
  twice.add("Second");
  twice.add("Third");
  twice.add("Second").alias = "again";
  CHECK(faults(twice, {&plugin}, &found) == Strings{"IG-0206 4"});
  CHECK(found.all[0].message == "Third must stand after again (hand.xml:5:7)");

  Library library({});
  library.add(plugin.get());
  CHECK(suggest_order(hand.dialect, library) == Strings{"First", "Second", "Third"});
  CHECK(suggest_order(twice.dialect, library) == Strings{"First", "Second", "again", "Third"});
}

TEST_CASE("an order that cannot be is not suggested") {
  Plugin plugin("p");
  plugin.syntax("A").before = {"B"};
  plugin.syntax("B").before = {"A"};
  Hand hand{"p"};
  hand.add("A");
  hand.add("B");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0207 3"});
  Library library({});
  library.add(plugin.get());
  CHECK(suggest_order(hand.dialect, library).empty());
}

TEST_CASE("a required field needs a writer: a syntax or the initial state") {
  Plugin plugin("p");
  plugin.syntax("Needy").fields = {field("Acme.Level", IG_READ | IG_REQUIRED)};
  plugin.syntax("Writer").fields = {field("Acme.Level", IG_WRITE)};
  plugin.syntax("Content").fields = {field("Acme.Level", IG_READ)};
  Hand alone{"p"};
  alone.add("Needy");
  CHECK(faults(alone, {&plugin}) == Strings{"IG-0208 2"});
  Hand with_initial{"p"};
  with_initial.add("Needy");
  with_initial.initial("Acme.Level", "1");
  CHECK(faults(with_initial, {&plugin}).empty());
  Hand with_writer{"p"};
  with_writer.add("Needy");
  with_writer.add("Writer");
  CHECK(faults(with_writer, {&plugin}).empty());
  Hand optional{"p"};
  optional.add("Content");
  CHECK(faults(optional, {&plugin}).empty());
}

TEST_CASE("an exclusive slot is claimed once, or by override") {
  Plugin plugin("p");
  plugin.syntax("A").out.exclusive_slot = "work offset";
  plugin.syntax("B").out.exclusive_slot = "work offset";
  plugin.syntax("C").out.first_writer_slot = "motion";
  plugin.syntax("D").out.first_writer_slot = "motion";
  DiagnosticList found;
  Hand hand{"p"};
  hand.add("A");
  hand.add("B");
  CHECK(faults(hand, {&plugin}, &found) == Strings{"IG-0210 3"});
  CHECK(found.all[0].message == "B claims the slot 'work offset', which A holds already (hand.xml:2:7)");
  hand.dialect.chain[1].override_slot = true;
  CHECK(faults(hand, {&plugin}).empty());
  Hand shared{"p"};
  shared.add("C");
  shared.add("D");
  CHECK(faults(shared, {&plugin}).empty());
}

TEST_CASE("a service needs a provider unless it is optional") {
  Plugin plugin("p");
  plugin.syntax("Needs").services = {{sizeof(ig_service_decl), 0, "test.offset/1", ""}};
  plugin.syntax("Likes").services = {{sizeof(ig_service_decl), 1, "test.offset/1", ""}};
  plugin.dependency("Table").provides = {"other/1", "test.offset/1"};
  Hand hand{"p"};
  hand.add("Needs");
  hand.add("Likes");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0211 2"});
  hand.depend("Table");
  CHECK(faults(hand, {&plugin}).empty());
}

TEST_CASE("what is written and never read is noted") {
  Plugin plugin("p");
  plugin.syntax("Writer").fields = {field("Acme.Level", IG_WRITE),
                                    field("Feedrate.FeedrateValue", IG_WRITE, IG_NUMBER)};
  plugin.syntax("Reader").fields = {field("Acme.Level", IG_PREVIOUS)};
  DiagnosticList found;
  Hand hand{"p"};
  hand.add("Writer");
  CHECK(faults(hand, {&plugin}, &found) == Strings{"IG-0212 2"});
  CHECK(found.all[0].severity == Severity::note);
  hand.add("Reader");
  CHECK(faults(hand, {&plugin}).empty());
}

TEST_CASE("what a syntax remembers from block to block may be for itself, what it writes for the block is not") {
  Plugin plugin("p");
  plugin.syntax("Remembers").fields = {field("Acme.State", IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_MODAL)};
  plugin.syntax("Mutters").fields = {field("Acme.Word", IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK)};
  Hand hand{"p"};
  hand.add("Remembers");
  CHECK(faults(hand, {&plugin}).empty());
  hand.add("Mutters");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0212 3"});
}
