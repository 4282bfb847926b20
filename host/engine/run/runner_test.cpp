// The way of a program through the runner: lines, splits, the look-ahead window, budgets. The plugin is made by hand:
// a scanner that reads X and a digit, and a post-logic syntax that adds up the X of the two blocks that follow.
#include "isogloss/engine/runner.hpp"

#include <catch2/catch.hpp>
#include <ctime>

#include "isogloss/engine/stepping.hpp"
#include "run/cursor.hpp"
#include "test_plugin.hpp"

namespace isogloss {
namespace {

struct Ids {
  ig_field first, second;
};

ig_status create(const ig_link_api*, ig_link*, const ig_field* ids, void** self) {
  *self = new Ids{ids[0], ids[1]};
  return IG_CHANGED;
}
void destroy(void* self) { delete static_cast<Ids*>(self); }

std::size_t scan(void* self, const ig_host* host, ig_block* block, const char* text, std::size_t size,
                 std::size_t position) {
  if (text[position] == ';') {
    host->flow(block, IG_FLOW_SPLIT, position + 1);
    return position + 1;
  }
  if (text[position] == '!') {
    host->report(block, 0, IG_NO_FIELD, 0, 0, nullptr, 0);
    return position + 1;
  }
  if (text[position] == '.' || text[position] == '%') {
    host->flow(block, text[position] == '.' ? IG_FLOW_END : IG_FLOW_END_FILE, 0);
    return position + 1;
  }
  if (position + 1 >= size) return position;
  host->set(block, static_cast<Ids*>(self)->first, {.number = static_cast<double>(text[position + 1] - '0')});
  return position + 2;
}

ig_status add_next(void* self, const ig_host* host, ig_block* block) {
  const Ids& ids = *static_cast<Ids*>(self);
  double sum = 0;
  for (std::uint32_t k = 1; k <= 2; ++k) {
    ig_block* const next = host->ahead(block, k);
    ig_value x;
    if (next != nullptr && host->get(next, ids.first, &x) != 0) sum += x.number;
  }
  host->set(block, ids.second, {.number = sum});
  ig_value own;
  host->get(block, ids.first, &own);
  if (own.number == 7) {
    host->report(block, 1, IG_NO_FIELD, 0, 0, nullptr, 0);
    host->flow(block, IG_FLOW_ALARM, 0);
  }
  return IG_CHANGED;
}

ig_status miss_end(void*, const ig_host* host, ig_block* block) {
  host->report(block, 2, IG_NO_FIELD, 0, 0, nullptr, 0);
  return IG_UNCHANGED;
}

/// A plugin with the reader of X, its chain, and what linking says.
struct Fixture {
  Fixture() : library({}) {
    add("Reader", {test::field("Test.X", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK),
                   test::field("Test.Unused", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK)});
    ig_syntax& reader = plugin.syntaxes.back().out;
    reader.triggers = "X;!.%";
    reader.scan = scan;
    reader.build = nullptr;
    plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_NOTE, "T-0001", "read", "", ""},
                          {sizeof(ig_diagnostic_decl), IG_ERROR, "T-0002", "seven", "", ""},
                          {sizeof(ig_diagnostic_decl), IG_WARNING, "T-0003", "no end", "", ""}};
  }

  ig_syntax& add(const char* id, std::vector<ig_field_decl> fields) {
    auto& syntax = plugin.syntax(id);
    syntax.fields = std::move(fields);
    syntax.out.create = create;
    syntax.out.destroy = destroy;
    return syntax.out;
  }
  void link_chain(std::initializer_list<std::pair<Stage, const char*>> rest) {
    library.add(plugin.get());
    Dialect dialect;
    dialect.name = "test";
    dialect.plugins = {{plugin.get()->name, {}}};
    dialect.chain = {{Stage::parsing, "Reader", "Reader", {}, false, {}}};
    for (const auto& [stage, id] : rest) dialect.chain.push_back({stage, id, id, {}, false, {}});
    linked = link(dialect, library, diagnostics);
    diagnostics.all.clear();  // notes of fields that nothing reads
  }

  test::Plugin plugin{"hand"};
  Library library;
  DiagnosticList diagnostics;
  std::unique_ptr<LinkedDialect> linked;
};

