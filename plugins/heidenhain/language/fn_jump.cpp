#include "language/fn_jump.hpp"

#include <cmath>

namespace heidenhain {

using namespace ig::cnc;

namespace {

/// True for values that the control's display shows as equal.
bool are_shown_as_equal(double left, double right) {
  return std::fabs(left - right) <= 1e-9 * std::fmax(1, std::fabs(left));
}

bool holds_for(unsigned fn, double left, double right) {
  switch (fn) {
    case 9: return are_shown_as_equal(left, right);
    case 10: return !are_shown_as_equal(left, right);
    case 11: return left > right;
    default: return left < right;
  }
}

/// Whether Q1 IS DEFINED or Q1 IS UNDEFINED holds; nothing where another condition is there.
std::optional<bool> definedness(const ParameterReader& reader, std::size_t& next) {
  const std::string_view text = reader.text;
  std::size_t i = skip(text, next), end = i;
  if (at(text, i) == '+') ++i;
  const auto q = Values::q_at(text, i, end);
  const std::size_t is = skip(text, end), word = skip(text, keyword(text, is, "IS"));
  if (!q || word == is) return std::nullopt;
  const std::size_t defined = keyword(text, word, "DEFINED"), undefined = keyword(text, word, "UNDEFINED");
  if (defined == word && undefined == word) return std::nullopt;
  next = std::max(defined, undefined);
  return reader.values.has(reader.block, *q) == (defined != word);
}

/// The condition at `next`, which moves past it: +Q1 EQU +5, Q1 IS UNDEFINED.
std::optional<bool> condition(const ParameterReader& reader, std::size_t& next, unsigned fn) {
  static constexpr std::array<std::string_view, 4> comparisons{"EQU", "NE", "GT", "LT"};
  if (const auto known = fn == 9 ? definedness(reader, next) : std::nullopt) return known;
  const auto left = reader.value(next);
  if (!left) return std::nullopt;
  const std::string_view comparison = comparisons[fn - 9];
  const std::size_t i = skip(reader.text, next);
  next = glued(reader.text, i, comparison);
  if (next == i) {
    reader.missing(comparison);
    return std::nullopt;
  }
  const auto right = reader.value(next);
  return right ? std::optional(holds_for(fn, *left, *right)) : std::nullopt;
}

}  // namespace

void jump_by_fn(const ParameterReader& reader, std::size_t position, unsigned number) {
  const std::string_view text = reader.text;
  std::size_t next = glued(text, position, "IF");
  if (next == position) return reader.missing("IF");
  const std::size_t begin = skip(text, next);
  const auto holds = condition(reader, next, number);
  if (!holds) return;
  reader.values.examined().add(reader.block, trim(piece(text, begin, next)), *holds);
  std::size_t i = skip(text, next);
  next = glued(text, i, "GOTO");
  if (next == i) return reader.missing("GOTO LBL");
  i = skip(text, next);
  next = glued(text, i, "LBL");
  if (next == i) return reader.missing("LBL");
  i = skip(text, next);
  std::size_t end = i;
  const std::string name = read_name(text, i, end);
  if (name.empty()) return reader.missing("the label");
  if (!reader.ends(end) || !*holds) return;
  const ig::Flow::Answer answer = reader.values.flow().jump(reader.block, "L" + name, IG_SEARCH_TOP);
  if (answer.is_not_found())
    reader.block.report(ig::diag("HEI-0120"), ig::Where::columns(i, end), std::string_view(name), answer.reason);
}

}  // namespace heidenhain
