// A run whose lines another thread scans ahead is the run that scans by itself: the same motions, the same fields in
// each block, the same diagnostics. Only programs of many lines are scanned ahead, so the lines of a program are
// repeated.
#include <array>
#include <regex>

#include "isogloss/engine/exporter.hpp"
#include "product.hpp"
#include "property.hpp"
#include "running.hpp"

namespace isogloss::properties {

namespace {

constexpr std::size_t long_enough = 128 * 1024;  // the thread begins 32 KiB ahead of the run

/// Nothing behind such a line would be run: it ends the program, or begins the next one.
bool ends_program(const std::string& line) {
  static const std::regex end(R"(^\s*[%:]|O[0-9<]|M0*(2|30|17|99)(?![0-9])|\b(RET|END PGM|STOP|PROC)\b)",
                              std::regex::icase);
  return std::regex_search(line, end);
}

std::string repeated(const Case& program) {
  std::string once;
  for (const std::string& line : program.lines)
    if (!ends_program(line)) once += line + "\n";
  std::string out;
  while (!once.empty() && out.size() < long_enough) out += once;
  return out;
}

struct Told {
  std::string motions, blocks;
  std::vector<Diagnostic> diagnostics;
  std::uint64_t lines = 0;
};

Told run_it(const Case& program, const std::string& text, std::uint64_t scans_ahead_after) {
  RunOptions options = options_of(program);
  options.maximum_blocks = 20'000;
  options.maximum_motions = 100'000;
  options.scans_ahead_after = scans_ahead_after;
  product::TextOutput motions, blocks;
  const auto csv = make_motion_exporter(motions, {Format::csv, false, true, true, {}});
  const auto all = make_block_exporter(blocks, Format::jsonl);
  DiagnosticList said;
  const std::unique_ptr<Source> source = memory_source(text);
  const RunResult result =
      run(product::dialect(program.dialect), *source, "program", options, {csv.get(), all.get()}, said);
  return {std::move(motions.text), std::move(blocks.text), std::move(said.all), result.lines};
}

/// The first line of two texts that differs, as both have it; empty: none does.
std::string difference(std::string_view a, std::string_view b) {
  const auto next = [](std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
  };
  while (!a.empty() || !b.empty())
    if (const std::array both{next(a), next(b)}; both[0] != both[1])
      return "alone:\n" + std::string(both[0]) + "\nscanned ahead:\n" + std::string(both[1]);
  return "";
}

std::string all_shown(const std::vector<Diagnostic>& diagnostics) {
  std::string out;
  for (const Diagnostic& d : diagnostics) out += shown(d) + "\n";
  return out;
}

}  // namespace

Verdict judge_ahead(const Case& program) {
  const std::string text = repeated(program);
  const Told alone = run_it(program, text, 0), ahead = run_it(program, text, 1);
  const bool is_long = alone.lines > 1'000;
  for (const std::string& fault : {difference(alone.motions, ahead.motions), difference(alone.blocks, ahead.blocks),
                                   difference(all_shown(alone.diagnostics), all_shown(ahead.diagnostics))})
    if (!fault.empty()) return {true, fault};
  return {is_long, ""};
}

}  // namespace isogloss::properties
