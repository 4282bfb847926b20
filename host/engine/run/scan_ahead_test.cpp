// Lines that another thread has scanned: the run gives what it gives alone, also where values that were carried,
// reports and a scanner that waits for its turn are among them, and after jumps.
#include "run/scan_ahead.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "isogloss/engine/document_json.hpp"
#include "test_plugin.hpp"

namespace isogloss::ahead_tests {
namespace {

std::atomic<std::uint64_t> scanned_here = 0, scanned_elsewhere = 0;
std::thread::id thread_of_test;

struct Ids {
  ig_field x, level, seen;
};

ig_status create(const ig_link_api*, ig_link*, const ig_field* ids, void** self) {
  *self = new Ids{ids[0], ids[1], ids[2]};
  return IG_CHANGED;
}
void destroy(void* self) { delete static_cast<Ids*>(self); }

/// X1: a word. L1: a level that stays. R: the level in force, as another value. !: a report. T: only in its turn.
std::size_t scan(void* self, const ig_host* host, ig_block* block, const char* text, std::size_t size,
                 std::size_t position) {
  const Ids& ids = *static_cast<Ids*>(self);
  ++(std::this_thread::get_id() == thread_of_test ? scanned_here : scanned_elsewhere);
  const double digit = position + 1 < size ? text[position + 1] - '0' : 0;
  switch (text[position]) {
    case 'X': {
      const ig_word word{
          ids.x, static_cast<std::uint16_t>(position), static_cast<std::uint16_t>(position + 2), {.number = digit}, 0,
          0};
      host->set_words(block, &word, 1);
      return position + 2;
    }
    case 'L': host->set(block, ids.level, {.number = digit}); return position + 2;
    case 'R': {
      ig_value level{};
      host->set(block, ids.seen, {.number = host->get(block, ids.level, &level) != 0 ? 10 + level.number : -1});
      return position + 1;
    }
    case '!': host->report(block, 0, IG_NO_FIELD, 0, 0, nullptr, 0); return position + 1;
    default:
      if (host->in_turn(block) == 0) return position;
      host->set(block, ids.x, {.number = 9});
      return position + 1;
  }
}

std::size_t scan_in_turn(void* self, const ig_host* host, ig_block* block, const char*, std::size_t, std::size_t at) {
  host->set(block, static_cast<Ids*>(self)->x, {.number = 8});
  return at + 1;
}

/// X8 ends the level, and X9 sets it: the thread that scans ahead sees neither.
ig_status change_level(void* self, const ig_host* host, ig_block* block) {
  const Ids& ids = *static_cast<Ids*>(self);
  ig_value x{};
  if (host->get(block, ids.x, &x) == 0 || x.number < 8) return IG_UNCHANGED;
  if (x.number == 8)
    host->erase(block, ids.level);
  else
    host->set(block, ids.level, {.number = 4});
  return IG_CHANGED;
}

/// Awake while there is a level.
ig_status show_level(void* self, const ig_host* host, ig_block* block) {
  host->set(block, static_cast<Ids*>(self)->seen, {.number = 1});
  return IG_CHANGED;
}

struct Fixture {
  explicit Fixture(bool scans_ahead = true) : library({}) {
    const auto add_build = [this](const char* name, ig_run_fn build, std::uint32_t of_x, std::uint32_t of_level) {
      auto& syntax = plugin.syntax(name);
      syntax.fields = {test::field("Parsing.X", of_x, IG_NUMBER, IG_LIFE_WORD),
                       test::field("Test.Level", of_level, IG_NUMBER, IG_LIFE_MODAL),
                       test::field("Test.HasLevel", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK)};
      syntax.out.create = create;
      syntax.out.destroy = destroy;
      syntax.out.build = build;
    };
    for (const char* const name : {"Reader", "Other"}) {
      auto& syntax = plugin.syntax(name);
      syntax.fields = {test::field("Parsing.X", IG_WRITE, IG_NUMBER, IG_LIFE_WORD),
                       test::field("Test.Level", IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_MODAL),
                       test::field("Test.Seen", IG_WRITE, IG_NUMBER, IG_LIFE_BLOCK)};
      syntax.out.create = create;
      syntax.out.destroy = destroy;
      syntax.out.build = nullptr;
    }
    add_build("Shower", show_level, IG_READ, IG_READ | IG_WAKE_WHILE);
    add_build("Changer", change_level, IG_READ | IG_WAKE, IG_READ | IG_WRITE);
    ig_syntax &reader = plugin.syntaxes[0].out, &other = plugin.syntaxes[1].out;
    reader.triggers = "XLR!T";
    reader.scan = scan;
    reader.scan_flags = scans_ahead ? IG_SCANS_AHEAD : 0;
    other.triggers = "U";
    other.scan = scan_in_turn;
    plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_NOTE, "T-0001", "read", "", ""}};
    library.add(plugin.get());
    Dialect dialect;
    dialect.name = "test";
    dialect.plugins = {{plugin.get()->name, {}}};
    dialect.chain = {{Stage::parsing, "Reader", "Reader", {}, false, {}},
                     {Stage::parsing, "Other", "Other", {}, false, {}},
                     {Stage::logic, "Shower", "Shower", {}, false, {}},
                     {Stage::logic, "Changer", "Changer", {}, false, {}}};
    linked = link(dialect, library, diagnostics);
    diagnostics.all.clear();
    thread_of_test = std::this_thread::get_id();
    scanned_here = scanned_elsewhere = 0;
  }

  test::Plugin plugin{"hand"};
  Library library;
  DiagnosticList diagnostics;
  std::unique_ptr<LinkedDialect> linked;
};

