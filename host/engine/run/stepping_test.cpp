// A listener between the blocks of a run. The plugin is made by hand: a digit is kept as a modal value, !NAME calls,
// :NAME begins a program, ^ returns, A is looked ahead of by one block, ( … ) is a comment.
#include "isogloss/engine/stepping.hpp"

#include <catch2/catch.hpp>

#include "test_plugin.hpp"

namespace isogloss::stepping_tests {
namespace {

struct Reader {
  const ig_flow_1* flow;
  ig_field mode, ahead;
};

ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  *self = new Reader{static_cast<const ig_flow_1*>(api->service(link, IG_FLOW_SERVICE)), ids[0], ids[1]};
  return IG_CHANGED;
}
void destroy(void* self) { delete static_cast<Reader*>(self); }

std::size_t scan(void* self, const ig_host* host, ig_block* block, const char* data, std::size_t size,
                 std::size_t position) {
  const Reader& r = *static_cast<Reader*>(self);
  const char what = data[position];
  const ig_text name{data + position + 1, position + 1 < size ? 1u : 0u};
  if (what >= '0' && what <= '9') {
    host->set(block, r.mode, {.integer = what - '0'});
    return position + 1;
  }
  if (what == 'A') {
    host->set(block, r.ahead, {.integer = 1});
    return position + 1;
  }
  if (what == ':') r.flow->label(block, name, IG_LABEL_PROGRAM);
  if (what == '!' || what == '^') {
    ig_go go{};
    go.struct_size = sizeof go;
    go.kind = what == '!' ? IG_GO_CALL : IG_GO_RETURN;
    go.label = what == '!' ? name : ig_text{nullptr, 0};
    go.repeats = what == '!' ? 2 : 0;
    if (r.flow->is_indexing == 0) r.flow->go(block, &go);
  }
  return position + (what == '^' ? 1 : 2);
}

ig_status create_remark(const ig_link_api*, ig_link*, const ig_field* ids, void** self) {
  *self = new ig_field(ids[0]);
  return IG_CHANGED;
}
void destroy_remark(void* self) { delete static_cast<ig_field*>(self); }

std::size_t scan_remark(void* self, const ig_host* host, ig_block* block, const char* data, std::size_t size,
                        std::size_t position) {
  host->set_text(block, *static_cast<ig_field*>(self), {data + position, 1});
  return std::min(std::string_view(data, size).find(')', position), size - 1) + 1;
}

ig_status look_ahead(void*, const ig_host* host, ig_block* block) {
  host->ahead(block, 1);
  return IG_UNCHANGED;
}

struct Fixture : BlockListener, Exporter {
  Fixture() : library({}) {
    auto& reader = plugin.syntax("Reader");
    reader.fields = {test::field("Test.Mode", IG_WRITE, IG_INTEGER, IG_LIFE_MODAL),
                     test::field("Test.Ahead", IG_WRITE, IG_INTEGER, IG_LIFE_BLOCK)};
    reader.out.triggers = "0123456789!:^A";
    reader.out.scan = scan;
    reader.out.build = nullptr;
    reader.out.create = create;
    reader.out.destroy = destroy;
    auto& remark = plugin.syntax("Remark");
    remark.fields = {test::field("Comment.Text", IG_WRITE, IG_TEXT, IG_LIFE_BLOCK)};
    remark.out.triggers = "(";
    remark.out.scan = scan_remark;
    remark.out.build = nullptr;
    remark.out.create = create_remark;
    remark.out.destroy = destroy_remark;
    auto& ahead = plugin.syntax("Ahead");
    ahead.fields = {test::field("Test.Ahead", IG_READ | IG_WAKE, IG_INTEGER, IG_LIFE_BLOCK)};
    ahead.out.build = look_ahead;
    ahead.out.look_ahead = 1;
    library.add(plugin.get());
    Dialect dialect;
    dialect.name = "test";
    dialect.plugins = {{plugin.get()->name, {}}};
    dialect.chain = {{Stage::parsing, "Reader", "Reader", {}, false, {}},
                     {Stage::parsing, "Remark", "Remark", {}, false, {}},
                     {Stage::post_logic, "Ahead", "Ahead", {}, false, {}}};
    linked = link(dialect, library, diagnostics);
    REQUIRE(linked != nullptr);
    diagnostics.all.clear();
  }

