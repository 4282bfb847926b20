#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("a syntax that refuses to start is told with its reason") {
  Plugin plugin("p");
  Syntax& syntax = plugin.syntax("Refuses");
  syntax.out.create = [](const ig_link_api* api, ig_link* link, const ig_field*, void**) -> ig_status {
    constexpr std::string_view reason = "not today";
    api->fail(link, {reason.data(), reason.size()});
    return IG_FAILED;
  };
  Hand hand{"p"};
  hand.add("Refuses");
  Library library({});
  library.add(plugin.get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked);
  CHECK_THROWS_AS(Chain(*linked, {}, found), std::runtime_error);
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].code == "IG-0308");
  CHECK(found.all[0].where.line == 2);
  CHECK_THAT(found.all[0].message, Catch::Contains("Refuses") && Catch::Contains("not today"));
}

TEST_CASE("a row that its dependency cannot look at is refused") {
  Plugin plugin("p");
  Dependency& table = plugin.dependency("Table");
  table.out.row_element = "Row";
  table.out.row_key = "id";
  table.columns = {column("X")};
  table.out.row_fault = [](void*, ig_text row) -> ig_text {
    if (row.size == 3) throw 5;
    return row.size == 1 ? ig_text{} : ig_text{"one letter", 10};
  };
  Hand hand{"p"};
  DependencyElement& element = hand.depend("Table");
  for (const char* name : {"a", "bb", "ccc"}) {
    TableRow row{"Row", {}, hand.next()};
    row.attributes.push_back({"id", name, row.where});
    element.rows.push_back(row);
  }
  DiagnosticList found;
  Library library({});
  library.add(plugin.get());
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked != nullptr);
  CHECK_THROWS_AS(Chain(*linked, {}, found), std::runtime_error);
  REQUIRE(found.all.size() == 2);
  CHECK(found.all[0].code == "IG-0432");
  CHECK(found.all[0].message.find("'bb': one letter") != std::string::npos);
  CHECK(found.all[1].code == "IG-0350");
}

TEST_CASE("a syntax that stays idle is created, and never called") {
  static int created, built, inspected;
  created = built = inspected = 0;
  for (const bool is_idle : {false, true}) {
    Plugin plugin("p");
    Syntax& wakes = plugin.syntax("Wakes");
    wakes.fields = {field("Test.X", IG_READ | IG_WRITE | IG_WAKE, IG_NUMBER, IG_LIFE_BLOCK)};
    wakes.out.build = [](void*, const ig_host*, ig_block*) -> ig_status { return ++built, IG_UNCHANGED; };
    Syntax& while_on = plugin.syntax("WakesWhile");
    while_on.fields = {field("Test.State", IG_READ | IG_WRITE | IG_WAKE_WHILE, IG_NUMBER, IG_LIFE_MODAL)};
    while_on.out.build = wakes.out.build;
    Syntax& inspects = plugin.syntax("Inspects");
    inspects.out.inspects = 1;
    inspects.out.build = [](void*, const ig_host*, ig_block*) -> ig_status { return ++inspected, IG_UNCHANGED; };
    for (Syntax* s : {&wakes, &while_on, &inspects})
      s->out.create = is_idle ? [](const ig_link_api* api, ig_link* link, const ig_field*, void** self) -> ig_status {
        api->idle(link);
        *self = nullptr;
        return ++created, IG_CHANGED;
      }
      : [](const ig_link_api*, ig_link*, const ig_field*, void** self) -> ig_status {
          *self = nullptr;
          return ++created, IG_CHANGED;
        };
    Hand hand{"p"};
    hand.add("Wakes");
    hand.add("WakesWhile");
    hand.add("Inspects", {}, Stage::inspection);
    Library library({});
    library.add(plugin.get());
    DiagnosticList found;
    const auto linked = link(hand.dialect, library, found);
    REQUIRE(linked);
    created = built = inspected = 0;
    Chain chain(*linked, {}, found);
    CHECK(created == 3);
    chain.document().set(linked->layout.id("Test.State"), {.number = 1});
    chain.begin_block({"t", 1, 0, "?"});
    chain.document().set(linked->layout.id("Test.X"), {.number = 1});
    chain.document().add_leftover(IG_LEFT_TEXT, IG_NO_FIELD, 0, 1, "?");
    chain.run(chain.document(), 0, 3);
    CHECK(built == (is_idle ? 0 : 2));
    CHECK(inspected == (is_idle ? 0 : 1));
    CHECK(chain.build(0) == IG_UNCHANGED);
  }
}

