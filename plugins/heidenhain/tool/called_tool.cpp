#include "tool/called_tool.hpp"

#include <cmath>
#include <string>

#include "tool/step_row.hpp"

namespace heidenhain {

namespace {

constexpr std::int64_t most_sisters = 100;

const ig::Diagnostics called_tool_diagnostics{
    ig::diagnostic(IG_ERROR, "HEI-0150",
                   "the tool table has no tool {0}, so the tool and its length stay in force: add its name",
                   "Column Name of ToolOffsetTable holds the names; a machine imports them from its TOOL.T.",
                   "5 TOOL CALL \"MILL_D10\" Z S3000"),
    ig::diagnostic(IG_WARNING, "HEI-0152",
                   "the tool table has no row {0}, so the length and radius of the tool itself are used",
                   "Step index .1 and so on names another length and radius of the same tool, row 5.1 of the table.",
                   "5 TOOL CALL 5.1 Z S3000"),
    ig::diagnostic(
        IG_NOTE, "HEI-0368",
        "{0} tools are named {1}: tool {2}, the first of them, is called, because their life is not known",
        "They are sister tools. Columns RT and TIME of the control decide which of them is called; they are not known "
        "here. Reported once for each name.",
        "5 TOOL CALL \"MILL_D10\" Z S3000 (and two tools of this name)"),
};

}  // namespace

CalledTool CalledTools::read(ig::Block& b, const Values& values, std::string_view text, std::size_t& i) const {
  if (at(text, i) == '"' || at(text, i) == '\'') return quoted(b, values, text, i);
  std::size_t q_end = i;
  if (Values::text_parameter_at(text, i, q_end)) {
    const auto where = ig::Where::columns(i, q_end);
    const auto name = values.text(b, text, i, q_end);
    i = q_end;
    return name ? named(b, values, trim(*name), where) : CalledTool{0, 0, true, false};
  }
  if (!is_digit(at(text, i)) && !Values::q_at(text, i, q_end)) return {};
  const Value v = values.read(b, text, i);
  const double number = std::floor(v.number);
  CalledTool tool{number, number, true, true};
  if (number != v.number) {
    const auto row = step_row(v.number);
    tool.row = row ? std::optional(static_cast<double>(*row)) : std::nullopt;
    const auto written = written_step_row(piece(text, i, v.end));
    if (written && tool_dimension(table_, *written, ToolDimension::length)) tool.row = static_cast<double>(*written);
  }
  i = v.end;
  return tool;
}

CalledTool CalledTools::quoted(ig::Block& b, const Values& values, std::string_view text, std::size_t& i) const {
  const std::size_t begin = i, close = skip_while(text, i + 1, [&](char c) { return c != text[begin]; });
  i = std::min(close + 1, text.size());
  return named(b, values, trim(piece(text, begin + 1, close)), ig::Where::columns(begin, i));
}

CalledTool CalledTools::named(ig::Block& b, const Values& values, std::string_view name, ig::Where where) const {
  if (const auto id = names_.number(name)) {
    report_sisters(b, values, *id, where, name);
    return {static_cast<double>(*id % IG_TOOL_INDEX_STEP), static_cast<double>(*id), true, true};
  }
  b.report(ig::diag("HEI-0150"), where, '"' + std::string(name) + '"');
  return {0, 0, true, false};
}

/// A control takes the sister tool whose life is not used up; here the first one is called.
void CalledTools::report_sisters(ig::Block& b, const Values& values, std::int64_t first, ig::Where where,
                                 std::string_view name) const {
  QStore* const store = values.store();
  if (store != nullptr && !store->is_first_time(368, name)) return;
  std::int64_t tools = 1;
  for (auto id = names_.sister(name, first); id && tools < most_sisters; id = names_.sister(name, *id)) ++tools;
  if (tools > 1)
    b.report(ig::diag("HEI-0368"), where, static_cast<double>(tools), name,
             static_cast<double>(first % IG_TOOL_INDEX_STEP));
}

double CalledTools::present_row(ig::Block& b, const CalledTool& tool, std::string_view text, std::size_t begin,
                                std::size_t end) const {
  if (tool.row == tool.number) return tool.number;
  if (tool.row && tool_dimension(table_, static_cast<std::int64_t>(*tool.row), ToolDimension::length)) return *tool.row;
  b.report(ig::diag("HEI-0152"), ig::Where::columns(begin, end), trim(piece(text, begin, end)));
  return tool.number;
}

}  // namespace heidenhain