/// The chain of Sum, which adds up the X of the two blocks that follow.
struct Summing : Fixture {
  explicit Summing(bool misses_end = false, std::uint32_t access_of_x = IG_READ | IG_WAKE) {
    ig_syntax& sum = add("Sum", {test::field("Test.X", access_of_x, IG_NUMBER, IG_LIFE_BLOCK),
                                 test::field("Test.Sum", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK)});
    sum.build = add_next;
    sum.look_ahead = 2;
    auto& end = plugin.syntax("End");
    end.fields = {test::field("Source.~End", IG_READ | IG_WAKE, IG_SWITCH, IG_LIFE_BLOCK)};
    end.out.build = miss_end;
    if (misses_end)
      link_chain({{Stage::logic, "End"}, {Stage::post_logic, "Sum"}});
    else
      link_chain({{Stage::post_logic, "Sum"}});
  }
};

/// Line, X and sum of each block, as text: "1:1+5"; in brackets when it did not pass through the window.
class Collector : public Exporter {
 public:
  void begin(Document& d, const SymbolTable&) override {
    chain_document_ = &d;
    x_ = d.layout().id("Test.X");
    sum_ = d.layout().id("Test.Sum");
  }
  bool block(Document& d, const SymbolTable&) override {
    std::string text = std::to_string(d.source.line) + ":";
    if (d.present(x_)) text += std::to_string(static_cast<int>(d.number(x_)));
    if (d.present(sum_)) text += "+" + std::to_string(static_cast<int>(d.number(sum_)));
    blocks.push_back(&d == chain_document_ ? "(" + text + ")" : text);
    texts.emplace_back(d.source.text);
    return true;
  }
  bool end() override { return true; }
  std::vector<std::string> blocks, texts;

 private:
  ig_field x_ = IG_NO_FIELD, sum_ = IG_NO_FIELD;
  const Document* chain_document_ = nullptr;
};

using Strings = std::vector<std::string>;

TEST_CASE("the window holds executed blocks, and is flushed at the end") {
  Summing f;
  REQUIRE(f.linked != nullptr);
  REQUIRE(f.linked->look_ahead.size() == 1);
  REQUIRE(f.linked->look_ahead[0].blocks == 2);
  Collector out;
  const auto source = memory_source("X1\nX2\n\nX3\n(\nX4");
  run(*f.linked, *source, "t", {}, {&out}, f.diagnostics);
  CHECK(out.blocks == Strings{"1:1+5", "2:2+3", "4:3+4", "5:", "6:4+0"});
  CHECK(out.texts == Strings{"X1", "X2", "X3", "(", "X4"});
}

Strings said(const DiagnosticList& list) {
  Strings out;
  for (const Diagnostic& d : list.all) out.push_back(std::to_string(d.where.line) + " " + d.code);
  return out;
}

TEST_CASE("only blocks that a syntax wants to look ahead from wait, and those that come up behind them") {
  Summing f;
  Collector out;
  const auto source = memory_source("(\n(\nX1\n(\nX2\n(\n(\n(\nX3\n(");
  run(*f.linked, *source, "t", {}, {&out}, f.diagnostics);
  CHECK(out.blocks == Strings{"(1:)", "(2:)", "3:1+2", "4:", "5:2+0", "6:", "7:", "(8:)", "9:3+0", "10:"});
}

/// Raises what wakes Sum, after a look at the next block that has an X.
ig_status look_at_next(void* self, const ig_host* host, ig_block* block) {
  const Ids& ids = *static_cast<Ids*>(self);
  for (std::uint32_t k = 1; k <= 5; ++k) {
    ig_block* const next = host->ahead(block, k);
    ig_value x;
    if (next == nullptr || host->get(next, ids.first, &x) == 0) continue;
    if (x.number == 3) host->set(block, ids.second, {.integer = 1});
    break;
  }
  return IG_CHANGED;
}

