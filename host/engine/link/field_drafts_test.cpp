#include <catch2/catch.hpp>

#include <deque>
#include <set>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

namespace {

/// A chain of one plugin's syntaxes that links.
struct LinkedHand {
  LinkedHand(Hand& hand, Plugin& plugin) {
    library.add(plugin.get());
    DiagnosticList found;
    linked = link(hand.dialect, library, found, LinkMode::whole);
    REQUIRE(linked != nullptr);
  }
  Library library{{}};
  std::unique_ptr<LinkedDialect> linked;
  const Layout& layout() const { return linked->layout; }
};

}  // namespace

TEST_CASE("one field has one type and one life, also across plugins") {
  Plugin one("one"), two("two");
  one.syntax("Number").fields = {field("Acme.Level", IG_WRITE, IG_NUMBER, IG_LIFE_MODAL)};
  two.syntax("Symbol").fields = {field("Acme.Level", IG_READ, IG_SYMBOL, IG_LIFE_MODAL)};
  two.syntax("Block").fields = {field("Acme.Level", IG_READ, IG_NUMBER, IG_LIFE_BLOCK)};
  two.syntax("Standard").fields = {field("Feedrate.FeedrateValue", IG_READ, IG_TEXT)};
  two.syntax("Records").fields = {field("CompoundMotion.Items[].Dwell.Time", IG_WRITE, IG_SYMBOL)};
  for (const char* other : {"Symbol", "Block"}) {
    Hand hand{"one", "two"};
    hand.add("Number");
    hand.add(other);
    CHECK(faults(hand, {&one, &two}) == Strings{"IG-0209 4"});
  }
  Hand standard{"two"};
  standard.add("Standard");
  standard.add("Records");
  CHECK(faults(standard, {&two}) == Strings{"IG-0209 2", "IG-0209 3"});
}

TEST_CASE("initial values and literal patterns name fields that exist, and are of their type") {
  Plugin plugin("p");
  Syntax& syntax = plugin.syntax("S");
  syntax.options = {option("lengths", IG_OPTION_FIELDS, "Parsing.*.X")};
  syntax.fields = {field("@lengths", IG_READ | IG_PATTERN), field("Acme.Level", IG_READ)};
  Hand hand{"p"};
  hand.add("S");
  hand.initial("Acme.Levle", "1");
  hand.initial("Acme.Level", "high");
  hand.initial("SpindleSpeed.SpindleSpeed_rpm", "1e3");
  hand.initial("ToolChange.ToolId", "1.5");
  hand.initial("PlaneSelect.Term", "anything");
  hand.initial("Source.Line", "1000000000000000000000000");
  DiagnosticList found;
  CHECK(faults(hand, {&plugin}, &found) == Strings{"IG-0214 3", "IG-0215 4", "IG-0215 5", "IG-0215 6", "IG-0215 8"});
  CHECK(found.all[0].hint == "did you mean Acme.Level?");
}

TEST_CASE("a pattern of the syntax itself finds the words of codes of one kind") {
  Plugin plugin("p");
  Syntax& cycles = plugin.syntax("Cycles");
  cycles.fields = {field("Parsing.G181", IG_TAKE | IG_WAKE, IG_CODE), field("Parsing.G181.X", IG_TAKE),
                   field("Parsing.G5", IG_TAKE | IG_WAKE, IG_CODE), field("Parsing.G5.X", IG_TAKE)};
  cycles.fields[0].unit = "canned-cycle";
  Syntax& family = plugin.syntax("Family");
  family.fields = {field("Parsing.*{canned-cycle}.X", IG_READ | IG_PATTERN)};
  Hand hand{"p"};
  hand.add("Family");
  hand.add("Cycles");
  const LinkedHand chain(hand, plugin);
  const std::vector<ig_field>& ids = chain.linked->chain[0].expansions.at(0);
  REQUIRE(ids.size() == 1);
  CHECK(chain.layout().fields[ids[0]].path == "Parsing.G181.X");
}

