#include "run_progress.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace isogloss::cli {

std::uint64_t size_of_program(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return 0;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

void show_progress(RunOptions& options, const std::string& path, Session& session) {
  options.progress = [&session, path, size = size_of_program(path)](std::uint64_t blocks, std::uint64_t bytes) {
    session.progress().show(bytes, size, fmt::format("{}: {} blocks", path, blocks));
  };
}

void ComparisonProgress::step() {
  constexpr std::uint64_t interval = 256;
  if (++steps_ % interval == 0)
    session_.progress().show(run_.bytes(), size_, fmt::format("{}: {} blocks compared", path_, steps_));
}

}  // namespace isogloss::cli