/// The chain of Next, which looks at the blocks up to one with an X, and of Sum, which it wakes and which reads two.
struct LookingTwice : Fixture {
  explicit LookingTwice(bool ends_at_x) {
    const std::uint32_t ends = ends_at_x ? IG_ENDS_AHEAD : 0;
    ig_syntax& next = add("Next", {test::field("Test.X", IG_READ | IG_WAKE | ends, IG_NUMBER, IG_LIFE_BLOCK),
                                   test::field("Test.~Go", IG_WRITE, IG_SWITCH, IG_LIFE_BLOCK)});
    next.build = look_at_next;
    next.look_ahead = 5;
    ig_syntax& sum = add("Sum", {test::field("Test.X", IG_READ, IG_NUMBER, IG_LIFE_BLOCK),
                                 test::field("Test.Sum", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK),
                                 test::field("Test.~Go", IG_READ | IG_WAKE, IG_SWITCH, IG_LIFE_BLOCK)});
    sum.build = add_next;
    sum.look_ahead = 2;
    link_chain({{Stage::post_logic, "Next"}, {Stage::post_logic, "Sum"}});
  }

  /// The blocks, and how many wait when each of them begins.
  void run_text(std::string_view text) {
    struct Waiting : BlockListener {
      bool before(const NextBlock& next, StandingRun&) override {
        counts.push_back(next.waiting);
        return true;
      }
      std::vector<std::size_t> counts;
    } listener;
    RunOptions options;
    options.listener = &listener;
    options.chain.mode = Mode::checked;
    Collector out;
    run(*linked, *memory_source(text), "t", options, {&out}, diagnostics);
    blocks = out.blocks;
    waiting = listener.counts;
  }

  Strings blocks;
  std::vector<std::size_t> waiting;
};

TEST_CASE("a block waits up to one with the field that ends the look-ahead, and for what it wakes by then") {
  LookingTwice promised(true), all(false);
  REQUIRE(promised.linked != nullptr);
  const std::string text = "X1!\nX2!\nX3!\nX4!\n(!\nX5\nX6!";
  promised.run_text(text);
  all.run_text(text);
  CHECK(promised.blocks == all.blocks);
  CHECK(promised.blocks[1] == "2:2+7");  // Sum has seen both blocks that it needs
  CHECK(said(promised.diagnostics) == Strings{"1 T-0001", "2 T-0001", "3 T-0001", "4 T-0001", "5 T-0001", "7 T-0001"});
  CHECK(said(promised.diagnostics) == said(all.diagnostics));
  using Counts = std::vector<std::size_t>;
  CHECK(all.waiting == Counts{0, 1, 2, 3, 4, 5, 5});
  CHECK(promised.waiting == Counts{0, 1, 1, 2, 1, 2, 1});
}

TEST_CASE("a look past the block that was promised to be the last one is reported") {
  Summing f(false, IG_READ | IG_WAKE | IG_ENDS_AHEAD);  // it reads two blocks in any case
  REQUIRE(f.linked != nullptr);
  RunOptions options;
  options.chain.mode = Mode::checked;
  Collector out;
  run(*f.linked, *memory_source("X1\nX2\nX3"), "t", options, {&out}, f.diagnostics);
  REQUIRE_FALSE(f.diagnostics.all.empty());
  CHECK(f.diagnostics.all[0].code == "IG-0402");
  CHECK(f.diagnostics.all[0].message.find("past the block 1, which has a field that ends its look-ahead") !=
        std::string::npos);
}

TEST_CASE("diagnostics keep the order of the blocks, whatever stage says them") {
  Summing f;
  Collector out;
  const auto source = memory_source("!\nX7!\nX2!\n!\n!\n!");
  run(*f.linked, *source, "t", {}, {&out}, f.diagnostics);
  CHECK(said(f.diagnostics) ==
        Strings{"1 T-0001", "2 T-0001", "2 T-0002", "2 IG-0408", "3 T-0001", "4 T-0001", "5 T-0001", "6 T-0001"});
}

