#include "diff/diff_request.hpp"

#include <charconv>

namespace isogloss::cli::parting {

void DiffRequest::add_to(CommandLine& line) {
  line.option("PROGRAM", programs,
              "Programs, each compared with itself in A and B; or two programs, where no option names two sides")
      .required();
  static constexpr const char* names[2][6] = {
      {"-a", "--machine-a", "--set-a", "Dialect of side A, by name or file (default: -d)",
       "Machine of side A (default: -m)", "As --set, on side A alone (repeatable)"},
      {"-b", "--machine-b", "--set-b", "Dialect of side B, by name or file (default: -d)",
       "Machine of side B (default: -m)", "As --set, on side B alone (repeatable)"}};
  for (std::size_t side = 0; side < 2; ++side) {
    line.option(names[side][0], dialects[side], names[side][3]).type_name("DIALECT").group("Two sides");
    line.option(names[side][1], machines[side], names[side][4]).type_name("MACHINE").group("Two sides");
    line.option(names[side][2], sets[side], names[side][5]).type_name("NAME=VALUE").names_once().group("Two sides");
  }
  line.option("--against", against, "The program of side B, where PROGRAM is that of side A alone")
      .type_name("FILE")
      .group("Two sides");
  line.flag("--motions", motions, "Compare the resolved motions alone: how far they are apart, not why");
  line.option("--tolerance", tolerance_text,
              "With --motions: what counts as the same, in mm and in degrees, each from 0 to 1000, e.g. 0.01 or "
              "0.01,0.05 (default: 0.000001)")
      .type_name("MM[,DEG]");
  line.option("--ignore", ignored, "Do not compare this field or section, e.g. Comment or Source.N (repeatable)")
      .type_name("FIELD")
      .not_with("--motions");
  line.flag("--all", all, "List every block that differs, after the causes");
  line.flag("--json", json, "Write JSON");
  line.option("--html", page, "Write a page that shows all of it, too").type_name("FILE");
  program.add_to(line);
  untrusted.add_to(line);
  common.add_to(line);
}

UntrustedWork DiffRequest::untrusted_work() const {
  UntrustedWork out = cli::untrusted_work(common, program);
  out.programs = programs;
  if (!against.empty()) out.programs.push_back(against);
  for (std::size_t side = 0; side < 2; ++side) {
    out.reads.push_back(machines[side]);
    out.add_dialect(dialects[side]);
  }
  out.outputs.push_back(page);
  return out;
}

bool DiffRequest::has_sides() const {
  for (std::size_t side = 0; side < 2; ++side)
    if (!dialects[side].empty() || !machines[side].empty() || !sets[side].empty()) return true;
  return false;
}

/// Which programs stand on which side.
bool DiffRequest::read_operands(Session& session) {
  second_ = against;
  if (second_.empty() && !has_sides() && programs.size() == 2) {
    second_ = programs.back();
    programs.pop_back();
  }
  if (!against.empty() && programs.size() > 1) {
    session.report("IG-0513", {}, {"--against compares one PROGRAM with one other, not several"});
    return false;
  }
  if (second_.empty() && !has_sides()) {
    session.report("IG-0185", {}, {}, "isogloss diff -a fanuc -b syntec part.nc");
    return false;
  }
  if (!program.serves_a_side(dialects, machines, session)) return false;
  if (second_ == "-" && programs.front() == "-") {
    session.report("IG-0513", {}, {"standard input is one program: the other needs a file"});
    return false;
  }
  return true;
}

/// "0.01" or "0.01,0.05".
std::optional<Tolerance> DiffRequest::read_tolerance(Session& session) const {
  Tolerance out;
  if (tolerance_text.empty()) return out;
  const std::string_view text = tolerance_text;
  const std::size_t comma = text.find(',');
  const auto read = [](std::string_view part, double& value) {
    constexpr double greatest = 1000;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    return !part.empty() && error == std::errc() && end == part.data() + part.size() && value >= 0 && value <= greatest;
  };
  bool is_sound = motions && read(text.substr(0, comma), out.mm);
  out.degrees = out.mm;
  if (comma != std::string_view::npos) is_sound = is_sound && read(text.substr(comma + 1), out.degrees);
  if (is_sound) return out;
  session.report("IG-0186", {}, {tolerance_text}, motions ? "" : "it belongs to --motions");
  return std::nullopt;
}

}  // namespace isogloss::cli::parting