TEST_CASE("a chain that asks for too many fields of the block before does not link") {
  Plugin plugin("p");
  Syntax& curious = plugin.syntax("Curious");
  std::vector<std::string> paths;
  for (int i = 0; i < 64; ++i) paths.push_back("Acme.Field" + std::to_string(i));
  for (const std::string& path : paths) {
    curious.fields.push_back(field(path.c_str(), IG_WRITE, IG_NUMBER, IG_LIFE_MODAL));
    curious.fields.push_back(field(path.c_str(), IG_PREVIOUS, IG_NUMBER, IG_LIFE_MODAL));
  }
  Hand hand{"p"};
  hand.add("Curious");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0224 0"});
  curious.fields.resize(126);
  CHECK(faults(hand, {&plugin}).empty());
}

TEST_CASE("a pattern of the dialect that matches no field is told; a default is not") {
  Plugin plugin("p");
  Syntax& lengths = plugin.syntax("Lengths");
  lengths.fields = {field("@words", IG_TAKE | IG_PATTERN)};
  lengths.options = {option("words", IG_OPTION_FIELDS, "Parsing.*.Q")};
  plugin.syntax("Reader").fields = {field("Parsing.X", IG_TAKE)};
  Hand by_default{"p"};
  by_default.add("Reader");
  by_default.add("Lengths");
  CHECK(faults(by_default, {&plugin}).empty());
  Hand given{"p"};
  given.add("Reader");
  given.add("Lengths", {{"words", "Parsing.? Parsing.*.X"}});
  DiagnosticList found;
  CHECK(faults(given, {&plugin}, &found) == Strings{"IG-0244 4"});
  CHECK(found.all[0].message.find("'Parsing.*.X'") != std::string::npos);
}

TEST_CASE("X Y Z of a section lie side by side in one word of bits, and so do their values from before the block") {
  constexpr std::uint32_t remembers = IG_READ | IG_WRITE | IG_PREVIOUS;
  // However many numbers stand before them.
  for (int before = 0; before <= 64; ++before) {
    CAPTURE(before);
    const bool has_previous = GENERATE(false, true);
    const std::uint32_t access = has_previous ? remembers : IG_READ | IG_WRITE;
    std::vector<std::string> paths;
    for (int i = 0; i < before + 5; ++i) paths.push_back("Acme.N" + std::to_string(i));
    Plugin plugin("p");
    std::vector<ig_field_decl>& fields = plugin.syntax("Remembers").fields;
    for (int i = 0; i < before; ++i)
      fields.push_back(field(paths[static_cast<std::size_t>(i)].c_str(), IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_MODAL));
    for (const char* path : {"Acme.X", "Acme.Y", "Acme.Z", "Other.X", "Other.Y", "Other.Z"})
      fields.push_back(field(path, access, IG_NUMBER, IG_LIFE_MODAL));
    for (int i = before; i < before + 5; ++i)
      fields.push_back(field(paths[static_cast<std::size_t>(i)].c_str(), IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_MODAL));
    Hand hand{"p"};
    hand.add("Remembers");
    const LinkedHand chain(hand, plugin);
    const Layout& layout = chain.layout();
    const auto copy_of = [&](ig_field f) {
      ig_field copy = 0;
      while (copy < layout.fields.size() && layout.fields[copy].previous_of != f) ++copy;
      return copy;
    };
    for (const char* section : {"Acme.", "Other."}) {
      const auto id = [&](const char* axis) { return layout.id(std::string(section) + axis); };
      CHECK(id("Y") == id("X") + 1);
      CHECK(id("Z") == id("X") + 2);
      CHECK(id("X") / 64 == id("Z") / 64);
      if (!has_previous) continue;
      CHECK(copy_of(id("Y")) == copy_of(id("X")) + 1);
      CHECK(copy_of(id("Z")) == copy_of(id("X")) + 2);
      CHECK(copy_of(id("X")) / 64 == copy_of(id("Z")) / 64);
    }
    for (const std::string& path : paths) CHECK(layout.find(path));
  }
}