TEST_CASE("a text that ends before its program does wakes who wants to know, behind all blocks and once") {
  Summing f(true);
  REQUIRE(f.linked != nullptr);
  const auto run_text = [&f](std::string_view text, std::uint64_t maximum_blocks = 0) {
    Collector out;
    RunOptions options;
    options.maximum_blocks = maximum_blocks;
    f.diagnostics.all.clear();
    run(*f.linked, *memory_source(text), "t", options, {&out}, f.diagnostics);
    return out.blocks;
  };
  CHECK(run_text("X1\n!\n\n") == Strings{"1:1+0", "2:"});
  CHECK(said(f.diagnostics) == Strings{"2 T-0001", "3 T-0003"});
  run_text("X1\n%\n!");
  CHECK(said(f.diagnostics) == Strings{"2 T-0003", "3 IG-0414"});
  run_text("X1\n.\n");
  CHECK(said(f.diagnostics).empty());
  run_text("X1\nX2\nX3", 2);
  CHECK(said(f.diagnostics) == Strings{"2 IG-0407"});
  CHECK(run_text("\n\n").empty());
  CHECK(said(f.diagnostics) == Strings{"0 IG-0423"});
}

TEST_CASE("an alarm behind the window stops the run there: what was read ahead is not executed") {
  Summing f;
  Collector out;
  RunOptions options;
  options.stop_on_error = true;
  const auto source = memory_source("X1\nX7\nX2!\nX3\nX4\nX5");
  const RunResult result = run(*f.linked, *source, "t", options, {&out}, f.diagnostics);
  CHECK(result.stopped_by_alarm);
  CHECK(out.blocks == Strings{"1:1+9", "2:7+5"});
  CHECK(said(f.diagnostics) == Strings{"2 T-0002"});
}

TEST_CASE("a limit of lines waits until the block of that line has seen what is ahead") {
  Summing f;
  Collector out;
  RunOptions options;
  options.stop_after_line = 1;
  const auto source = memory_source("X1\nX2\nX3\n(\n(\n(\n(\nX4");
  run(*f.linked, *source, "t", options, {&out}, f.diagnostics);
  REQUIRE(!out.blocks.empty());
  CHECK(out.blocks.front() == "1:1+5");
  CHECK(out.blocks.size() < 7);
}

TEST_CASE("a scanner may split a line into blocks; columns go on") {
  Summing f;
  Collector out;
  const auto source = memory_source("X1;X2 ; \nX3");
  const RunResult result = run(*f.linked, *source, "t", {}, {&out}, f.diagnostics);
  CHECK(out.blocks == Strings{"1:1+5", "1:2+3", "2:3+0"});
  CHECK(result.blocks == 3);
  CHECK(result.lines == 2);
}

TEST_CASE("a run ends at its limit of blocks, and says so") {
  Summing f;
  Collector out;
  RunOptions options;
  options.maximum_blocks = 2;
  const auto source = memory_source("X1\nX2\nX3\n");
  run(*f.linked, *source, "t", options, {&out}, f.diagnostics);
  CHECK(out.blocks.size() == 2);
  REQUIRE(f.diagnostics.all.size() == 1);
  CHECK(f.diagnostics.all[0].code == "IG-0407");
}

Strings lines_in(Source& source, std::size_t maximum = 1000, bool* truncated = nullptr) {
  const Segmenter by_line{"line", {}, {}};
  Cursor cursor(source, maximum, by_line);
  Strings out;
  for (Line line; cursor.next(line);) {
    out.emplace_back(line.text);
    if (truncated != nullptr) *truncated |= line.truncated;
    CHECK(line.number == out.size());
  }
  return out;
}

Strings lines_of(std::string_view text, std::size_t maximum = 1000, bool* truncated = nullptr) {
  return lines_in(*memory_source(text), maximum, truncated);
}

TEST_CASE("lines end in LF, CR LF, or in CR alone where there is no LF") {
  CHECK(lines_of("a\nb\n") == Strings{"a", "b"});
  CHECK(lines_of("a\r\nb") == Strings{"a", "b"});
  CHECK(lines_of("a\rb\r") == Strings{"a", "b"});
  CHECK(lines_of("\n\na") == Strings{"", "", "a"});
  CHECK(lines_of("").empty());
  CHECK(lines_of("\xef\xbb\xbfX1\n") == Strings{"X1"});
}

/// At most so many bytes at once.
class PiecesSource : public Source {
 public:
  PiecesSource(std::string_view text, std::size_t most) : text_(memory_source(text)), most_(most) {}
  std::size_t read(char* buffer, std::size_t size) override { return text_->read(buffer, std::min(size, most_)); }
  bool has_places() const override { return true; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    return text_->read_at(offset, buffer, std::min(size, most_));
  }

