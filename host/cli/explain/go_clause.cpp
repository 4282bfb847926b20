#include "explain/go_clause.hpp"

#include <fmt/format.h>

#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t most_text = 40;  // of a line that is quoted

bool is_name_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}

bool holds_name(std::string_view text, std::string_view name) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
  for (std::size_t i = 0; i + name.size() <= text.size(); ++i) {
    bool is_same = i == 0 || !is_name_character(text[i - 1]) || !is_name_character(name[0]);
    for (std::size_t k = 0; is_same && k < name.size(); ++k) is_same = upper(text[i + k]) == upper(name[k]);
    const bool ends = i + name.size() == text.size() || !is_name_character(text[i + name.size()]);
    if (is_same && ends) return true;
  }
  return false;
}

/// "line 8 (N20 G91)", "line 1 of O9001.nc (O9001)".
std::string place_with_text(const Facts& facts, const Location& to) {
  const ProgramLine line{to.file, to.line};
  std::string text = printable(facts.line_text(line));
  if (text.size() > most_text) {
    std::size_t size = most_text;
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0u) == 0x80u) --size;
    text = text.substr(0, size) + "…";
  }
  return facts.place(line) + (text.empty() ? "" : " (" + text + ")");
}

std::string jump_text(const Facts& facts, const ExplainedGo& go) {
  const std::uint32_t here = facts.block().where.line;
  if (go.to.line == here && !go.is_behind) return "runs again";
  const char* const way = go.to.line < here ? "jumps back" : "jumps";
  return fmt::format("{} {} {}", way, go.is_behind ? "behind" : "to", place_with_text(facts, go.to));
}

std::string call_text(const Facts& facts, const ExplainedGo& go) {
  // A label of this program is known by its line: its name is the form that the plugin compares.
  const std::string text = facts.line_text({go.to.file, go.to.line});
  const bool is_label = go.to.file == facts.block().where.file && !text.empty() && !holds_name(text, go.program);
  std::string out =
      "calls " + (is_label ? std::string() : printable(go.program) + ", ") + place_with_text(facts, go.to);
  return go.passes > 1 ? out + fmt::format(", {} times", go.passes) : out;
}

std::string return_text(const Facts& facts, const ExplainedGo& go) {
  const std::string call = facts.place({go.to.file, go.call_line});
  if (go.is_behind) return fmt::format("returns behind the call in {}", call);
  return fmt::format("returns to {}, not behind its call in {}", place_with_text(facts, go.to), call);
}

/// "#101 is 3", of the variables that the condition names; of all that the block reads where it names none.
std::string values_text(const Facts& facts, const std::string& condition) {
  constexpr std::size_t most = 3;
  std::string named, all;
  std::size_t count = 0;
  for (const ExplainedVariable& v : facts.block().variables) {
    const std::string value = printable(v.name) + (v.value.empty() ? " has no value" : " is " + printable(v.value));
    if (holds_name(condition, v.name)) named += (named.empty() ? "" : ", ") + value;
    if (count++ < most) all += (all.empty() ? "" : ", ") + value;
  }
  return named.empty() ? all : named;
}

}  // namespace

std::string condition_clause(const Facts& facts) {
  std::string out;
  for (const ExplainedCondition& c : facts.block().conditions) {
    out += out.empty() ? "because " : ", and ";
    if (c.is_reason) {
      out += c.text;
      continue;
    }
    out += c.text + (c.holds ? " holds" : " does not hold");
    if (const std::string values = values_text(facts, c.text); !values.empty()) out += " (" + values + ")";
  }
  return out;
}

std::string go_clause(const Facts& facts) {
  const ExplainedGo& go = facts.block().go;
  const std::string reason = condition_clause(facts);
  std::string out;
  switch (go.kind) {
    case ExplainedGo::Kind::next:
      if (reason.empty()) return {};
      out = "goes on with the next block";
      break;
    case ExplainedGo::Kind::call: out = call_text(facts, go); break;
    case ExplainedGo::Kind::leave: out = return_text(facts, go); break;
    case ExplainedGo::Kind::again:
      out = fmt::format("begins pass {} of {} in {}", go.pass, go.passes, place_with_text(facts, go.to));
      break;
    case ExplainedGo::Kind::jump: out = jump_text(facts, go); break;
  }
  return reason.empty() ? out : out + ", " + reason;
}

}  // namespace isogloss::cli
