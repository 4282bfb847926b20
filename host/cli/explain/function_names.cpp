// What a machinist calls the parts of a chain and of a block document, and how the program writes lengths.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "explain/facts.hpp"
#include "explain/frame_text.hpp"

namespace isogloss::cli {

namespace {

/// Sections whose names are not what a machinist says.
constexpr std::pair<std::string_view, std::string_view> spoken_sections[] = {
    {"ToolHeightCompensation", "tool length compensation"},
    {"RadiusCompensation", "cutter radius compensation"},
    {"CoordinateOffset", "work offset"},
    {"LocalCoordinateOffset", "local offset"},
    {"TiltTransform", "rotation of the plane"},
    {"PivotTransform", "position of the rotary axes"},
};

/// "ToolOrientation" → "tool orientation".
std::string in_small_words(std::string_view section) {
  std::string out;
  for (const char c : section) {
    const bool is_capital = c >= 'A' && c <= 'Z';
    if (is_capital && !out.empty()) out += ' ';
    out += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

/// "Turns G91 distances into positions" says what it does, unlike "Cycles that act where they are defined".
bool begins_with_verb(std::string_view summary) {
  const std::size_t end = std::min(summary.find(' '), summary.size());
  if (end < 3 || summary[end - 1] != 's' || summary[1] < 'a') return false;
  const std::string_view next = summary.substr(std::min(end + 1, summary.size()));
  for (const std::string_view of_a_noun : {"of ", "that ", "and "})
    if (next.starts_with(of_a_noun)) return false;
  return !next.empty() && (next[0] < '0' || next[0] > '9');
}

/// "G43/G44/G49 and H: tool length compensation" → "tool length compensation (G43/G44/G49 and H)"; as it stands within
/// a sentence: "The path …" → "the path …".
std::string title_of(std::string summary) {
  const std::size_t colon = summary.find(": ");
  const auto is_small = [&](std::size_t i) { return i < summary.size() && summary[i] >= 'a' && summary[i] <= 'z'; };
  const bool is_verb = begins_with_verb(summary);
  const bool is_word = is_small(1) || (summary.starts_with("A ") && is_small(2));
  if (is_word && summary[0] >= 'A' && summary[0] <= 'Z') summary[0] = static_cast<char>(summary[0] - 'A' + 'a');
  if (is_verb) return "the function that " + summary;
  if (colon == std::string::npos) return summary;
  return fmt::format("{} ({})", summary.substr(colon + 2), summary.substr(0, colon));
}

}  // namespace

std::string section_words(std::string_view section) {
  for (const auto& [name, words] : spoken_sections)
    if (name == section) return std::string(words);
  return in_small_words(section);
}

std::string Facts::name_of(const ExplainedRung& rung) const {
  if (rung.label.empty()) return section_words(rung.source);
  const std::string text = line_text(rung.label_since);
  if (text.empty() || mentions(text, rung.label) || mentions(line_text(rung.since), rung.label)) return rung.label;
  return section_words(rung.source);
}

std::string Facts::function_of(const std::string& syntax) const {
  // A text that does not hold the name of its code is not what a program writes for it.
  for (const ExplainedWord& w : block_.words)
    if (w.value.empty() && mentions(w.text, w.name) &&
        std::find(w.users.begin(), w.users.end(), syntax) != w.users.end())
      return w.text.size() <= w.name.size() ? w.text : w.name;
  if (std::string code = code_served_by(syntax); !code.empty()) return code;
  std::string title = title_of(summary_of(syntax));
  for (const ExplainedValue& v : block_.values) {
    if (v.writer != syntax || v.value.size() < 3 || v.value.front() != '"' || v.since.line == 0) continue;
    const std::string code = v.value.substr(1, v.value.size() - 2);
    if (mentions(line_text(v.since), code)) return fmt::format("{} of {}", code, place(v.since));
    if (!is_here(v.since)) title += " of " + place(v.since);
    break;
  }
  return title;
}

/// The code in force that the summary of the syntax names: G91 for "Turns G91 distances into positions". Where the
/// program writes something else for it, as Klartext writes RL for G41, the section in words.
std::string Facts::code_served_by(const std::string& syntax) const {
  const std::string summary = summary_of(syntax);
  for (const ExplainedValue& v : block_.values) {
    if (v.value.size() < 4 || v.value.front() != '"' || v.since.line == 0) continue;
    const std::string code = v.value.substr(1, v.value.size() - 2);
    const bool has_number = code.find_first_of("0123456789") != std::string::npos;
    if (!has_number || !mentions(summary, code)) continue;
    const std::string name =
        mentions(line_text(v.since), code) ? code : section_words(v.path.substr(0, v.path.find('.')));
    return is_here(v.since) ? name : fmt::format("{} of {}", name, place(v.since));
  }
  return {};
}

std::string Facts::summary_of(const std::string& syntax) const {
  if (block_.summaries == nullptr) return syntax;
  const auto found = block_.summaries->find(syntax);
  if (found == block_.summaries->end() || found->second.empty()) return syntax;
  return found->second.substr(0, found->second.find_last_not_of(". ") + 1);
}

std::string Facts::length(double mm) const {
  if (!is_inch()) return short_number(mm);
  return fmt::format("{} inch ({} mm)", short_number(mm / unit_mm_), short_number(mm));
}

std::string Facts::feed(double mm_min) const {
  if (!is_inch()) return short_number(mm_min) + " mm/min";
  return fmt::format("{} inch/min ({} mm/min)", short_number(mm_min / unit_mm_), short_number(mm_min));
}

std::string Facts::words(const std::vector<std::pair<char, double>>& axes) const {
  std::string own, metric, rotary;
  for (const auto& [axis, value] : axes) {
    if (axis < 'X') {
      rotary += fmt::format(" {}{}", axis, short_number(value));
      continue;
    }
    own += fmt::format("{}{}{}", own.empty() ? "" : " ", axis, short_number(value / unit_mm_));
    metric += fmt::format("{}{}{}", metric.empty() ? "" : " ", axis, short_number(value));
  }
  if (is_inch() && !own.empty()) own += fmt::format(" inch ({} mm)", metric);
  return own.empty() ? rotary.substr(rotary.empty() ? 0 : 1) : own + rotary;
}

}  // namespace isogloss::cli
