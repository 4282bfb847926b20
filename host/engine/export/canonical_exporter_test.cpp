#include "isogloss/engine/canonical.hpp"

#include <catch2/catch.hpp>

#include "export/test_motions.hpp"

using namespace isogloss;
using namespace isogloss::test;

namespace {

/// Words that no control has, so that nothing but the rows can have written them.
ProgramText words() {
  ProgramText out;
  for (const auto& [name, text] : std::initializer_list<std::pair<const char*, const char*>>{
           {"head 1", "begin"},
           {"foot 1", "over"},
           {"end", "stop"},
           {"comment", "file {TEXT}"},
           {"rapid", "[{LINE} ]hop[ x{X}][ y{Y}][ z{Z}]"},
           {"feed", "[{LINE} ]go[ x{X}][ y{Y}][ z{Z}][ at {F}]"},
           {"arc XY CCW", "[{LINE} ]left x{X} y{Y} z{Z} i{I} j{J}[ at {F}]"},
           {"dwell", "wait {SECONDS}"}})
    out.rows.push_back({name, "", BlockTemplate(text)});
  return out;
}

struct Canonical {
  explicit Canonical(CanonicalOptions options = {})
      : text(words()), exporter(make_canonical_exporter(output, text, options, said)) {}

  template <class Fill>
  void block(std::uint32_t line, Fill fill) {
    if (!std::exchange(begun, true)) exporter->begin(t.d, t.symbols);
    t.block(line);
    fill();
    CHECK(exporter->block(t.d, t.symbols));
  }
  std::string written() {
    CHECK(exporter->end());
    return output.text;
  }
  std::vector<std::string> codes() const {
    std::vector<std::string> out;
    for (const Diagnostic& d : said.all) out.push_back(d.code + ":" + std::to_string(d.where.line));
    return out;
  }

  TestDocument t;
  StringOutput output;
  DiagnosticList said;
  ProgramText text;
  std::unique_ptr<Exporter> exporter;
  bool begun = false;
};

using Codes = std::vector<std::string>;

}  // namespace

TEST_CASE("canonical blocks are written with the rows' words, in machine coordinates") {
  Canonical c;
  c.t.shift(0, 0, -100);
  c.block(7, [&] { c.t.line(true, 30, 20, 5); });
  c.block(8, [&] { c.t.line(false, 30, 20, -10.5, 2); });
  c.block(9, [&] { c.t.arc(true, 20, 30, -10.5, 20, 20, -10.5, 5); });
  c.block(100'000, [&] { c.t.line(true, 0, 0, 5); });
  CHECK(c.written() ==
        "begin\nfile part.nc\n7 hop x30. y20. z-95.\n8 go x30. y20. z-110.5 at 120.\n"
        "9 left x20. y30. z-110.5 i-10. j0. at 300.\nhop x0. y0. z-95.\nstop\nover\n");
  CHECK(c.codes() == Codes{});
}

TEST_CASE("what a canonical block cannot say is reported at its line") {
  Canonical c;
  c.block(1, [&] { c.t.arc(true, 20, 30, 0, 20, 20, 0, 5); });  // the machine has no position yet
  c.block(2, [&] { c.t.line(false, 1, 2, 3); });
  c.block(3, [&] { c.t.name("ProgramStop.Term", "HALT"); });
  CHECK(c.written() == "begin\nfile part.nc\n1 go x20. y30. z0. at 300.\n2 go x1. y2. z3.\nstop\nover\n");
  CHECK(c.codes() == Codes{"IG-0192:1", "IG-0190:2", "IG-0193:3"});
}

TEST_CASE("a spindle that starts at an unknown speed is reported where a block before it has written one") {
  Canonical c;
  const std::string speed = "SpindleSpeed.SpindleSpeed_rpm";
  c.block(1, [&] { c.t.name("SpindleSpeed.Direction", "CW"); });
  c.block(2, [&] { c.t.number(speed, 1000); });
  c.block(3, [&] {
    c.t.name("SpindleSpeed.Direction", "CCW");
    c.t.d.erase(c.t.layout.id(speed));
  });
  static_cast<void>(c.written());
  CHECK(c.codes() == Codes{"IG-0193:1", "IG-0193:2", "IG-0623:3", "IG-0193:3"});
}