  bool before(const NextBlock& next, StandingRun& run) override {
    const Document& d = run.chain().document();
    const ig_field mode = d.layout().id("Test.Mode");
    seen += std::to_string(next.line) + (next.depth > 0 ? "'" : "");
    if (next.pass > 1) seen += "p" + std::to_string(next.pass);
    if (next.waiting > 0) seen += "w" + std::to_string(next.waiting);
    if (d.present(mode)) seen += "=" + std::to_string(d.value(mode).integer);
    seen += " ";
    frames = run.frames();
    if (next.number == execute_before) said = run.execute(executed);
    return next.number != end_before;
  }
  void begin(Document&, const SymbolTable&) override {}
  bool block(Document& d, const SymbolTable&) override {
    exported += std::to_string(d.source.line) + " ";
    return true;
  }
  bool end() override { return true; }

  void run(std::string_view program) {
    RunOptions options;
    options.listener = this;
    const auto source = memory_source(program);
    result = isogloss::run(*linked, *source, "main", options, {this}, diagnostics);
  }

  test::Plugin plugin{"hand"};
  Library library;
  DiagnosticList diagnostics;
  std::unique_ptr<LinkedDialect> linked;
  std::string seen, exported, executed;
  std::uint64_t execute_before = 0, end_before = 0;
  std::vector<Diagnostic> said;
  std::vector<ExplainedFrame> frames;
  RunResult result;
};

}  // namespace

TEST_CASE("a listener sees each block before it runs, with the state that the ones before left") {
  Fixture f;
  f.run("1\n\n2\n3\n");
  CHECK(f.seen == "1 3=1 4=2 ");
  CHECK(f.exported == "1 3 4 ");
}

TEST_CASE("a listener sees called programs, their depth and passes") {
  Fixture f;
  f.end_before = 4;
  f.run("!s\n1\n:s\n^\n");
  CHECK(f.seen == "1 3' 4' 3'p2 ");
  REQUIRE(f.frames.size() == 2);
  CHECK(f.frames[1].program == "s");
  CHECK(f.frames[1].call_line == 1);
  CHECK(f.frames[1].pass == 2);
  CHECK(f.frames[0].call != f.frames[1].call);
  CHECK(f.result.blocks == 3);
}

TEST_CASE("a listener ends the run before a block, and waiting blocks are still exported") {
  Fixture f;
  f.end_before = 3;
  f.run("1\n2A\n3\n4\n");
  CHECK(f.seen == "1 2=1 3w1=2 ");
  CHECK(f.exported == "1 2 ");
}

TEST_CASE("a block between two blocks changes the state, and nothing else") {
  Fixture f;
  f.execute_before = 2;
  f.executed = "7";
  f.run("1\n(x)\n3\n");
  CHECK(f.seen == "1 2=1 3=7 ");
  CHECK(f.exported == "1 2 3 ");
  CHECK(f.result.blocks == 3);
  CHECK(f.said.empty());
}

TEST_CASE("a block between two blocks cannot call") {
  Fixture f;
  f.execute_before = 2;
  f.executed = "!s";
  f.run("1\n2\n:s\n^\n");
  CHECK(f.seen == "1 2=1 3=2 4=2 ");
}

TEST_CASE("a block between blocks that wait leaves them in their order") {
  Fixture f;
  f.execute_before = 3;
  f.executed = "7";
  f.run("1A\n2A\n(x)\n4\n");
  CHECK(f.seen == "1 2w1=1 3w1=2 4=7 ");
  CHECK(f.exported == "1 2 3 4 ");
}

TEST_CASE("lines with a statement are neither blank nor comments alone") {
  Fixture f;
  const auto source = memory_source("1\n\n  \n(x)\n(x)2\n?\n");
  std::string lines;
  for (const BlockLine& line : find_block_lines(*f.linked, *source, {})) lines += std::to_string(line.line) + " ";
  CHECK(lines == "1 5 6 ");
  CHECK(f.diagnostics.all.empty());
}

}  // namespace isogloss::stepping_tests