/// The blocks as JSON, in no hurry. The run waits at a line until the thread has scanned so much.
class Collector : public Exporter {
 public:
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document& d, const SymbolTable& symbols) override {
    if (d.source.line < 300 || d.source.line % shows_each == 0)
      all += std::to_string(d.source.line) + show_json(d, symbols).dump() + "\n";
    if (d.source.line % 16 == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (d.source.line == 200 && scanned_elsewhere < waits_for && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (d.source.line == counts_threads_at)
      for ([[maybe_unused]] const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) ++threads;
    return true;
  }
  bool end() override { return true; }
  std::string all;
  std::uint64_t waits_for = 0;
  std::uint32_t shows_each = 1;  // so many lines, and all before those that it waits for
  std::uint32_t counts_threads_at = 0;
  std::size_t threads = 0;  // of this process at that line
};

std::string program(std::size_t lines) {
  std::string out;
  for (std::size_t i = 0; i < lines; ++i) switch (i % 11) {
      case 1: out += "X1X2\n"; break;
      case 2: out += "R\n"; break;
      case 3: out += i % 1000 < 11 ? "L" + std::to_string(i / 1000 % 10) + "\n" : "\n"; break;
      case 4: out += i % 77 == 4 ? "!\n" : "X3 R\n"; break;
      case 5: out += "TX5\n"; break;
      case 6: out += "X6U\n"; break;
      case 7: out += "X7?\r\n"; break;
      default: out += "X" + std::to_string(i % 10) + "\n";
    }
  return out;
}

TEST_CASE("a run whose lines are scanned ahead gives what it gives alone") {
  Fixture f;
  const std::string text = program(40'000);
  Collector alone, helped;
  RunOptions options;
  DiagnosticList said_alone, said_helped;
  isogloss::run(*f.linked, *memory_source(text), "t", options, {&alone}, said_alone);
  CHECK(scanned_elsewhere == 0);
  const std::uint64_t scanned_alone = scanned_here.exchange(0);
  options.scans_ahead_after = 100;
  if (std::thread::hardware_concurrency() > 1) helped.waits_for = 1500;
  isogloss::run(*f.linked, *memory_source(text), "t", options, {&helped}, said_helped);
  if (helped.waits_for > 0) CHECK(scanned_here + 1000 < scanned_alone);
  CHECK(alone.all == helped.all);
  CHECK(said_alone.all.size() == said_helped.all.size());
  CHECK(!said_alone.all.empty());
  CHECK(alone.all.find("\"Seen\":19") != std::string::npos);  // a level of the text
  CHECK(alone.all.find("\"Seen\":14") != std::string::npos);  // one that build() has set
  CHECK(alone.all.find("\"Seen\":-1") != std::string::npos);  // none
  CHECK(alone.all.find("\"HasLevel\":1") != std::string::npos);
}

TEST_CASE("only scanners that say so are asked ahead") {
  Fixture f(false);
  RunOptions options;
  options.scans_ahead_after = 100;
  Collector out;
  isogloss::run(*f.linked, *memory_source(program(40'000)), "t", options, {&out}, f.diagnostics);
  CHECK(scanned_elsewhere == 0);
}

/// Waits until a line of the text is found; the text is what the run reads, from this line on.
std::optional<ScannedLine> find_from(ScanAhead& ahead, std::string_view text, std::size_t first) {
  const auto source = memory_source(text);
  const Segmenter by_line{"line", {}, {}};
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (std::chrono::steady_clock::now() < end) {
    Cursor cursor(*source, 1000, by_line);
    for (Line line; cursor.next(line);) {
      if (line.number < first) continue;
      if (line.number % 64 == 0) std::this_thread::sleep_for(std::chrono::microseconds(10));  // as if it were run
      if (const ScannedLine* const found = ahead.find(line)) {
        CHECK(found->offset == line.offset);
        CHECK(found->size == line.text.size());
        return *found;
      }
    }
  }
  return std::nullopt;
}

TEST_CASE("lines are found again after jumps, back and forth") {
  Fixture f;
  std::string text;
  for (int i = 0; i < 60'000; ++i) text += "X" + std::to_string(i % 10) + "\n";
  ScanAhead ahead(*f.linked, {}, memory_source(text), "t");
  for (const std::size_t first : {1u, 40'000u, 100u, 20'000u}) {
    const auto found = find_from(ahead, text, first);
    REQUIRE(found);
    CHECK_FALSE(found->is_left);
  }
}

TEST_CASE("where the run takes nothing of what is scanned ahead, its thread ends") {
  Fixture f;
  constexpr std::uint32_t lines = 100'000;
  std::string text = "L5\n";  // the thread begins later, and reads a level that does not exist
  for (std::uint32_t i = 1; i < lines; ++i) text += "R\n";
  Collector alone, helped;
  alone.counts_threads_at = helped.counts_threads_at = lines;
  alone.shows_each = helped.shows_each = 64;
  RunOptions options;
  isogloss::run(*f.linked, *memory_source(text), "t", options, {&alone}, f.diagnostics);
  options.scans_ahead_after = 100;
  if (std::thread::hardware_concurrency() > 1) helped.waits_for = 1500;
  isogloss::run(*f.linked, *memory_source(text), "t", options, {&helped}, f.diagnostics);
  CHECK(scanned_elsewhere >= helped.waits_for);
  CHECK(alone.threads >= 1);
  CHECK(helped.threads == alone.threads);
  CHECK(helped.all == alone.all);
}

}  // namespace
}  // namespace isogloss::ahead_tests
