#include "canonical_text.hpp"

#include <charconv>

namespace isogloss::cli {

void CanonicalRequest::add_to(CommandLine& line) {
  line.option(
          "--frame", frame,
          "Canonical: machine coordinates of the gauge point, or program coordinates, each from the origin in force")
      .one_of({"machine", "program"})
      .type_name("machine|program")
      .shows_default();
  line.option(
          "--tolerance", tolerance,
          "Canonical: how far, in mm, lines may lie from a path that arcs and lines cannot describe (tilted arcs, tip "
          "control)")
      .type_name("MM")
      .shows_default();
}

/// What the user gives for the table of words; the rest belongs to the run.
ChainSettings CanonicalRequest::own_words(const LinkedDialect& words, const ChainSettings& settings) {
  ChainSettings out;
  DiagnosticList unheard;
  Chain chain(words, {}, unheard);
  const auto place = chain.answering("isogloss.program-text/1");
  if (!place) return out;
  const std::string& table = words.dependencies[*place].element.alias;
  for (const DependencyElement& d : settings.dependencies)
    if (d.id == table) out.dependencies.push_back(d);
  for (const auto& one : settings.assignments)
    if (one.first.starts_with(table + ".")) out.assignments.push_back(one);
  return out;
}

bool CanonicalRequest::prepare(const std::string& format, const ChainSettings& settings, Session& session) {
  const auto [end, error] = std::from_chars(tolerance.data(), tolerance.data() + tolerance.size(), tolerance_mm);
  if (error != std::errc() || end != tolerance.data() + tolerance.size() || !(tolerance_mm >= 1e-6) ||
      tolerance_mm > 1000) {
    session.report("IG-0513", {}, {"--tolerance needs a length in mm, 0.000001 to 1000, not '" + tolerance + "'"});
    return false;
  }
  if (format != "jsonl") {
    session.report("IG-0513", {}, {"the canonical program is text of its own form: leave --format out"});
    return false;
  }
  const std::unique_ptr<LinkedDialect> words = session.link(default_dialect);
  if (words == nullptr) return false;
  DiagnosticList unheard;  // of tables that no run asks
  Chain chain(*words, own_words(*words, settings), unheard);
  text = ProgramText::of(chain);
  if (text.find("rapid") != nullptr) return true;
  session.report("IG-0194", {}, {default_dialect, "the motions of a run"});
  return false;
}

CanonicalOptions CanonicalRequest::options(bool exact, bool zero_moves) const {
  return {frame == "program" ? CanonicalOptions::Frame::program : CanonicalOptions::Frame::machine, exact, zero_moves,
          tolerance_mm};
}

}  // namespace isogloss::cli
