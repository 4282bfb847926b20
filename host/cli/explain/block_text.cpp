#include "explain/block_text.hpp"

#include <fmt/format.h>

#include "explain/frame_text.hpp"
#include "explain/ladder_text.hpp"
#include "explain/sentence.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

constexpr std::string_view transform_paths = "ProgramToMcTransform[";

/// The calls that led to the block, and the pass over its line; empty in the first pass of a program without calls.
std::string where_the_run_is(const ExplainedBlock& b) {
  std::string out;
  for (std::size_t i = 1; i < b.frames.size(); ++i) {
    const ExplainedFrame& f = b.frames[i];
    out += fmt::format("  called {} by {}:{}", f.program, b.frames[i - 1].file, f.call_line);
    out += f.passes > 1 ? fmt::format(", pass {} of {}\n", f.pass, f.passes) : "\n";
  }
  if (b.frames.size() > 1 || b.pass > 1) out += fmt::format("  pass {} over this line (--pass N: another)\n", b.pass);
  if (b.go.kind == ExplainedGo::Kind::call)
    out += fmt::format("  calls {}, {}:{}\n", b.go.program, b.go.to.file, b.go.to.line);
  return out;
}

/// "G43/G44/G49 and H: tool length compensation (ToolHeightOffsetSyntax)".
std::string users_text(const ExplainedWord& w, const Facts& facts) {
  std::string names;
  for (const std::string& user : w.users) names += (names.empty() ? "" : ", then ") + user;
  return fmt::format("{} ({})", facts.summary_of(w.users.back()), names);
}

std::string words_text(const ExplainedBlock& b, const Facts& facts) {
  std::string out;
  std::uint32_t column = 0;
  for (const ExplainedWord& w : b.words) {
    const std::string text = w.column == column ? std::string() : cut(printable(w.text), 40);
    column = w.column;
    std::string who, value = w.name;
    if (w.name.empty())
      who = w.reader.empty() ? "nothing reads it" : fmt::format("{} ({})", facts.summary_of(w.reader), w.reader);
    else
      who = w.users.empty() ? "nothing uses it" : users_text(w, facts);
    if (!w.value.empty()) value += " = " + short_value(w.value);
    out += fmt::format("  {:<20} {:<20} {}\n", text, value, who);
  }
  return out.empty() ? out
                     : fmt::format("\nWords, and who uses them{}:\n", facts.is_inch() ? " (values in mm)" : "") + out;
}

std::string variables_text(const ExplainedBlock& b, const Facts& facts) {
  std::string out;
  for (const ExplainedVariable& v : b.variables) {
    const std::string value = v.name + (v.value.empty() ? " has no value" : " = " + short_value(v.value));
    std::string who = "no block has written it";
    if (!v.writer.empty()) {
      who = facts.place(v.written);
      if (const std::string text = facts.line_text(v.written); !text.empty()) who += ": " + cut(printable(text), 50);
      who += " (" + v.writer + ")";
      if (v.written_value != v.value)
        who += ", which wrote " + (v.written_value.empty() ? "none" : short_value(v.written_value));
    }
    out += fmt::format("  {:<20} {}\n", printable(value), who);
  }
  return out.empty() ? out : "\nVariables that the block reads, and who wrote them:\n" + out;
}

std::string strokes_text(const std::vector<Stroke>& strokes, const Facts& facts) {
  if (strokes.empty()) return {};
  const auto columns = [&](const std::optional<std::array<double, 3>>& p) {
    return p ? point_columns(*p, facts) : std::string(33, ' ');
  };
  std::string out =
      fmt::format("\n{:<16}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}\n",
                  facts.is_inch() ? "Steps, in inch:" : "Steps, in mm:", "program X", "Y", "Z", "machine X", "Y", "Z");
  for (const Stroke& s : strokes) {
    std::string line = fmt::format("  {:<14}{}{}", s.does, columns(s.program), columns(s.machine));
    if (s.feed_mm_min && s.does != "rapid") line += "  " + facts.feed(*s.feed_mm_min);
    if (s.turns) line += "  to " + s.to;
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n" + (s.reason.empty() ? "" : "      " + s.reason + "\n");
  }
  return out;
}

/// The dependencies that answer the syntax: tables of the dialect, or of the machine.
std::string asked(const ExplainedStep& step) {
  std::string out;
  for (const ExplainedAnswer& a : step.answers)
    if (out.find(" " + a.dependency) == std::string::npos) out += (out.empty() ? ", asks " : ", ") + a.dependency;
  return out;
}

std::string place_of(const ExplainedRow& r) {
  return r.where.file.empty() ? "given by --set, or by the table itself"
                              : fmt::format("{}:{}", r.where.file, r.where.line);
}

