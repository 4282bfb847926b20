#include "batch/journal.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "catalogue.hpp"

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

constexpr const char* folder_of_journal = "journal";

std::optional<Finished> read_line(const std::string& line) {
  try {
    const Json all = Json::parse(line);
    if (!all.at("Result").at("Status").is_string()) return std::nullopt;
    return Finished{all.at("Program").get<std::string>(),
                    all.at("Surroundings").get<std::string>(),
                    all.at("Content").get<std::string>(),
                    all.at("Called").get<std::map<std::string, std::string>>(),
                    all.at("Folders").get<std::map<std::string, std::string>>(),
                    all.at("Result").dump()};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Journal::read(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (fs::directory_iterator at(fs::path(folder) / folder_of_journal, error), end; !error && at != end;
       at.increment(error))
    if (at->path().extension() == ".jsonl") files.push_back(at->path().string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) read_file(file);
}

void Journal::read_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    if (std::optional<Finished> finished = read_line(line)) {
      std::string program = finished->program;
      all_.emplace(std::move(program), std::move(*finished));
    } else {
      ++damaged_;
    }
  }
}

std::string Journal::open(const std::string& folder) {
  std::error_code error;
  const fs::path place = fs::path(folder) / folder_of_journal;
  fs::create_directories(place, error);
  if (error) return error.message();
  char host[256] = "host";
  ::gethostname(host, sizeof host - 1);
  std::string name = (place / host).string() + "-XXXXXX.jsonl";
  descriptor_ = ::mkostemps(name.data(), static_cast<int>(std::strlen(".jsonl")), O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) return std::strerror(errno);
  ::fchmod(descriptor_, 0644);
  return {};
}

bool Journal::append(const Finished& finished) {
  const Json all{{"Program", finished.program}, {"Surroundings", finished.surroundings},
                 {"Content", finished.content}, {"Called", finished.called},
                 {"Folders", finished.folders}, {"Result", Json::parse(finished.result)}};
  const std::string line = all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t n = ::write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
  all_.emplace(finished.program, finished);
  return true;
}

const Finished* Journal::find(const std::string& program, const std::string& surroundings, FileHashes& hashes) const {
  const auto [first, last] = all_.equal_range(program);
  for (auto at = first; at != last; ++at) {
    const Finished& one = at->second;
    const auto is_same = [&](const auto& file) { return hashes.of(file.first) == file.second; };
    const auto has_same_names = [&](const auto& folder) { return hashes.of_names_in(folder.first) == folder.second; };
    if (one.surroundings == surroundings && hashes.of(program) == one.content &&
        std::all_of(one.called.begin(), one.called.end(), is_same) &&
        std::all_of(one.folders.begin(), one.folders.end(), has_same_names))
      return &one;
  }
  return nullptr;
}

}  // namespace isogloss::cli::batch
