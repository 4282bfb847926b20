// Checks every line of tests/macro/expressions.txt.
#include "macro/expression.hpp"

#include <catch2/catch.hpp>
#include <charconv>
#include <fstream>
#include <map>
#include <string>

using namespace fanuc;

namespace {

std::string name_of(Fault fault) {
  switch (fault) {
    case Fault::none: return "none";
    case Fault::no_operand: return "no operand";
    case Fault::not_closed: return "not closed";
    case Fault::too_deep: return "too deep";
    case Fault::number_too_large: return "number too large";
    case Fault::unknown_function: return "unknown function";
    case Fault::named_variable: return "named variable";
    case Fault::double_hash: return "double hash";
    case Fault::no_variable: return "no variable";
    case Fault::unknown_variable: return "unknown variable";
    case Fault::division_by_zero: return "division by zero";
    case Fault::out_of_domain: return "out of domain";
    case Fault::overflow: return "overflow";
    case Fault::no_bits: return "no bits";
    case Fault::truth_as_number: return "truth as number";
    default: return "?";
  }
}

Fault value_of(std::uint32_t number, MacroValue& out) {
  static const std::map<std::uint32_t, double> values{{1, 2},     {2, -3.5}, {3, 7},      {4, 0},   {5, 12},
                                                      {6, 1.25},  {7, 100},  {10, 30},    {11, 45}, {12, 3},
                                                      {20, 1e-5}, {100, -8}, {500, 0.125}};
  if (const auto found = values.find(number); found != values.end())
    out = {found->second, Kind::number};
  else if (number <= 33)
    out = MacroValue::null();
  else
    return Fault::unknown_variable;
  return Fault::none;
}

struct Variables final : VariableSource {
  Fault read(std::uint32_t number, MacroValue& out) const override { return value_of(number, out); }
};
const Variables variable;

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  while (!text.empty() && text.front() == ' ') text.erase(0, 1);
  return text;
}

/// The result in the words of the file; `expected` tells how exact a number must be.
std::string shown(const Outcome& o, const std::string& text, const std::string& expected) {
  if (!o.ok())
    return name_of(o.fault) + " " + std::to_string(o.fault_begin + 1) + "-" +
           std::to_string(std::max(o.fault_end, o.fault_begin + 1));
  const std::size_t ends = expected.find(" ends ");
  std::string out = o.value.is_null()             ? "null"
                    : o.value.kind != Kind::truth ? std::to_string(o.value.number)
                    : o.value.number != 0         ? "true"
                                                  : "false";
  if (o.value.kind == Kind::number) {
    double wanted = std::numeric_limits<double>::infinity();
    std::from_chars(expected.data(), expected.data() + expected.size(), wanted);
    if (std::abs(o.value.number - wanted) <= 1e-12 * std::max(1.0, std::abs(wanted))) out = expected.substr(0, ends);
  }
  if (o.end != text.size()) out += " ends " + std::to_string(o.end);
  return out;
}

}  // namespace

TEST_CASE("Each expression of the table has its value") {
  std::ifstream file(std::string(ISOGLOSS_SOURCE_DIR) + "/tests/macro/expressions.txt");
  REQUIRE(file);
  std::string line;
  std::size_t count = 0;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line.starts_with("##") || line.starts_with("# ") || line == "#") continue;
    std::size_t sign = line.find(" ! ");
    if (sign == std::string::npos) sign = line.rfind(" = ");
    REQUIRE(sign != std::string::npos);
    const std::string text = trimmed(line.substr(0, sign));
    const std::string expected = line.substr(sign + 3);
    INFO("line " << number << ": " << text);
    CHECK(shown(evaluate(text, 0, {}, variable), text, expected) == expected);
    ++count;
  }
  CHECK(count > 500);
}

TEST_CASE("Each difference between controls is a rule") {
  const auto value = [](const char* text, const ExpressionRules& rules) {
    const Outcome o = evaluate(text, 0, rules, variable);
    CHECK(o.ok());
    return o.value.number;
  };
  ExpressionRules signed_arcs;
  signed_arcs.arcs_are_signed = true;
  CHECK(value("ATAN[-1]/[1]", signed_arcs) == Approx(-45));
  CHECK(value("ASIN[-1]", signed_arcs) == Approx(-90));
  ExpressionRules numbers;
  numbers.truth_is_number = true;
  CHECK(value("[#1 EQ 2]*5+[#1 EQ 3]", numbers) == 5);
  ExpressionRules real;
  real.whole_modulus = false;
  CHECK(value("7.5 MOD 4", real) == 3.5);
  ExpressionRules word;
  word.increment = 0.001;
  CHECK(value("ROUND[1.23456]", word) == 1.235);
  CHECK(value("ROUND[-1.2345]", word) == -1.235);
}

TEST_CASE("No text makes the reader hang or read past its end") {
  const std::string alphabet = "#[]+-*/0123456789. ()SINCOTAQREDMXLGWPU,=";
  std::uint32_t state = 12345;
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::uint32_t i = 0; i < 3 + state % 24; ++i) {
      state = state * 1664525 + 1013904223;
      text += alphabet[(state >> 16) % alphabet.size()];
    }
    const Outcome o = evaluate(text, 0, {}, variable);
    REQUIRE(o.end <= text.size());
    REQUIRE(o.fault_end <= text.size());
    if (o.ok()) REQUIRE(std::isfinite(o.value.number));
  }
  const std::string deep(1'000'000, '[');
  CHECK(evaluate(deep, 0, {}, variable).fault == Fault::too_deep);
  const std::string signs(1'000'000, '-');
  CHECK(evaluate(signs, 0, {}, variable).fault == Fault::no_operand);
}
