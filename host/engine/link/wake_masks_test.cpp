#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("a wake-while on a field that no block begins with is told") {
  Plugin plugin("p");
  plugin.syntax("Modal").fields = {field("Acme.Mode", IG_WRITE | IG_WAKE_WHILE, IG_NUMBER, IG_LIFE_MODAL)};
  plugin.syntax("Word").fields = {field("Parsing.X", IG_READ | IG_WAKE_WHILE)};
  plugin.syntax("Block").fields = {field("Acme.Count", IG_READ | IG_WRITE | IG_WAKE_WHILE)};
  plugin.syntax("Record").fields = {field("CompoundMotion.Items[].Dwell.Time", IG_READ | IG_WAKE_WHILE)};
  Hand hand{"p"};
  for (const char* id : {"Modal", "Word", "Block", "Record"}) hand.add(id);
  const Strings all = faults(hand, {&plugin});
  CHECK(std::count(all.begin(), all.end(), "IG-0242 4") == 1);
  CHECK(std::count(all.begin(), all.end(), "IG-0242 5") == 1);
  CHECK(std::count_if(all.begin(), all.end(), [](const std::string& s) { return s.starts_with("IG-0242"); }) == 2);
}

TEST_CASE("a new record wakes who waits for its list") {
  static int woken;
  woken = 0;
  Plugin plugin("p");
  Syntax& writer = plugin.syntax("Writer");
  writer.fields = {field("Acme.Count", IG_WRITE | IG_WAKE_WHILE, IG_NUMBER, IG_LIFE_MODAL),
                   field("CompoundMotion.Items[].Dwell.Time", IG_WRITE)};
  writer.out.create = [](const ig_link_api*, ig_link*, const ig_field* ids, void** self) -> ig_status {
    static ig_field item;
    item = ids[1];
    *self = &item;
    return IG_CHANGED;
  };
  writer.out.build = [](void* self, const ig_host* host, ig_block* block) -> ig_status {
    const ig_value second{.number = 1};
    return host->append(block, static_cast<const ig_field*>(self), 1, &second) != 0 ? IG_CHANGED : IG_FAILED;
  };
  Syntax& waiter = plugin.syntax("Waiter");
  waiter.fields = {field("CompoundMotion.Items[].Dwell.Time", IG_READ | IG_WAKE)};
  waiter.out.build = [](void*, const ig_host*, ig_block*) -> ig_status { return ++woken, IG_UNCHANGED; };
  Hand hand{"p"};
  hand.add("Writer");
  hand.add("Waiter");
  hand.initial("Acme.Count", "1");
  CHECK(run_one_block(hand, plugin).all.empty());
  CHECK(woken == 1);
}