TEST_CASE("what the run gives a file for answers before what the dialect names first") {
  static int first_table, second_table;
  Plugin plugin("p");
  const auto provide = [&](const char* id, auto answer) {
    Dependency& d = plugin.dependency(id);
    d.provides = {"test.answer/1"};
    d.out.row_element = "Row";
    d.out.row_key = "name";
    d.columns = {column("Value")};
    d.out.create = [](const ig_link_api*, ig_link*, const ig_field*, void** self) -> ig_status {
      static int anything;
      *self = &anything;
      return IG_CHANGED;
    };
    d.out.service = answer;
  };
  provide("First", [](void*, const char*) -> const void* { return &first_table; });
  provide("Second", [](void*, const char*) -> const void* { return &second_table; });
  Hand hand{"p"};
  hand.depend("First");
  hand.depend("Second");
  Library library({});
  library.add(plugin.get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked);
  const auto answers = [&](std::initializer_list<const char*> given) {
    ChainSettings settings;
    for (const char* id : given) settings.dependencies.push_back({id, id, {}, {}, {}, {}});
    return Chain(*linked, settings, found).service("test.answer/1");
  };
  CHECK(answers({}) == &first_table);
  CHECK(answers({"Second"}) == &second_table);
  CHECK(answers({"First", "Second"}) == &second_table);
  CHECK(answers({"Second", "First"}) == &first_table);
}

TEST_CASE("a run that makes more names than there is room for is told so") {
  Plugin plugin("p");
  Syntax& namer = plugin.syntax("Namer");
  namer.fields = {field("Acme.Count", IG_READ | IG_WAKE_WHILE, IG_NUMBER, IG_LIFE_MODAL)};
  namer.out.build = [](void*, const ig_host* host, ig_block* block) -> ig_status {
    for (int i = 0; i < 1'000'001; ++i) {
      const std::string name = "N" + std::to_string(i);
      if (host->symbol(block, {name.data(), name.size()}) == 0) return IG_UNCHANGED;
    }
    return IG_FAILED;
  };
  Hand hand{"p"};
  hand.add("Namer");
  hand.initial("Acme.Count", "1");
  const DiagnosticList found = run_one_block(hand, plugin);
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].code == "IG-0409");
}

TEST_CASE("a block that makes more steps than there is room for is told so, once") {
  Plugin plugin("p");
  Syntax& writer = plugin.syntax("Writer");
  writer.fields = {field("Acme.Count", IG_READ | IG_WAKE_WHILE, IG_NUMBER, IG_LIFE_MODAL),
                   field("CompoundMotion.Items[].Dwell.Time", IG_WRITE)};
  static ig_field item;
  writer.out.create = [](const ig_link_api*, ig_link*, const ig_field* ids, void**) -> ig_status {
    item = ids[1];
    return IG_CHANGED;
  };
  static bool is_together;
  is_together = GENERATE(false, true);
  writer.out.build = [](void*, const ig_host* host, ig_block* block) -> ig_status {
    constexpr ig_value second{.number = 1};
    constexpr std::array<std::uint32_t, 3> masks{1, 1, 1};
    constexpr std::array<ig_value, 3> seconds{second, second, second};
    int refused = 0;
    for (int i = 0; i < 3'000'000 && refused < 3; ++i)
      refused += is_together ? 3 - static_cast<int>(host->append_many(block, &item, 1, 3, masks.data(), seconds.data()))
                             : 1 - host->append(block, &item, 1, &second);
    return refused >= 3 ? IG_CHANGED : IG_FAILED;
  };
  Hand hand{"p"};
  hand.add("Writer");
  hand.initial("Acme.Count", "1");
  const DiagnosticList found = run_one_block(hand, plugin);
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].code == "IG-0405");
}
