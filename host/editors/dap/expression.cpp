#include "dap/expression.hpp"

#include <algorithm>
#include <cmath>

namespace isogloss::dap {

namespace {

using Op = Expression::Node::Op;

char small_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_same_text(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, small_letter, small_letter);
}

constexpr double same_number = 1e-9;

/// A number equals the number that a text shows, and a truth the words true and false.
bool is_equal(const Value& a, const Value& b) {
  if (a.kind == Value::Kind::text || b.kind == Value::Kind::text) return is_same_text(shown(a), shown(b));
  return std::abs(a.number - b.number) <= same_number * std::max({1.0, std::abs(a.number), std::abs(b.number)});
}

Value compare(Op op, const Value& a, const Value& b) {
  if (a.kind == Value::Kind::none || b.kind == Value::Kind::none) return Value::truth(false);
  const bool equal = is_equal(a, b);
  if (op == Op::equal) return Value::truth(equal);
  if (op == Op::unequal) return Value::truth(!equal);
  if (a.kind == Value::Kind::text || b.kind == Value::Kind::text) return Value::truth(false);
  switch (op) {
    case Op::less: return Value::truth(a.number < b.number && !equal);
    case Op::not_greater: return Value::truth(a.number < b.number || equal);
    case Op::greater: return Value::truth(a.number > b.number && !equal);
    default: return Value::truth(a.number > b.number || equal);
  }
}

Value compute(Op op, const Value& a, const Value& b) {
  const auto is_number = [](const Value& v) { return v.kind == Value::Kind::number || v.kind == Value::Kind::truth; };
  if (!is_number(a) || !is_number(b)) return {};
  switch (op) {
    case Op::sum: return Value::of(a.number + b.number);
    case Op::difference: return Value::of(a.number - b.number);
    case Op::product: return Value::of(a.number * b.number);
    case Op::quotient: return b.number == 0 ? Value{} : Value::of(a.number / b.number);
    case Op::smaller: return Value::of(std::min(a.number, b.number));
    case Op::larger: return Value::of(std::max(a.number, b.number));
    case Op::minus: return Value::of(-a.number);
    case Op::absolute: return Value::of(std::abs(a.number));
    default: return {};
  }
}

Value field_value(const Document& d, const SymbolTable& symbols, ig_field f) {
  if (f == IG_NO_FIELD || !d.present(f)) return {};
  switch (d.layout().fields[f].type) {
    case IG_NUMBER: return Value::of(d.number(f));
    case IG_INTEGER: return Value::of(static_cast<double>(d.value(f).integer));
    case IG_BOOLEAN: return Value::truth(d.value(f).integer != 0);
    case IG_SYMBOL: return Value::of(std::string(symbols.text(static_cast<ig_symbol>(d.value(f).symbol))));
    case IG_TEXT: return Value::of(std::string(d.text(f)));
    default: return Value::truth(true);
  }
}

Value path_value(const Scene& scene, std::string_view path) {
  if (scene.document == nullptr) return {};
  return field_value(*scene.document, *scene.symbols, scene.document->layout().id(path));
}

Value axis_value(const Scene& scene, unsigned axis, bool is_machine) {
  if (scene.stroke != nullptr) {
    const AxisValues& at = is_machine ? scene.stroke->machine : scene.stroke->program;
    if (at.has(axis)) return Value::of(at.at[axis]);
  }
  return path_value(scene, std::string(is_machine ? "MachineCoordinate." : "ProgramXyz.") + "XYZABC"[axis]);
}

std::string_view motion_of(const Stroke* stroke) {
  if (stroke == nullptr) return "none";
  constexpr std::string_view names[] = {"rapid", "feed", "arc", "dwell", "spindle", "orient"};
  return names[static_cast<std::size_t>(stroke->kind)];
}

Value feed_value(const Scene& scene) {
  if (scene.stroke == nullptr) return path_value(scene, "Feedrate.FeedrateValue");
  return scene.stroke->feed_mm_min ? Value::of(*scene.stroke->feed_mm_min) : Value{};
}

Value or_else(Value value, const char* text) {
  return value.kind == Value::Kind::none ? Value::of(std::string(text)) : std::move(value);
}

Value tool_value(const Scene& scene) {
  Value in_spindle = path_value(scene, "ToolChange.SpindleToolId");
  return in_spindle.kind == Value::Kind::none ? path_value(scene, "ToolChange.ToolId") : in_spindle;
}

/// The names of the language, in small letters.
Value name_value(const Scene& scene, std::string_view name) {
  constexpr std::string_view machine = "machine.", axes = "xyzabc";
  const bool is_machine = name.starts_with(machine);
  const std::string_view axis = is_machine ? name.substr(machine.size()) : name;
  if (const std::size_t i = axes.find(axis); axis.size() == 1 && i != std::string_view::npos)
    return axis_value(scene, static_cast<unsigned>(i), is_machine || i >= 3);
  if (name == "feed") return feed_value(scene);
  if (name == "speed") return path_value(scene, "SpindleSpeed.SpindleSpeed_rpm");
  if (name == "tool") return tool_value(scene);
  if (name == "spindle") return or_else(path_value(scene, "SpindleSpeed.Direction"), "STOP");
  if (name == "coolant") return or_else(path_value(scene, "Coolant.Mode"), "OFF");
  if (name == "motion") return Value::of(std::string(motion_of(scene.stroke)));
  if (name == "file") return Value::of(std::string(scene.file));
  if (name == "program") return Value::of(std::string(scene.program));
  if (name == "line") return Value::of(scene.line);
  if (name == "depth") return Value::of(scene.depth);
  if (name == "pass") return Value::of(scene.pass);
  if (name == "block") return Value::of(static_cast<double>(scene.block));
  return {};
}

bool is_off(const Value& value) {
  if (value.kind != Value::Kind::text) return !value.is_true();
  for (const char* const off : {"off", "stop", "none", ""})
    if (is_same_text(value.text, off)) return true;
  return false;
}

}  // namespace