/// What the sections above tell already.
bool is_told(const ExplainedStep& step, const ExplainedChange& c) {
  if (c.path.starts_with("CompoundMotion.Items[") || c.path.starts_with("Vars.Read[")) return true;
  return c.path.starts_with("Parsing.") && (step.is_scan || c.after.empty());
}

std::string value_text(const std::string& path, const std::string& value) {
  const bool is_matrix = path.starts_with(transform_paths) && path.ends_with("].Mat4d");
  return is_matrix ? effect_of_json(value) : short_value(value);
}

std::string change_text(const ExplainedChange& c) {
  std::string path = c.path;
  if (path.starts_with(transform_paths)) {
    if (path.ends_with("].Kind") && (c.after == "\"Static\"" || c.after.empty())) return {};
    if (path.ends_with("].Mat4d")) path.erase(path.size() - 6);
  }
  const std::string before = value_text(c.path, c.before), after = value_text(c.path, c.after);
  if (c.before.empty()) return fmt::format("  + {} = {}\n", path, after);
  if (c.after.empty()) return fmt::format("  - {} = {}\n", path, before);
  return fmt::format("  ~ {} = {} (was {})\n", path, after, before);
}

/// "G43/G44/G49 and H: tool length compensation (ToolHeightOffsetSyntax, iso)"; among all calls the name comes first.
std::string title_of_step(const ExplainedStep& step, const Facts& facts, Amount amount) {
  if (step.plugin.empty()) return step.syntax;
  if (amount == Amount::all) return fmt::format("{} ({})", step.syntax, step.plugin);
  return fmt::format("{} ({}, {})", facts.summary_of(step.syntax), step.syntax, step.plugin);
}

std::string steps_text(const ExplainedBlock& b, const Facts& facts, Amount amount) {
  std::string out;
  for (const ExplainedStep& step : b.steps) {
    std::string changes;
    for (const ExplainedChange& c : step.changes)
      if (amount == Amount::all || !is_told(step, c)) changes += change_text(c);
    if (changes.empty() && step.rows.empty() && amount != Amount::all) continue;
    out += "\n" + title_of_step(step, facts, amount) + asked(step) + "\n";
    for (const ExplainedRow& r : step.rows)
      out += fmt::format("  row {} of {}, {}\n", r.row, r.dependency, place_of(r));
    out += changes.empty() && amount == Amount::all ? "  was called, changed nothing\n" : changes;
  }
  return out.empty() ? out : "\nWhat the block changes (+ new, ~ changed, - used up):\n" + out;
}

std::string origin(const ExplainedValue& v, const Facts& facts) {
  if (v.writer.empty()) return v.set.line == 0 ? "initial state" : facts.place(v.set);
  return v.writer + ", " + facts.place(v.set);
}

std::string values_text(const std::vector<ExplainedValue>& values, const char* title, const Facts& facts) {
  if (values.empty()) return {};
  std::string out = fmt::format("\n{}\n", title);
  std::size_t width = 0;
  for (const ExplainedValue& v : values)
    width = std::max(width, v.path.size() + value_text(v.path, v.value).size() + 3);
  for (const ExplainedValue& v : values)
    out += fmt::format("  {:<{}}  {}\n", v.path + " = " + value_text(v.path, v.value), std::min<std::size_t>(width, 60),
                       origin(v, facts));
  return out;
}

std::string slept_text(const std::vector<SleepingSyntax>& list) {
  if (list.empty()) return {};
  std::string out = "\nSlept, since nothing that wakes them was set:\n", line = " ";
  for (const SleepingSyntax& s : list) {
    if (line.size() + s.syntax.size() > 98) {
      out += line + "\n";
      line = " ";
    }
    line += " " + s.syntax;
  }
  return out + line + "\n";
}

}  // namespace

std::string text_of(const ExplainedBlock& b, Amount amount, LineTexts& lines, std::span<const Diagnostic> reports) {
  const Facts facts(b, lines, reports);
  const std::vector<Stroke> strokes = strokes_of(facts);
  std::string sentence = sentence_of(facts, strokes) + "\n";
  if (amount == Amount::sentence) return sentence;
  std::string out = fmt::format("{}:{}: {}\n", b.where.file, b.where.line, printable(b.text, "\t"));
  out += where_the_run_is(b) + sentence + words_text(b, facts) + variables_text(b, facts) +
         strokes_text(strokes, facts) + ladder_text(facts) + steps_text(b, facts, amount);
  if (amount != Amount::all) return out;
  return out + values_text(b.carried, "Carried into the block:", facts) +
         values_text(b.values, "After the block:", facts) + slept_text(b.slept);
}

}  // namespace isogloss::cli
