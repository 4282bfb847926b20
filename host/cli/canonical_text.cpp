#include "canonical_text.hpp"

#include <charconv>

#include "isogloss/engine/chain.hpp"

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

bool CanonicalRequest::prepare(const std::string& format, Session& session) {
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
  Chain chain(*words, {}, unheard);
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
