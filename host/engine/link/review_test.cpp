#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

namespace {

ig_status do_nothing(void*, const ig_host*, ig_block*) { return IG_UNCHANGED; }

Strings reviewed(Hand& hand, Plugin& plugin) {
  Library library({});
  library.add(plugin.get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked != nullptr);
  Strings out;
  for (const Diagnostic& d : review(*linked)) out.push_back(d.code + " " + std::to_string(d.where.line));
  return out;
}

}  // namespace

TEST_CASE("who is woken only by those that nothing wakes is never called") {
  Plugin plugin("p");
  plugin.syntax("Sleeper").fields = {field("Acme.A", IG_READ | IG_WAKE), field("Acme.B", IG_WRITE)};
  plugin.syntax("Follower").fields = {field("Acme.B", IG_READ | IG_WAKE)};
  plugin.syntax("Itself").fields = {field("Acme.C", IG_READ | IG_WRITE | IG_WAKE)};
  plugin.syntax("Waker").fields = {field("Acme.D", IG_READ | IG_WAKE), field("Acme.A", IG_WRITE)};
  for (Syntax& s : plugin.syntaxes) s.out.build = do_nothing;
  Hand alone{"p"};
  for (const char* id : {"Sleeper", "Follower", "Itself"}) alone.add(id);
  CHECK(reviewed(alone, plugin) == Strings{"IG-0165 2", "IG-0165 3", "IG-0165 4"});

  Hand with_waker{"p"};
  for (const char* id : {"Waker", "Sleeper", "Follower"}) with_waker.add(id);
  with_waker.initial("Acme.D", "1");
  CHECK(reviewed(with_waker, plugin).empty());
}
