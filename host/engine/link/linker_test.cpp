#include <catch2/catch.hpp>
#include <functional>

#include "isogloss/engine/chain.hpp"
#include "test_plugin.hpp"

using namespace isogloss;
using namespace isogloss::test;

namespace {

/// A dialect put together by hand. Each element stands on a line of its own, in the order in which it is added.
struct Hand {
  Dialect dialect;
  std::uint32_t line = 0;

  explicit Hand(std::initializer_list<const char*> plugins) {
    dialect.name = "hand";
    dialect.file = "hand.xml";
    for (const char* name : plugins) dialect.plugins.push_back({name, next()});
  }
  Location next() { return {"hand.xml", ++line, 7}; }
  ChainElement& add(const char* syntax, std::vector<std::pair<const char*, const char*>> options = {},
                    Stage stage = Stage::logic) {
    ChainElement element{stage, syntax, syntax, {}, false, next()};
    for (const auto& [name, value] : options) element.options.push_back({name, value, next()});
    return dialect.chain.emplace_back(std::move(element));
  }
  DependencyElement& depend(const char* id) {
    return dialect.dependencies.emplace_back(DependencyElement{id, id, {}, {}, {}, next()});
  }
  void initial(const char* path, const char* value) { dialect.initial.push_back({path, value, next()}); }
};

/// "code line" of each diagnostic, in order.
std::vector<std::string> faults(Hand& hand, std::initializer_list<Plugin*> plugins, DiagnosticList* kept = nullptr) {
  Library library({});
  for (Plugin* plugin : plugins) library.add(plugin->get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found);
  CHECK((linked == nullptr) == found.has_errors());
  std::vector<std::string> all;
  for (const Diagnostic& d : found.all) {
    CHECK(d.where.file == "hand.xml");
    all.push_back(d.code + " " + std::to_string(d.where.line));
  }
  if (kept != nullptr) *kept = found;
  return all;
}

/// What is said when the chain runs one empty block.
DiagnosticList run_one_block(Hand& hand, Plugin& plugin) {
  DiagnosticList found;
  Library library({});
  library.add(plugin.get());
  const auto linked = link(hand.dialect, library, found);
  REQUIRE(linked != nullptr);
  Chain chain(*linked, {}, found);
  chain.start();
  chain.begin_block({"part.nc", 1, 0, ""});
  chain.run(chain.document(), 0, static_cast<std::uint32_t>(linked->chain.size()));
  return found;
}

using Strings = std::vector<std::string>;

}  // namespace

TEST_CASE("a sound chain links without a word") {
  Plugin plugin("p");
  Syntax& writer = plugin.syntax("Writer");
  writer.fields = {field("Acme.Count", IG_WRITE)};
  writer.before = {"Reader", "NotInThisChain"};
  plugin.syntax("Reader").fields = {field("Acme.Count", IG_READ | IG_REQUIRED)};
  Hand hand{"p"};
  hand.add("Writer");
  hand.add("Reader");
  CHECK(faults(hand, {&plugin}).empty());
}

TEST_CASE("names that do not exist are told with the nearest one") {
  Plugin plugin("p");
  plugin.syntax("DrillSyntax").options = {option("retract", IG_OPTION_TEXT, "")};
  plugin.dependency("OffsetTable");
  DiagnosticList found;

  Hand no_plugin{"q"};
  CHECK(faults(no_plugin, {&plugin}) == Strings{"IG-0201 1"});

  Hand no_syntax{"p"};
  no_syntax.add("DrilSyntax");
  CHECK(faults(no_syntax, {&plugin}, &found) == Strings{"IG-0202 2"});
  CHECK(found.all[0].hint == "did you mean DrillSyntax?");

  Hand not_listed{};
  not_listed.add("DrillSyntax");
  CHECK(faults(not_listed, {&plugin}) == Strings{"IG-0202 1"});

  Hand no_dependency{"p"};
  no_dependency.depend("OfsetTable");
  CHECK(faults(no_dependency, {&plugin}, &found) == Strings{"IG-0203 2"});
  CHECK(found.all[0].hint == "did you mean OffsetTable?");

  Hand no_option{"p"};
  no_option.add("DrillSyntax", {{"retrakt", "x"}});
  CHECK(faults(no_option, {&plugin}, &found) == Strings{"IG-0204 3"});
  CHECK(found.all[0].hint == "did you mean retract?");
}

