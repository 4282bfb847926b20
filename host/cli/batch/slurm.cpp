#include "batch/slurm.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "batch/run_surroundings.hpp"
#include "outputs.hpp"

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

/// One word for a shell, whatever it holds.
std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

enum class Job : std::uint8_t { part, merge };

/// What the batch was given, without what makes it submit itself; the job that merges runs nothing.
std::string command_of(const BatchArguments& arguments, Job job, const std::string& more) {
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  std::string out = quoted((error ? folder_of_executable() / "isogloss" : command).string()) + " batch " + more;
  std::vector<std::string> flags{"--no-submit"}, options{"--slurm", "--slurm-options"};
  if (job == Job::merge) {
    flags.emplace_back("--retry");
    options.insert(options.end(), {"-j", "--jobs", "--changed-since"});
  }
  const auto is_one_of = [](const std::vector<std::string>& names, const std::string& word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  };
  bool are_names = false;  // behind --
  for (std::size_t i = 0; i < arguments.given.size(); ++i) {
    const std::string& word = arguments.given[i];
    are_names = are_names || word == "--";
    if (are_names) {
      out += " " + quoted(word);
      continue;
    }
    const bool holds_value = std::any_of(options.begin(), options.end(), [&](const std::string& name) {
      return word.starts_with(name.starts_with("--") ? name + "=" : name);
    });
    if (is_one_of(options, word))
      ++i;
    else if (!holds_value && !is_one_of(flags, word))
      out += " " + quoted(word);
  }
  return out;
}

/// In a file name of Slurm, % begins a placeholder.
std::string log_name(const fs::path& folder, const std::string& name) {
  std::string out;
  for (const char c : folder.string()) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out + "/" + name;
}

std::string script(const BatchArguments& arguments, const fs::path& here, const fs::path& folder,
                   const std::string& log, const std::string& head, Job job, const std::string& more) {
  return fmt::format(
      "#!/bin/sh\n#SBATCH --job-name=isogloss\n#SBATCH --output=\"{}\"\n#SBATCH --open-mode=append\n{}{}cd {} || exit "
      "2\nexec {}\n",
      log_name(folder, log), head, arguments.slurm_options.empty() ? "" : "#SBATCH " + arguments.slurm_options + "\n",
      quoted(here.string()), command_of(arguments, job, more));
}

/// The number of the job that sbatch has made: a line of digits, with the cluster's name behind a semicolon, beside
/// warnings. What it said instead in `error`.
std::string submit(const std::string& words, std::string& error) {
  std::FILE* const pipe = ::popen(("sbatch --parsable " + words + " 2>&1").c_str(), "re");
  if (pipe == nullptr) return error = "no process", std::string();
  std::string said;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) said.append(buffer, n);
  const int status = ::pclose(pipe);
  std::istringstream lines(said);
  for (std::string line; status == 0 && std::getline(lines, line);) {
    std::string number = line.substr(0, line.find(';'));
    if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos) return number;
  }
  error = said.substr(0, said.find('\n'));
  if (error.empty()) error = fmt::format("sbatch ended with status {}", WEXITSTATUS(status));
  return {};
}

}  // namespace

int run_on_slurm(const BatchArguments& arguments, Session& session) {
  if (arguments.slurm_options.find('\n') != std::string::npos) {
    session.report("IG-0513", {}, {"--slurm-options is one line"});
    return cannot_start;
  }
  std::error_code code;
  const fs::path here = fs::current_path(code), folder = here / arguments.output / "slurm";
  if (code) {
    session.report("IG-0513", {}, {"the jobs run in this folder, which cannot be reached: " + code.message()});
    return cannot_start;
  }
  if (folder.string().find_first_of("\"\n\\") != std::string::npos) {
    session.report("IG-0513", {},
                   {"Slurm takes no quotation mark, no backslash and no line break in the name of a folder"});
    return cannot_start;
  }
  // Where no part could run, nothing waits in a queue for it.
  FileHashes hashes;
  const bool can_run = surroundings_of(arguments, hashes, session, Trial::of_chain).has_value();
  if (!can_run || !list_programs(arguments.places, session)) return cannot_start;
  fs::create_directories(folder, code);
  if (code) {
    session.report("IG-0511", {folder.string()}, {code.message()});
    return cannot_start;
  }
  const std::string parts = (folder / "parts.sh").string(), merge = (folder / "merge.sh").string();
  const std::uint32_t count = arguments.slurm_parts;
  if (!write_file(parts,
                  script(arguments, here, folder, "part-%a.log",
                         fmt::format("#SBATCH --array=1-{}\n#SBATCH --requeue\n", count), Job::part,
                         fmt::format("--shard \"$SLURM_ARRAY_TASK_ID/{}\"", count)),
                  session) ||
      !write_file(merge, script(arguments, here, folder, "merge.log", "", Job::merge, "--merge"), session))
    return cannot_start;
  if (arguments.holds_back) {
    std::fputs(fmt::format("sbatch {}, and behind it sbatch --dependency=afterany:JOB {}\n", parts, merge).c_str(),
               stderr);
    return success;
  }
  std::string error;
  const std::string job = submit(quoted(parts), error);
  const std::string last = job.empty() ? "" : submit("--dependency=afterany:" + job + " " + quoted(merge), error);
  if (last.empty()) {
    if (!job.empty()) error = "the parts are job " + job + ", but nothing merges them: " + error;
    session.report("IG-0674", {}, {error, parts, merge});
    return cannot_start;
  }
  std::fputs(
      fmt::format("job {} runs {} parts, job {} merges them into {}\n", job, count, last, arguments.output).c_str(),
      stderr);
  return success;
}

}  // namespace isogloss::cli::batch
