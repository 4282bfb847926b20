// Calls, returns, jumps and loops, by a plugin made by hand. A block of its language is letters and digits, which are
// shown, and one request: !NAME calls (!NAME*3 three times, ?NAME a place of this program, ~NAME in folders only),
// ^ returns (^NAME to a label of the caller, ^0 without the passes that are left), >NAME jumps (+ forward only, < back,
// ) behind), @ keeps the place, & goes to it, % ends the program, $ starts over, [NAME asks whether a label comes.
// :NAME begins a program, =NAME is a label.
#include "run/flow.hpp"

#include <catch2/catch.hpp>
#include <ctime>
#include <fstream>
#include <random>

#include "../../tests/support/budget.hpp"
#include "isogloss/engine/scan.hpp"
#include "test_plugin.hpp"

namespace isogloss::flow_tests {
namespace {

namespace fs = std::filesystem;

struct Language {
  const ig_flow_1* flow;
  ig_field shown, modal, frame;
  ig_place kept{};
};

ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  *self = new Language{static_cast<const ig_flow_1*>(api->service(link, IG_FLOW_SERVICE)), ids[0], ids[1], ids[2]};
  return IG_CHANGED;
}
void destroy(void* self) { delete static_cast<Language*>(self); }

ig_text text(std::string_view t) { return {t.data(), t.size()}; }

bool is_name(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z'); }

std::string answers;

void ask(const Language& l, ig_block* block, char what, std::string_view name, std::uint32_t count) {
  ig_go go{};
  go.struct_size = sizeof go;
  go.label = text(name);
  const ig_text files[] = {text(name)};
  switch (what) {
    case '~': go.scope = IG_IN_FOLDERS; [[fallthrough]];
    case '!':
    case '?':
      go.kind = IG_GO_CALL;
      go.repeats = count;
      go.tag = 7;
      if (what == '?') go.scope = IG_IN_PROGRAM;
      go.files = files;
      go.file_count = 1;
      break;
    case '^':
      go.kind = IG_GO_RETURN;
      if (name == "0") {
        go.label = {nullptr, 0};
        go.flags = IG_GO_DROP_REPEATS;
      }
      break;
    case '>': go.kind = IG_GO_LABEL; break;
    case '+':
      go.kind = IG_GO_LABEL;
      go.search = IG_SEARCH_FORWARD;
      break;
    case '<':
      go.kind = IG_GO_LABEL;
      go.search = IG_SEARCH_BACKWARD;
      break;
    case ')':
      go.kind = IG_GO_LABEL;
      go.flags = IG_GO_BEHIND;
      break;
    case '[':
      go.kind = IG_ASK_LABEL;
      go.search = IG_SEARCH_FORWARD;
      break;
    case '&':
      go.kind = IG_GO_PLACE;
      go.place = l.kept;
      break;
    default: go.kind = IG_GO_START;
  }
  const std::int32_t answer = l.flow->go(block, &go);
  if (answer != IG_GO_DONE) answers += std::to_string(answer) + " " + std::string(go.reason.data, go.reason.size) + "|";
}

std::size_t scan(void* self, const ig_host* host, ig_block* block, const char* data, std::size_t size,
                 std::size_t position) {
  Language& l = *static_cast<Language*>(self);
  const std::string_view all(data, size);
  const char what = all[position];
  std::size_t end = is_name(what) ? position : position + 1;
  while (end < size && is_name(all[end])) ++end;
  const std::string_view name = all.substr(position, end - position).substr(is_name(what) ? 0 : 1);
  std::uint32_t count = 1;
  if (end + 1 < size && all[end] == '*') {
    count = static_cast<std::uint32_t>(all[end + 1] - '0');
    end += 2;
  }
  if (is_name(what)) {
    host->set_text(block, l.shown, text(name));
  } else if (what == ';') {
    host->flow(block, IG_FLOW_SPLIT, position + 1);
    return position + 1;
  } else if (what == ':' || what == '=') {
    l.flow->label(block, text(name), what == ':' ? IG_LABEL_PROGRAM : IG_LABEL_PLACE);
    if (what == ':') host->set(block, l.frame, {.integer = 0});
  } else if (what == '#') {  // a label that says where it stands
    ig_place place{};
    l.flow->here(block, &place);
    l.flow->label(block, text("x" + std::to_string(place.line)), IG_LABEL_PLACE);
  } else if (l.flow->is_indexing != 0) {
    return end;
  } else if (what == '%') {
    host->flow(block, IG_FLOW_END, 0);
  } else if (what == '@') {
    l.flow->here(block, &l.kept);
  } else {
    ask(l, block, what, name, count);
  }
  return end;
}

struct Fixture {
  Fixture() : library({}) {
    auto& reader = plugin.syntax("Reader");
    reader.fields = {test::field("Test.Shown", IG_WRITE, IG_TEXT, IG_LIFE_BLOCK),
                     test::field("Test.Mode", IG_WRITE, IG_INTEGER, IG_LIFE_MODAL),
                     test::field("Test.Begun", IG_WRITE, IG_INTEGER, IG_LIFE_FRAME)};
    reader.out.triggers = "!?~^>+<)@&%$:=;[#abcdefghijklmnopqrstuvwxyz0123456789";
    reader.out.scan = scan;
    reader.out.build = nullptr;
    reader.out.create = create;
    reader.out.destroy = destroy;
    library.add(plugin.get());
    Dialect dialect;
    dialect.name = "test";
    dialect.extensions = {".prg"};
    dialect.plugins = {{plugin.get()->name, {}}};
    dialect.chain = {{Stage::parsing, "Reader", "Reader", {}, false, {}}};
    linked = link(dialect, library, diagnostics);
    diagnostics.all.clear();
    answers.clear();
  }

  /// What the blocks show, in order: "a b@1" where the block stands in another file or a frame has begun.
  std::string run(std::string_view program, const std::string& name = "main");
  std::string codes() const {
    std::string out;
    for (const Diagnostic& d : diagnostics.all) out += (out.empty() ? "" : " ") + d.code;
    return out;
  }

  test::Plugin plugin{"hand"};
  Library library;
  DiagnosticList diagnostics;
  std::unique_ptr<LinkedDialect> linked;
  RunOptions options;
  bool once = false;  ///< the source can be read only once
  RunResult result;
};

class Collector : public Exporter {
 public:
  void begin(Document& d, const SymbolTable&) override {
    shown_ = d.layout().id("Test.Shown");
    begun_ = d.layout().id("Test.Begun");
  }
  bool block(Document& d, const SymbolTable&) override {
    if (!d.present(shown_)) return true;
    if (out.size() < 4000) {
      out += (out.empty() ? "" : " ") + std::string(d.text(shown_));
      if (d.present(begun_)) out += "'";
      if (d.source.file != "main")
        out += "@" + fs::path(d.source.file).filename().string() + ":" + std::to_string(d.source.line);
    }
    return true;
  }
  bool end() override { return true; }
  std::string out;

 private:
  ig_field shown_ = IG_NO_FIELD, begun_ = IG_NO_FIELD;
};

class OnceSource : public Source {
 public:
  explicit OnceSource(std::string_view text) : text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = text_.copy(buffer, std::min<std::size_t>(size, 1000));
    text_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view text_;
};

std::string Fixture::run(std::string_view program, const std::string& name) {
  Collector out;
  std::unique_ptr<Source> source = memory_source(program);
  if (once) source = std::make_unique<OnceSource>(program);
  result = isogloss::run(*linked, *source, name, options, {&out}, diagnostics);
  return out.out;
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "isogloss-flow-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  void write(const std::string& name, std::string_view text) const { std::ofstream(path_ / name) << text; }
  fs::path path() const { return path_; }

 private:
  fs::path path_;
};

TEST_CASE("a program of the same file is called, and its caller goes on") {
  Fixture f;
  CHECK(f.run("a\n!s\nb\n%\n:s\nc\n^\n") == "a c' b");
  CHECK(f.codes().empty());
  CHECK(f.result.jumps == 2);
}

TEST_CASE("a call is repeated, and the passes that are left can be dropped") {
  Fixture f;
  CHECK(f.run("!s*3\nb\n%\n:s\nc\n^") == "c' c' c' b");
  CHECK(f.run("!s*3\nb\n%\n:s\nc\n^0") == "c' b");
  CHECK(f.codes().empty());
}

TEST_CASE("blocks behind a call on its line are run after it") {
  Fixture f;
  CHECK(f.run("a;!s;b;c\nd\n%\n:s;x;^;y\n") == "a x' b c d");
}

TEST_CASE("calls nest, and each frame has its own values of the life frame") {
  Fixture f;
  CHECK(f.run("a\n!s\nb\n%\n:s\nc\n!t\nd\n^\n:t\ne\n^") == "a c' e' d' b");
}

TEST_CASE("a return may go to a label of the caller") {
  Fixture f;
  CHECK(f.run("a\n!s\nb\n=n\nc\n%\n:s\nx\n^n\n") == "a x' c");
  CHECK(f.run("!s\nb\n%\n:s\nx\n^q\ny\n^\n") == "x' y' b");
  CHECK(answers == "0 looked in the calling program, main|");
}

TEST_CASE("a jump is looked for forward from its block, then from the top of its program") {
  Fixture f;
  CHECK(f.run("a\n>n\nb\n=n;c\n%") == "a c");
  CHECK(f.run("!s\n%\n=n;a\n:s\n>m\n=n;b\n^\n=m;>n\n") == "b'");
  CHECK(f.run(">n\n:s\n=n;b\n") == "b'");
  CHECK(answers == "0 looked in this program, main|");
  answers.clear();
  CHECK(f.run("=n;a\n+n\nb") == "a b");
  CHECK(f.run("<n\n=n;a") == "a");
  CHECK(f.run("a\n)n\nb\n=n;c;d\ne") == "a c d e");
  CHECK(f.run("a\n)n\nb\n=nx\ne\n=n x\nf") == "a f");
}

TEST_CASE("a kept place is gone to, in its own frame only") {
  Fixture f;
  f.options.maximum_loop_blocks = 4;
  CHECK(f.run("a\n@ b\nc\n&\nd") == "a b c b c b");
  CHECK(f.codes() == "IG-0418");
  f.diagnostics.all.clear();
  CHECK(f.run("@\n!s\nd\n%\n:s\n&\nx\n^") == "x' d");
  CHECK(answers == "0 the place belongs to another call|");
}

TEST_CASE("a block asks whether a label comes, and the run goes on") {
  Fixture f;
  CHECK(f.run("=m\n[n;a\n=n;b\n%") == "a b");
  CHECK(answers.empty());
  CHECK(f.run("=m\n[m;a\n!s\nb\n%\n:s\n[q;[m;x\n=q;^\n") == "a x' b");
  CHECK(answers == "0 looked in this program, main|0 looked in this program, main|");
}

TEST_CASE("a block that asks may still go somewhere") {
  Fixture f;
  CHECK(f.run("a\n[n>n\nb\n=n;c\n%") == "a c");
}

TEST_CASE("a place of the program itself is called") {
  Fixture f;
  CHECK(f.run("?n\na\n%\n=n;b\n^") == "b a");
  CHECK(f.codes().empty());
}

TEST_CASE("the text of a called program may end without a return") {
  Fixture f;
  CHECK(f.run("!s*2\nb\n%\n:s\nc") == "c' c' b");
  CHECK(f.codes() == "IG-0419 IG-0419");
}

#if defined(__SANITIZE_ADDRESS__)
constexpr std::clock_t seconds_allowed = 60;  // of a processor whose every access is checked
#else
constexpr std::clock_t seconds_allowed = 4;
#endif

TEST_CASE("loops end at their limits, which name them") {
  Fixture f;
  const std::clock_t begin = std::clock();  // a busy machine is not the program's fault
  SECTION("a jump to itself") {
    f.options.maximum_loop_blocks = 1'000'000;
    f.run("a\n=n;>n");
    CHECK(f.codes() == "IG-0418");
    CHECK(f.diagnostics.all[0].message ==
          "stopped in a loop after 1000000 of its blocks: line 2 goes back to line 2, 500001 times so far; "
          "--max-loop-blocks sets another limit");
  }
  SECTION("a program that starts over") {
    f.options.maximum_loop_blocks = 1'000'000;
    f.run("a\nb\n$");
    CHECK(f.codes() == "IG-0418");
    CHECK(f.diagnostics.all[0].where.line == 3);
  }
  SECTION("recursion") {
    f.run("!s\n%\n:s\n!s\n^");
    CHECK(f.codes() == "IG-0416");
    CHECK(f.result.blocks < 1000);
  }
  SECTION("two that call each other, often") {
    f.run("!s*9\n%\n:s\n!t*9\n^\n:t\n!s*9\n^");
    CHECK(f.codes().ends_with("IG-0416 IG-0422"));
    CHECK(f.diagnostics.all.size() == 1'001);
  }
  SECTION("a call that is repeated") {
    f.options.maximum_jumps = 5;
    f.run("!s*9\n%\n:s\n^");
    CHECK(f.codes() == "IG-0417");
  }
  SECTION("the blocks of a call that is repeated") {
    f.options.maximum_repeat_blocks = 5;
    f.run("!s*9\n%\n:s\na\n^");
    CHECK(f.codes() == "IG-0450");
  }
  SECTION("a return to before the call") {
    f.options.maximum_loop_blocks = 1'000'000;
    f.run("=n\n!s\n%\n:s\n^n");
    CHECK(f.codes() == "IG-0418");
    CHECK(f.diagnostics.all[0].message.find("line 2 goes back to line 1") != std::string::npos);
  }
  CHECK(std::clock() - begin < seconds_allowed * CLOCKS_PER_SEC);
}

TEST_CASE("programs are found beside the main program and in the folders given") {
  const TemporaryFolder folder;
  folder.write("S.PRG", "x\n^\n");
  folder.write("t", "y\n^\n");
  folder.write("u.doc", "z\n^\n");
  folder.write("lib.txt", ":v\nw\n^\n:x\nk\n^\n");
  folder.write("q.prg", ":r\nq\n^\n");
  fs::create_directory(folder.path() / "dir");
  fs::create_symlink("/etc/passwd", folder.path() / "link");
  Fixture f;
  f.options.program_places = {folder.path().string(), (folder.path() / "lib.txt").string()};
  CHECK(f.run("!s\n!t\n!x\na") == "x@S.PRG:1 y@t:1 k'@lib.txt:5 a");
  CHECK(answers.empty());
  f.run("!u\n");
  CHECK(answers.starts_with("0 looked in the file main, folder "));
  answers.clear();
  f.run("!dir\n!link\n");
  CHECK(answers.find("dir is a folder") != std::string::npos);
  CHECK(answers.find("link is a link that leads out of its folder") != std::string::npos);
  CHECK(f.codes().empty());
  CHECK(f.run("!q") == "q'@q.prg:2");
  CHECK(f.codes() == "IG-0420");
}

TEST_CASE("while a file is indexed a block knows where it stands") {
  Fixture f;
  CHECK(f.run("a\n>x4\nb\n#\nc\n", "main") == "a c");
}

TEST_CASE("what follows the end is noted unless the run was there") {
  Fixture f;
  f.run("a\n%\nb");
  CHECK(f.codes() == "IG-0414");
  CHECK(f.diagnostics.all[0].where.line == 3);
  f.diagnostics.all.clear();
  f.run("!s\n%\n:s\n^\n:t\nc");
  CHECK(f.codes() == "IG-0414");
  CHECK(f.diagnostics.all[0].where.line == 5);
  f.diagnostics.all.clear();
  f.run(">n\n=m;%\n=n;>m\n");
  CHECK(f.codes().empty());
}

TEST_CASE("a program of the file is chosen, and finds the others") {
  Fixture f;
  f.options.program = ":t";
  CHECK(f.run(":s\na\n^\n:t\nb\n!s\nc\n%") == "b' a' c'");
  CHECK(f.codes().empty());
}

TEST_CASE("what can be read only once is kept for the way back") {
  Fixture f;
  f.once = true;
  CHECK(f.run("a\n!s\nb\n%\n:s\nc\n^\n") == "a c' b");
  std::string longer = "a\n!s\nb\n%\n";
  for (int i = 0; i < 400'000; ++i) longer += "=n" + std::to_string(i) + "\n";
  CHECK(f.run(longer + ":s\nc\n^\n") == "a c' b");
  CHECK(f.codes() == "IG-0414");
}

TEST_CASE("random programs end") {
  std::mt19937 random(5);
  Fixture f;
  f.options.maximum_jumps = 2000;
  f.options.maximum_loop_blocks = 2000;
  f.options.maximum_depth = 8;
  const std::string_view pieces[] = {"!s", "!s*9", "!t", "?n", "^",  "^n", "^0", ">n", ">m", "+n", "<m", ")n",
                                     "@",  "&",    "$",  "%",  ":s", ":t", "=n", "=m", "a",  ";",  "\n", "\n"};
  for (int i = 0; i < isogloss_test::budgeted(1000); ++i) {
    std::string program;
    for (int k = 0; k < 25; ++k) program += pieces[random() % std::size(pieces)];
    f.run(program);
    REQUIRE(f.result.blocks < 100'000);
    REQUIRE(f.result.jumps <= 2001);
  }
}

TEST_CASE("each call, return and jump is told with its places") {
  Fixture f;
  std::string told;
  f.options.moved = [&](const FlowStep& step) {
    told += "crgj"[static_cast<int>(step.kind)] + std::to_string(step.line) + ":" + std::string(step.label) + ">" +
            std::to_string(step.to_line) + " ";
  };
  CHECK(f.run("!s*2\n>m\na\n=m;b\n%\n:s\nx\n^") == "x' x' b");
  CHECK(told == "c1:s>6 g8:>6 r8:>2 j2:m>4 ");
}

TEST_CASE("blocks are scanned where no run comes, with labels and pieces") {
  Fixture f;
  std::string seen;
  const auto source = memory_source("a ; b\n%\n=m;!n\n:s c\n");
  scan_blocks(*f.linked, *source, "main", f.options, [&](const ScannedBlock& block) {
    seen += std::to_string(block.line) + ":" + std::to_string(block.column) + "/" + std::to_string(block.pieces.size());
    for (const ScannedLabel& label : block.labels)
      seen += (label.is_program ? ":" : "=") + label.name + "@" + std::to_string(label.begin) + "-" +
              std::to_string(label.end);
    seen += " ";
    return block.line < 4;
  });
  CHECK(seen == "1:0/2 1:3/1 2:0/1 3:0/2=m@0-2 3:3/1 4:0/2:s@0-2 ");
  CHECK(f.diagnostics.all.empty());
}

}  // namespace
}  // namespace isogloss::flow_tests
