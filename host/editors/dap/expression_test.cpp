#include "dap/expression.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "dap/breakpoints.hpp"
#include "dap/program_variables.hpp"

namespace isogloss::dap {

namespace {

/// A block of a dialect that has two fields.
struct Block {
  Block() {
    FieldInfo x, mode;
    x.path = "ProgramXyz.X";
    mode.path = "SpindleSpeed.Direction";
    mode.type = IG_SYMBOL;
    layout.fields = {x, mode};
    layout.index();
    document = std::make_unique<Document>(layout, std::vector<std::uint64_t>(layout.fields.size() * 2), 2);
    variables.note({"#101", 0, Value::of(5), true}, 1);
    variables.note({"NAME", 0, Value::of(std::string("tool")), true}, 1);
  }
  std::string value(std::string_view text) {
    const auto parsed = Expression::parse(text, layout);
    if (const auto* const fault = std::get_if<std::string>(&parsed)) return "fault: " + *fault;
    return shown(std::get<Expression>(parsed).evaluate(scene(), variables));
  }
  Scene scene() const {
    Scene out;
    out.document = document.get();
    out.symbols = &symbols;
    out.line = 12;
    return out;
  }
  Layout layout;
  SymbolTable symbols;
  std::unique_ptr<Document> document;
  ProgramVariables variables;
};

}  // namespace

TEST_CASE("expressions are computed with the usual order of their operators") {
  Block b;
  b.document->set(0, {.number = -12.5});
  const std::pair<const char*, const char*> cases[] = {
      {"1 + 2 * 3", "7"},
      {"(1 + 2) * 3", "9"},
      {"-2 - -3", "1"},
      {"X", "-12.5"},
      {"x < -10", "true"},
      {"X < -10 and X > -12", "false"},
      {"X < -10 or nothing1", "true"},
      {"not X < -10", "false"},
      {"!(X > 0) && true", "true"},
      {"2 = 2", "true"},
      {"2 <> 2", "false"},
      {"2 >= 2", "true"},
      {"2 <= 1.9", "false"},
      {"0.1 + 0.2 == 0.3", "true"},
      {"1 / 0", "no value"},
      {"abs(X)", "12.5"},
      {"min(3, X)", "-12.5"},
      {"max(3, X)", "3"},
      {"#101 * 2", "10"},
      {"var(\"NAME\") = 'TOOL'", "true"},
      {"has(#102)", "false"},
      {"#102 < 1", "false"},
      {"not (#102 < 1)", "true"},
      {"#102 + 1", "no value"},
      {"line", "12"},
      {"ProgramXyz.X", "-12.5"},
      {"'a' < 'b'", "false"},
  };
  for (const auto& [text, expected] : cases) {
    CAPTURE(text);
    CHECK(b.value(text) == expected);
  }
}

TEST_CASE("a word behind a name compares its state") {
  Block b;
  CHECK(b.value("spindle off") == "true");
  CHECK(b.value("coolant on") == "false");
  b.document->set(1, {.symbol = b.symbols.intern("CW")});
  CHECK(b.value("spindle off") == "false");
  CHECK(b.value("spindle is cw and X off") == "true");
  CHECK(b.value("SpindleSpeed.Direction ccw") == "false");
}

TEST_CASE("the end of a stroke stands for the position") {
  Block b;
  b.document->set(0, {.number = 1});
  Stroke stroke;
  stroke.program.at[0] = 7;
  stroke.program.known = 1;
  stroke.feed_mm_min = 600;
  Scene scene = b.scene();
  scene.stroke = &stroke;
  const auto parsed = Expression::parse("X = 7 and feed > 500", b.layout);
  CHECK(std::get<Expression>(parsed).evaluate(scene, b.variables).is_true());
}

TEST_CASE("what is no expression is refused with a sentence") {
  Block b;
  for (const char* const text :
       {"", "(", "X +", "1 2", "var(3)", "foo", "ProgramXyz.Y", "#", "'a", "X ?", "min(1)", "is"}) {
    CAPTURE(text);
    CHECK(b.value(text).starts_with("fault: "));
  }
  CHECK(b.value("ProgramXyz.x").find("did you mean ProgramXyz.X?") != std::string::npos);
  CHECK(b.value(std::string(1000, '(')).find("nests too deep") != std::string::npos);
  CHECK(b.value(std::string(5000, '1')).find("longer than") != std::string::npos);
}

TEST_CASE("hit counts") {
  const auto hits_of = [](const char* text) {
    const auto parsed = HitCondition::parse(text);
    if (std::holds_alternative<std::string>(parsed)) return std::string("fault");
    std::string out;
    for (std::uint64_t n = 1; n <= 6; ++n)
      if (std::get<HitCondition>(parsed).holds(n)) out += std::to_string(n);
    return out;
  };
  const std::pair<const char*, const char*> cases[] = {
      {"3", "3"},     {"== 3", "3"},    {">= 5", "56"},     {"> 5", "6"},  {"<=2", "12"},  {" < 2 ", "1"},
      {"% 2", "246"}, {"% 0", "fault"}, {"often", "fault"}, {"", "fault"}, {"-1", "fault"}};
  for (const auto& [text, expected] : cases) {
    CAPTURE(text);
    CHECK(hits_of(text) == expected);
  }
}

TEST_CASE("log messages hold expressions in braces") {
  Block b;
  b.document->set(0, {.number = 2});
  const auto message = [&](const char* text) {
    const auto parsed = LogMessage::parse(text, b.layout);
    if (const auto* const fault = std::get_if<std::string>(&parsed)) return "fault: " + *fault;
    return std::get<LogMessage>(parsed).fill(b.scene(), b.variables);
  };
  CHECK(message("X{X} {{#101}} {#101 + 1}") == "X2 {#101} 6");
  CHECK(message("{X").starts_with("fault"));
  CHECK(message("{}").starts_with("fault"));
}

TEST_CASE("variables of calls are told apart, and listed by number") {
  ProgramVariables v;
  v.note({"#10", 0, Value::of(1), true}, 1);
  v.note({"#9", 0, Value::of(2), true}, 1);
  v.note({"#1", 4, Value::of(3), true}, 1);
  v.note({"#1", 5, Value::of(4), true}, 2);
  v.enter(1);
  CHECK(v.value_of("#1").number == 3);
  v.enter(2);
  CHECK(v.value_of("#1").number == 4);
  v.enter(3);
  CHECK(v.value_of("#1").number == 4);
  REQUIRE(v.of_program().size() == 2);
  CHECK(v.of_program()[0]->name == "#9");
  CHECK(v.of_call(1).size() == 1);
}

}  // namespace isogloss::dap