TEST_CASE("options are checked for type, range and presence") {
  Plugin plugin("p");
  plugin.syntax("S").options = {
      option("choice", IG_OPTION_CHOICE, "a", "a|b"), option("number", IG_OPTION_NUMBER, "1", "", 0, 2),
      option("integer", IG_OPTION_INTEGER, "1", "", 0, 2), option("boolean", IG_OPTION_BOOLEAN, "true")};
  plugin.syntax("Demanding").options = {option("needed", IG_OPTION_TEXT, nullptr)};
  const std::vector<std::pair<const char*, const char*>> wrong{
      {"choice", "c"},   {"choice", ""},     {"number", "2.1"}, {"number", "-1"}, {"number", "1e0"},  {"number", "x"},
      {"number", "nan"}, {"integer", "1.5"}, {"integer", "3"},  {"boolean", "1"}, {"boolean", "True"}};
  for (const auto& given : wrong) {
    CAPTURE(given.first, given.second);
    Hand hand{"p"};
    hand.add("S", {given});
    CHECK(faults(hand, {&plugin}) == Strings{"IG-0205 3"});
  }
  Hand right{"p"};
  right.add("S", {{"choice", "b"}, {"number", "0.5"}, {"integer", "2"}, {"boolean", "false"}});
  CHECK(faults(right, {&plugin}).empty());
  Hand missing{"p"};
  missing.add("Demanding");
  CHECK(faults(missing, {&plugin}) == Strings{"IG-0213 2"});
  Hand every_fault{"p"};
  every_fault.add("S", {{"choice", "c"}, {"number", "3"}, {"nothing", ""}});
  every_fault.add("Demanding");
  CHECK(faults(every_fault, {&plugin}) == Strings{"IG-0205 3", "IG-0205 4", "IG-0204 5", "IG-0213 6"});
}

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
  Library library({});
  library.add(plugin.get());
  DiagnosticList found;
  const auto linked = link(hand.dialect, library, found, LinkMode::whole);
  REQUIRE(linked != nullptr);
  const std::vector<ig_field>& ids = linked->chain[0].expansions.at(0);
  REQUIRE(ids.size() == 1);
  CHECK(linked->layout.fields[ids[0]].path == "Parsing.G181.X");
}

TEST_CASE("rows fit their table") {
  Plugin plugin("p");
  Dependency& table = plugin.dependency("Table");
  table.out.row_element = "Row";
  table.out.row_key = "id";
  table.columns = {column("X", nullptr, -10, 10)};
  plugin.dependency("Flat");
  Hand hand{"p"};
  DependencyElement& element = hand.depend("Table");
  const auto row = [&](DependencyElement& e, const char* name, std::vector<std::pair<const char*, const char*>> given) {
    TableRow out{name, {}, hand.next()};
    for (const auto& [key, value] : given) out.attributes.push_back({key, value, out.where});
    e.rows.push_back(out);
  };
  row(element, "Row", {{"id", "a"}, {"X", "-10"}});
  row(element, "Raw", {{"id", "a"}});
  row(element, "Row", {{"X", "1"}});
  row(element, "Row", {{"id", "b"}, {"Y", "1"}});
  row(element, "Row", {{"id", "c"}, {"X", "11"}});
  row(element, "Row", {{"id", "d"}, {"X", "eleven"}});
  row(element, "Row", {{"id", "a"}});
  row(hand.depend("Flat"), "Row", {});
  CHECK(faults(hand, {&plugin}) ==
        Strings{"IG-0217 4", "IG-0218 5", "IG-0219 6", "IG-0220 7", "IG-0220 8", "IG-0433 9", "IG-0217 11"});
}

