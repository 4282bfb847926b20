#include "view/viewer.hpp"

#include <algorithm>

#include "dialect_files.hpp"

namespace isogloss::cli::viewing {

namespace fs = std::filesystem;

bool Viewer::has_two_sides() const {
  for (std::size_t i = 0; i < 2; ++i)
    if (!options_.dialects[i].empty() || !options_.machines[i].empty()) return true;
  return false;
}

bool Viewer::load(Session& session) {
  Viewed made;
  made.program = KeptProgram::open(options_.path, session);
  if (made.program == nullptr) return false;
  const std::size_t sides = has_two_sides() ? 2 : 1;
  for (std::size_t i = 0; i < sides; ++i) {
    ToolPathOptions path = options_.moves;
    path.keeps_ends = sides == 2;
    ProgramOptions of_side = options_.program;
    if (!of_side.take_side(options_.dialects[i], options_.machines[i], session)) return false;
    made.runs.push_back(run_path(*made.program, of_side, path, {}, session));
    if (made.runs.back() == nullptr) return false;
  }
  constexpr std::size_t most_differences = 1'000;
  if (sides == 2) made.differences = mark_differences(made.runs[0]->path, made.runs[1]->path, most_differences);
  made.files.push_back(options_.path);
  for (const auto& run : made.runs)
    for (const std::string& file : run->path.files)
      if (std::find(made.files.begin(), made.files.end(), file) == made.files.end()) made.files.push_back(file);
  if (made.runs[0]->path.extent.is_empty) session.report("IG-0651", {options_.path}, {});
  session.diagnostics().finish_program();
  status_ = session.status();
  viewed_ = std::move(made);
  note_files();
  return true;
}

Viewer::State Viewer::state_of(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return {};
  return {fs::last_write_time(file, code), fs::file_size(file, code)};
}

/// The program and what it calls, the user's tables, the files of the dialects and those that their tables name.
void Viewer::note_files() {
  std::vector<std::string> files = viewed_.files;
  const ProgramOptions& p = options_.program;
  for (const std::string& file : {p.offsets, p.tools, p.variables}) files.push_back(file);
  for (const auto& run : viewed_.runs)
    for (std::string& file : files_of_dialect(run->linked->dialect)) files.push_back(std::move(file));
  files_.clear();
  for (const std::string& file : files)
    if (!file.empty() && file != "-") files_.try_emplace(file, state_of(file));
}

bool Viewer::has_changed() const {
  return std::any_of(files_.begin(), files_.end(),
                     [](const auto& file) { return state_of(file.first) != file.second; });
}

}  // namespace isogloss::cli::viewing