 private:
  std::unique_ptr<Source> text_;
  std::size_t most_;
};

TEST_CASE("how lines end does not depend on how many bytes a source gives at once") {
  const std::string far(70'000, 'x');
  for (const std::string& text : {std::string("a\rb\nc"),
                                  std::string("\xef\xbb\xbf"
                                              "a\rb\nc\r\n"),
                                  std::string("a\rb\r"), "a\r" + far + "\nb", far + "\ra\nb", far + far + "\na\r"})
    for (const std::size_t most : {1u, 3u, 4096u, 65'533u}) {
      PiecesSource pieces(text, most);
      CAPTURE(text.substr(0, 10), text.size(), most);
      CHECK(lines_in(pieces) == lines_of(text));
    }
  CHECK(lines_of("a\rb\nc") == Strings{"a\rb", "c"});
}

TEST_CASE("a line whose size is known is the one that would have been found") {
  const Segmenter by_line{"line", {}, {}};
  for (const std::string_view text : {"ab\n\ncd\r\ne\r\r\nfgh\n", "ab\rcd\r\re\r", "\xef\xbb\xbf\nab\ncd"}) {
    const auto source = memory_source(text), again = memory_source(text);
    Cursor cursor(*source, 1000, by_line), known(*again, 1000, by_line);
    Line line, same;
    CHECK_FALSE(known.next(same, 0));  // nothing has been read yet
    std::size_t lines_of_known_size = 0;
    while (cursor.next(line)) {
      const auto size = static_cast<std::uint32_t>(line.text.size());
      CAPTURE(text, line.number);
      if (line.number > 1)
        for (std::uint32_t less = 0; less < size; ++less) CHECK_FALSE(known.next(same, less));
      // The end of the text stays for the other function: behind it may come more.
      if (line.number > 1 && known.next(same, size))
        ++lines_of_known_size;
      else
        REQUIRE(known.next(same));
      CHECK(same.text == line.text);
      CHECK(same.offset == line.offset);
      CHECK(same.number == line.number);
      CHECK(same.lines == 1);
      CHECK_FALSE(same.truncated);
      CHECK(known.offset() == cursor.offset());
      CHECK(known.bytes() == cursor.bytes());
    }
    CHECK_FALSE(known.next(same, 0));
    CHECK(lines_of_known_size > 0);
  }
}

TEST_CASE("a line that is too long is cut, and the next one is whole") {
  bool truncated = false;
  const std::string longer(600'000, 'x');
  CHECK(lines_of(longer + "\nb\nc", 1000, &truncated) == Strings{longer.substr(0, 1000), "b", "c"});
  CHECK(truncated);
  CHECK(lines_of(longer, 1000) == Strings{longer.substr(0, 1000)});
  CHECK(lines_of("a\n" + longer + "\n\nc", 700'000) == Strings{"a", longer, "", "c"});
}

struct Joined {
  std::string text;
  std::uint32_t number, lines;
  bool truncated;
  friend bool operator==(const Joined&, const Joined&) = default;
};

std::vector<Joined> joined(std::string_view text, const Segmenter& segmenter, std::size_t maximum = 1000) {
  const auto source = memory_source(text);
  Cursor cursor(*source, maximum, segmenter);
  std::vector<Joined> out;
  for (Line line; cursor.next(line);) out.push_back({std::string(line.text), line.number, line.lines, line.truncated});
  return out;
}

TEST_CASE("lines that end in the segmenter's mark are one block with those that follow") {
  const Segmenter tilde{"line", "~", ";"}, dots{"line", "...", ""};
  CHECK(joined("a ~\n b\nc\n", tilde) == std::vector<Joined>{{"a ~\n b", 1, 2, false}, {"c", 3, 1, false}});
  CHECK(joined("a;x ~ \r\nb~\r\nc\r\nd", tilde) ==
        std::vector<Joined>{{"a;x ~ \r\nb~\r\nc", 1, 3, false}, {"d", 4, 1, false}});
  CHECK(joined("a ~ ;x\nb;~y\nc", tilde) == std::vector<Joined>{{"a ~ ;x\nb;~y", 1, 2, false}, {"c", 3, 1, false}});
  CHECK(joined("a~\rb\rc", tilde) == std::vector<Joined>{{"a~\rb", 1, 2, false}, {"c", 3, 1, false}});
  CHECK(joined("a~\n", tilde) == std::vector<Joined>{{"a~", 1, 1, false}});
  CHECK(joined("a~", tilde) == std::vector<Joined>{{"a~", 1, 1, false}});
  CHECK(joined("a ...\nb ~\nc..", dots) == std::vector<Joined>{{"a ...\nb ~", 1, 2, false}, {"c..", 3, 1, false}});
  CHECK(joined("a ... ;x\nb", dots) == std::vector<Joined>{{"a ... ;x", 1, 1, false}, {"b", 2, 1, false}});
}

TEST_CASE("lines go on at their marks wherever these stand in the reading window, and after a step back") {
  const Segmenter tilde{"line", "~", ";"};
  std::string text;
  std::vector<Joined> expected;
  for (std::uint32_t i = 1; i <= 60'000; ++i) {
    const std::string line = "X" + std::to_string(i);
    const bool goes_on = i % 997 == 0;
    text += line + (goes_on ? " ~\nY\n" : "\n");
    const std::uint32_t number = expected.empty() ? 1 : expected.back().number + expected.back().lines;
    expected.push_back({goes_on ? line + " ~\nY" : line, number, goes_on ? 2u : 1u, false});
  }
  CHECK(joined(text, tilde) == expected);

  const auto source = memory_source(std::string_view("a ~\nb\nc\nd\n"));
  Cursor cursor(*source, 1000, tilde);
  Line line;
  cursor.seek(6, 3);
  REQUIRE(cursor.next(line));
  CHECK(line.text == "c");
  cursor.seek(0, 1);
  REQUIRE(cursor.next(line));
  CHECK(line.text == "a ~\nb");
}

TEST_CASE("a block of lines that go on is bounded, and what it goes on in is no block") {
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += "~\n";
  const Segmenter tilde{"line", "~", ""};
  const std::vector<Joined> all = joined(text + "end\nb\n", tilde, 1000);
  REQUIRE(all.size() == 2);
  CHECK(all[0].text == text.substr(0, 1000));
  CHECK(all[0].truncated);
  CHECK(all[1] == Joined{"b", 300'002, 1, false});
}

TEST_CASE("what is said of joined lines has the line and the column where it stands") {
  Summing f;
  f.linked->dialect.segmenter.continuation = "&";
  Collector out;
  const auto source = memory_source("X1 &\n  \x01 & \r\n X2\nX3 \x01");
  run(*f.linked, *source, "t", {}, {&out}, f.diagnostics);
  CHECK(out.blocks == Strings{"1:2+3", "4:3+0"});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  for (const Diagnostic& d : f.diagnostics.all) places.emplace_back(d.where.line, d.where.column);
  CHECK(places == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{2, 3}, {4, 4}});
}

TEST_CASE("a block of many lines is looked at once, whatever is said of it") {
  Summing f;
  f.linked->dialect.segmenter.continuation = "&";
  std::string text;
  constexpr std::uint32_t lines = 200'000;
  for (std::uint32_t i = 1; i < lines; ++i) text += "\x01&\n";
  text += " \x01\n";
  const auto source = memory_source(text);
  const std::clock_t begin = std::clock();
  run(*f.linked, *source, "t", {}, {}, f.diagnostics);
  CHECK(std::clock() - begin < 5 * CLOCKS_PER_SEC);
  REQUIRE(!f.diagnostics.all.empty());
  CHECK(f.diagnostics.all.back().where.line == lines);
  CHECK(f.diagnostics.all.back().where.column == 2);
}

TEST_CASE("lines are the same wherever the reading windows end") {
  std::string text;
  Strings expected;
  for (int i = 0; i < 60'000; ++i) {
    expected.push_back("X" + std::to_string(i * 7919 % 100'000));
    text += expected.back() + "\n";
  }
  CHECK(lines_of(text) == expected);
}

}  // namespace
}  // namespace isogloss