TEST_CASE("stages, sizes and lives that cannot be") {
  Plugin plugin("p");
  plugin.syntax("Ahead").out.look_ahead = 2;
  plugin.syntax("Inspector").out.inspects = 1;
  plugin.syntax("Text").fields = {field("Acme.Note", IG_READ | IG_WRITE, IG_TEXT, IG_LIFE_MODAL)};
  plugin.syntax("S");
  Hand hand{"p"};
  hand.add("Ahead");
  hand.add("Inspector");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0221 2", "IG-0223 3"});
  Hand right{"p"};
  right.add("Ahead", {}, Stage::post_logic);
  right.add("Inspector", {}, Stage::inspection);
  CHECK(faults(right, {&plugin}).empty());
  Hand text{"p"};
  text.add("Text");
  CHECK(faults(text, {&plugin}).at(0) == "IG-0222 2");
  Hand large{"p"};
  for (int i = 0; i < 257; ++i) large.add("S").alias = "S" + std::to_string(i);
  CHECK(faults(large, {&plugin}) == Strings{"IG-0216 0"});
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

TEST_CASE("severities of the dialect hold while it is linked; an error stays one") {
  Plugin plugin("p");
  plugin.syntax("Writer").fields = {field("Acme.Level", IG_WRITE)};
  plugin.syntax("Needy").services = {{sizeof(ig_service_decl), 0, "test.offset/1", ""}};
  DiagnosticList found;
  Hand hand{"p"};
  hand.add("Writer");
  hand.dialect.severities["IG-0212"] = Severity::warning;
  faults(hand, {&plugin}, &found);
  CHECK(found.all.at(0).severity == Severity::warning);
  hand.add("Needy");
  hand.dialect.severities["IG-0211"] = Severity::note;
  faults(hand, {&plugin}, &found);
  CHECK(found.all.at(0).severity == Severity::error);
}

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

TEST_CASE("the first of two providers of a plugin's name is kept") {
  Plugin one("same"), two("same"), three("other");
  one.syntax("A");
  two.syntax("B");
  three.syntax("A");
  Library library({});
  library.add(one.get());
  library.add(two.get());
  library.add(three.get());
  CHECK(library.plugins().size() == 1);
  REQUIRE(library.refused().size() == 2);
  CHECK(library.refused()[0].code == "IG-0306");
  CHECK(library.refused()[1].code == "IG-0307");
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
    Library library({});
    library.add(plugin.get());
    DiagnosticList found;
    const auto linked = link(hand.dialect, library, found);
    REQUIRE(linked);
    const Layout& layout = linked->layout;
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

TEST_CASE("a code that means two things in two plugins is told, and one that they share is not") {
  Plugin first("first"), second("second");
  first.diagnostics = {{sizeof(ig_diagnostic_decl), IG_ERROR, "ACME-0001", "text", "why", "example"},
                       {sizeof(ig_diagnostic_decl), IG_ERROR, "ACME-0002", "shared", "why", "example"}};
  second.diagnostics = first.diagnostics;
  second.diagnostics[0].text = "another text";
  Library library({});
  library.add(first.get());
  library.add(second.get());
  const std::vector<Diagnostic> found = library.shared_codes();
  REQUIRE(found.size() == 1);
  CHECK(found[0].code == "IG-0310");
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
  writer.out.build = [](void*, const ig_host* host, ig_block* block) -> ig_status {
    const ig_value second{.number = 1};
    int refused = 0;
    for (int i = 0; i < 3'000'000 && refused < 3; ++i) refused += host->append(block, &item, 1, &second) == 0 ? 1 : 0;
    return refused == 3 ? IG_CHANGED : IG_FAILED;
  };
  Hand hand{"p"};
  hand.add("Writer");
  hand.initial("Acme.Count", "1");
  const DiagnosticList found = run_one_block(hand, plugin);
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].code == "IG-0405");
}
