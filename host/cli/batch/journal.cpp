#include "batch/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
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

using Hashes = std::map<std::string, std::string>;

Hashes with_texts(const Hashes& by_name) {
  Hashes out;
  for (const auto& [name, hash] : by_name) out[text_of_name(name)] = hash;
  return out;
}
Hashes with_names(const Hashes& by_text) {
  Hashes out;
  for (const auto& [text, hash] : by_text) out[name_of_text(text)] = hash;
  return out;
}

std::optional<Finished> read_line(const std::string& line) {
  try {
    const Json all = Json::parse(line);
    const std::string status = all.at("Result").at("Status").get<std::string>();
    return Finished{name_of_text(all.at("Program").get<std::string>()),
                    all.at("Surroundings").get<std::string>(),
                    all.at("Content").get<std::string>(),
                    with_names(all.at("Called").get<Hashes>()),
                    with_names(all.at("Places").get<Hashes>()),
                    all.at("Result").dump(),
                    status != "ok" && status != "errors"};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

bool is_utf8(std::string_view bytes) {
  try {
    static_cast<void>(Json(bytes).dump());
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

int digit(char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1; }

}  // namespace

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool Journal::read(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (fs::directory_iterator at(fs::path(folder) / folder_of_journal, error), end; !error && at != end;
       at.increment(error))
    if (at->path().extension() == ".jsonl") files.push_back(at->path().string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) read_file(file);
  return !files.empty();
}

void Journal::read_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) ++damaged_;
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
  char host[256] = "host";
  ::gethostname(host, sizeof host - 1);
  name_ = (place / host).string() + "-XXXXXX.jsonl";
  return error ? error.message() : std::string();
}

const Finished* Journal::append(const Finished& finished, std::string& error) {
  if (descriptor_ < 0) {
    descriptor_ = ::mkostemps(name_.data(), static_cast<int>(std::strlen(".jsonl")), O_APPEND | O_CLOEXEC);
    if (descriptor_ < 0) return error = std::strerror(errno), nullptr;
    ::fchmod(descriptor_, 0644);
  }
  const Json all{{"Program", text_of_name(finished.program)},
                 {"Surroundings", finished.surroundings},
                 {"Content", finished.content},
                 {"Called", with_texts(finished.called)},
                 {"Places", with_texts(finished.places)},
                 {"Result", Json::parse(finished.result)}};
  const std::string line = all.dump() + "\n";
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t n = ::write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      error = std::strerror(errno);
      // Half a line would be reported as damaged by each later batch.
      [[maybe_unused]] const int is_cut = ::ftruncate(descriptor_, size_);
      return nullptr;
    }
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
  size_ += static_cast<std::int64_t>(line.size());
  return &all_.emplace(finished.program, finished)->second;
}

bool Journal::is_kept() const {
  using Stat = struct stat;
  Stat named{}, written{};
  return descriptor_ < 0 || (::fstat(descriptor_, &written) == 0 && ::stat(name_.c_str(), &named) == 0 &&
                             named.st_dev == written.st_dev && named.st_ino == written.st_ino);
}

std::string text_of_name(std::string_view name) {
  const bool is_text = is_utf8(name);
  std::string out;
  for (const char c : name) {
    const bool is_plain = c != '%' && (is_text || static_cast<unsigned char>(c) < 0x80);
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

std::string name_of_text(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_byte = text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
    out += is_byte ? static_cast<char>(digit(text[i + 1]) * 16 + digit(text[i + 2])) : text[i];
    if (is_byte) i += 2;
  }
  return out;
}

const Finished* Journal::find(const std::string& program, const std::string& surroundings, FileHashes& hashes) const {
  const auto [first, last] = all_.equal_range(program);
  const Finished* failure = nullptr;
  for (auto at = first; at != last; ++at) {
    const Finished& one = at->second;
    const auto is_same = [&](const auto& file) { return hashes.of(file.first) == file.second; };
    const auto is_same_place = [&](const auto& place) {
      return hashes.of_place(place.first, place.second.starts_with(contents_mark)) == place.second;
    };
    const bool is_valid = one.surroundings == surroundings && hashes.of(program) == one.content &&
                          std::all_of(one.called.begin(), one.called.end(), is_same) &&
                          std::all_of(one.places.begin(), one.places.end(), is_same_place);
    if (is_valid && !one.is_failure) return &one;
    if (is_valid && failure == nullptr) failure = &one;
  }
  return failure;
}

}  // namespace isogloss::cli::batch