TEST_CASE("codes and words begin a word of bits, however many fields stand before them") {
  for (int before = 0; before <= 64; before += 9) {
    CAPTURE(before);
    Plugin plugin("p");
    std::vector<ig_field_decl>& fields = plugin.syntax("Some").fields;
    std::deque<std::string> paths;  // they stay where they are
    const auto add = [&](const std::string& path, std::uint32_t access, ig_type type, ig_life life) {
      fields.push_back(field(paths.emplace_back(path).c_str(), access, type, life));
    };
    for (int i = 0; i < before; ++i) add("Acme.M" + std::to_string(i), IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_MODAL);
    for (const char* axis : {"X", "Y", "Z"}) add(std::string("Acme.") + axis, IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK);
    for (int i = 0; i < 140; ++i) add("Acme.B" + std::to_string(i), IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK);
    for (int i = 0; i < 67; ++i) add("Parsing.G" + std::to_string(900 + i), IG_TAKE | IG_WAKE, IG_CODE, IG_LIFE_BLOCK);
    for (int i = 0; i < 64; ++i) add("Parsing.W" + std::to_string(i), IG_TAKE, IG_NUMBER, IG_LIFE_WORD);
    Hand hand{"p"};
    hand.add("Some");
    const LinkedHand chain(hand, plugin);
    const Layout& layout = chain.layout();
    for (int i = 0; i < 64; ++i) {
      CHECK(layout.id("Parsing.G" + std::to_string(900 + i)) % 64 == static_cast<ig_field>(i));
      CHECK(layout.id("Parsing.W" + std::to_string(i)) % 64 == static_cast<ig_field>(i));
    }
    const ig_field x = layout.id("Acme.X");
    CHECK(layout.id("Acme.Y") == x + 1);
    CHECK(layout.id("Acme.Z") == x + 2);
    CHECK(x % 64 <= 61);
    for (const std::string& path : paths) CHECK(layout.find(path));
  }
}

TEST_CASE("the words of each code have their bits in one word, and points stay whole") {
  Plugin plugin("p");
  Syntax& some = plugin.syntax("Some");
  Syntax& others = plugin.syntax("Others");
  std::deque<std::string> paths;  // they stay where they are
  const auto add = [&](Syntax& to, const std::string& path, std::uint32_t access, ig_type type = IG_NUMBER) {
    to.fields.push_back(field(paths.emplace_back(path).c_str(), access, type));
  };
  for (int code = 1; code <= 40; ++code) {  // all X Y Z first, so that the words of one code are mentioned apart
    const std::string path = "Parsing.G" + std::to_string(900 + code);
    add(some, path, IG_TAKE | IG_WAKE, IG_CODE);
    for (const char* letter : {".X", ".Y", ".Z"}) add(some, path + letter, IG_TAKE);
  }
  for (int code = 1; code <= 40; ++code)
    for (const char letter : std::string_view("RQPIJKLF").substr(0, static_cast<std::size_t>(code) % 9))
      add(others, "Parsing.G" + std::to_string(900 + code) + "." + letter, IG_TAKE);
  Hand hand{"p"};
  hand.add("Some");
  hand.add("Others");
  const LinkedHand chain(hand, plugin);
  const Layout& layout = chain.layout();
  std::size_t apart = 0;
  for (int code = 1; code <= 40; ++code) {
    const std::string path = "Parsing.G" + std::to_string(900 + code) + ".";
    std::set<ig_field> places;
    for (ig_field f = 0; f < layout.fields.size(); ++f)
      if (layout.fields[f].path.starts_with(path)) places.insert(f / 64);
    REQUIRE(!places.empty());
    apart += places.size() - 1;
    const ig_field x = layout.id(path + "X");
    CHECK(layout.id(path + "Y") == x + 1);
    CHECK(layout.id(path + "Z") == x + 2);
    CHECK(x % 64 <= 61);
  }
  CHECK(apart <= 4);  // one at each border of two words into which none of those left fits
}