std::string shown(const Value& value) {
  switch (value.kind) {
    case Value::Kind::none: return "no value";
    case Value::Kind::truth: return value.number != 0 ? "true" : "false";
    case Value::Kind::number: return number_text(value.number);
    case Value::Kind::text: break;
  }
  return value.text;
}

Value Expression::at(std::uint32_t index, const Scene& scene, const VariableSource& variables) const {
  const Node& node = nodes_[index];
  switch (node.op) {
    case Op::constant: return node.value;
    case Op::name: return name_value(scene, node.name);
    case Op::field:
      return scene.document == nullptr ? Value{} : field_value(*scene.document, *scene.symbols, node.field);
    case Op::variable: return variables.value_of(node.name);
    case Op::either:
      return Value::truth(at(node.first, scene, variables).is_true() || at(node.second, scene, variables).is_true());
    case Op::both:
      return Value::truth(at(node.first, scene, variables).is_true() && at(node.second, scene, variables).is_true());
    case Op::negated: return Value::truth(!at(node.first, scene, variables).is_true());
    case Op::has: return Value::truth(at(node.first, scene, variables).kind != Value::Kind::none);
    case Op::is_on: return Value::truth(!is_off(at(node.first, scene, variables)));
    case Op::is_off: return Value::truth(is_off(at(node.first, scene, variables)));
    case Op::minus:
    case Op::absolute: return compute(node.op, at(node.first, scene, variables), Value::of(0));
    case Op::equal:
    case Op::unequal:
    case Op::less:
    case Op::not_greater:
    case Op::greater:
    case Op::not_less: return compare(node.op, at(node.first, scene, variables), at(node.second, scene, variables));
    default: return compute(node.op, at(node.first, scene, variables), at(node.second, scene, variables));
  }
}

Value Expression::evaluate(const Scene& scene, const VariableSource& variables) const {
  return nodes_.empty() ? Value{} : at(static_cast<std::uint32_t>(nodes_.size() - 1), scene, variables);
}

}  // namespace isogloss::dap
