// A run in two halves is one run: `isogloss state --as-preamble` writes blocks that restore the state at a line, and
// behind them the rest of the program makes the motions of the whole. Where the command refuses, it says why.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include <sys/wait.h>

#include "events.hpp"
#include "property.hpp"

namespace isogloss::properties {

namespace {

namespace fs = std::filesystem;

std::string text_of_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A folder of this process, which is removed at its end.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "isogloss-properties-XXXXXX").string();
    folder = ::mkdtemp(name.data()) != nullptr ? name : "";
  }
  ~Scratch() {
    std::error_code ignored;
    if (!folder.empty()) fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path folder;
};

struct Restart {
  int status = 0;
  std::string preamble, errors;
};

Restart restart_at(const Case& program, const std::string& text, std::uint32_t line) {
  static const Scratch scratch;
  const fs::path part = scratch.folder / "part.nc", out = scratch.folder / "out", errors = scratch.folder / "errors";
  std::ofstream(part, std::ios::binary) << text;
  std::string command = "'" ISOGLOSS_HOME "/isogloss' state '" + part.string() + ":" + std::to_string(line) +
                        "' --as-preamble -d " + program.dialect;
  for (const auto& [cell, value] : program.assignments()) command += " --set " + cell + "=" + value;
  command += " --max-blocks 2000 --max-jumps 2000 --max-loop-blocks 2000 > '" + out.string() + "' 2> '" +
             errors.string() + "'";
  Restart made;
  const int ended = std::system(command.c_str());
  made.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128;
  made.preamble = text_of_file(out);
  made.errors = text_of_file(errors);
  return made;
}

/// By the 6 decimals of a preamble and what adding to a rounded start costs.
bool near(double a, double b) { return std::abs(a - b) <= 2e-5 * std::max(1.0, std::abs(a) / 100); }

bool near(const MotionPoint& a, const MotionPoint& b) {
  return a.known == b.known &&
         std::equal(std::begin(a.at), std::end(a.at), std::begin(b.at), [](double p, double q) { return near(p, q); });
}

bool same(const Event& a, const Event& b) {
  return a.kind == b.kind && near(a.program, b.program) && near(a.machine, b.machine) && a.is_led == b.is_led &&
         a.has_feed == b.has_feed && near(a.feed, b.feed) && a.has_value == b.has_value && near(a.value, b.value) &&
         a.tool == b.tool && a.term == b.term && a.has_center == b.has_center && near(a.sweep, b.sweep);
}

/// Of lines that hold something, one that the seed chooses; 0: there is none.
std::uint32_t chosen_line(const Case& program) {
  std::vector<std::uint32_t> lines;
  for (std::uint32_t line = 2; line <= program.lines.size(); ++line)
    if (!program.lines[line - 1].empty()) lines.push_back(line);
  return lines.empty() ? 0 : lines[program.seed % lines.size()];
}

/// What differs; empty: nothing. None where a limit ended the whole before its own end.
std::optional<std::string> compare(const Case& program, const std::string& text, const std::string& preamble,
                                   const std::string& rest) {
  DiagnosticList said, unheard;
  const Events whole = events_of(program.dialect, text, options_of(program), {true}, {}, said);
  const auto is_limit = [](const Diagnostic& d) { return d.code == "IG-0407" || d.code == "IG-0455"; };
  if (std::any_of(said.all.begin(), said.all.end(), is_limit)) return std::nullopt;
  Events again = events_of(program.dialect, preamble + rest, options_of(program), {true}, {}, unheard);
  const auto head = static_cast<std::uint32_t>(std::count(preamble.begin(), preamble.end(), '\n'));
  const auto last = std::find_if(again.rbegin(), again.rend(), [&](const Event& e) { return e.line <= head; });
  again.erase(again.begin(), last.base());
  if (again.size() > whole.size()) return "the second half has more motions than the whole";
  const auto tail = whole.end() - static_cast<std::ptrdiff_t>(again.size());
  for (std::size_t i = 0; i < again.size(); ++i)
    if (!same(tail[static_cast<std::ptrdiff_t>(i)], again[i]))
      return "another motion in line " + std::to_string(again[i].line) + " of the second half";
  return "";
}

}  // namespace

Verdict judge_halves(const Case& program) {
  const std::string text = program.text();
  const std::uint32_t line = chosen_line(program);
  if (line == 0) return {};
  const Restart made = restart_at(program, text, line);
  const std::string where = "restart at line " + std::to_string(line) + ": ";
  if (made.status == 1) {
    const bool says_why = made.errors.find("error: ") != std::string::npos;
    return {false, says_why ? "" : where + "refused without a reason\n" + made.errors};
  }
  if (made.status != 0) return {true, where + "status " + std::to_string(made.status) + "\n" + made.errors};
  // Of a block of several lines the first one is where the rest begins.
  constexpr std::string_view words = "RESTART AT LINE ";
  const std::size_t at = made.preamble.find(words);
  if (at == std::string::npos) return {true, where + "the preamble does not name its line\n" + made.preamble};
  const auto begin = static_cast<std::size_t>(std::stoul(made.preamble.substr(at + words.size())));
  // What G10 has set stays in the control: the second run would begin with other tables.
  if (made.errors.find("IG-0198") != std::string::npos) return {};
  std::string rest;
  for (std::size_t i = begin - 1; i < program.lines.size(); ++i) rest += program.lines[i] + "\n";
  const std::optional<std::string> fault = compare(program, text, made.preamble, rest);
  if (!fault) return {};
  return {true, fault->empty() ? "" : where + *fault + "\n" + made.preamble};
}

}  // namespace isogloss::properties
