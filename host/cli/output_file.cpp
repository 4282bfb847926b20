#include "output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "command.hpp"
#include "crash_guard.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t buffer_size = std::size_t{256} << 10;
constexpr std::size_t large_piece = std::size_t{32} << 10;

/// Behind the name of the target: no file of a user is called so.
constexpr std::string_view mark_of_temporary = ".isogloss-XXXXXX";

/// In a process that can open no file for writing.
std::vector<OutputFile::Prepared>* prepared_files = nullptr;

mode_t current_umask() {
  const mode_t mask = umask(0);
  umask(mask);
  return mask;
}

}  // namespace

OutputFile::OutputFile(int descriptor, std::string target, std::string temporary)
    : descriptor_(descriptor),
      target_(std::move(target)),
      temporary_(std::move(temporary)),
      buffer_(std::make_unique_for_overwrite<char[]>(buffer_size)) {
  if (!temporary_.empty()) remove_when_killed(temporary_.c_str());
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDERR_FILENO) close(descriptor_);
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  keep_when_killed(temporary_.c_str());
}

std::unique_ptr<OutputFile> OutputFile::standard_output() {
  return std::unique_ptr<OutputFile>(new OutputFile(STDOUT_FILENO, {}, {}));
}

void OutputFile::use_prepared(std::vector<Prepared> files) {
  static auto& kept = *std::make_unique<std::vector<Prepared>>().release();
  kept = std::move(files);
  prepared_files = &kept;
}

std::unique_ptr<OutputFile> OutputFile::open_prepared(const std::string& path, std::string& error) {
  for (const Prepared& prepared : *prepared_files) {
    if (prepared.path != path) continue;
    error = prepared.error;
    if (prepared.descriptor < 0) return nullptr;
    // Of two files of one name the later stays, as it does where each is renamed.
    const int descriptor = ::fcntl(prepared.descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    struct stat info {};
    const bool is_file = descriptor >= 0 && ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode);
    if (descriptor < 0 || (is_file && (::lseek(descriptor, 0, SEEK_SET) != 0 || ::ftruncate(descriptor, 0) != 0))) {
      error = std::strerror(errno);
      return nullptr;
    }
    *prepared.is_complete = false;
    std::unique_ptr<OutputFile> out(new OutputFile(descriptor, {}, {}));
    out->is_complete_ = prepared.is_complete;
    return out;
  }
  error = "this process can write no file that it was not given";
  return nullptr;
}

std::unique_ptr<OutputFile> OutputFile::open(const std::string& path, std::string& error) {
  if (path == "-") return standard_output();
  if (prepared_files != nullptr) return open_prepared(path, error);
  std::error_code ignored;
  if (std::filesystem::is_symlink(path, ignored) && !std::filesystem::exists(path, ignored)) {
    error = "it is a link to a file that does not exist";
    return nullptr;
  }
  // A link stays a link: its target is replaced.
  const std::filesystem::path real = std::filesystem::weakly_canonical(path, ignored);
  const std::string target = real.empty() ? path : real.string();
  struct stat info {};
  const bool exists = stat(target.c_str(), &info) == 0;
  if (exists && (S_ISCHR(info.st_mode) || S_ISFIFO(info.st_mode))) {
    const int descriptor = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor >= 0) return std::unique_ptr<OutputFile>(new OutputFile(descriptor, {}, {}));
    error = std::strerror(errno);
    return nullptr;
  }
  if (exists && !S_ISREG(info.st_mode)) {
    error = S_ISDIR(info.st_mode) ? "it is a folder" : "it is not a regular file";
    return nullptr;
  }
  if (exists && access(target.c_str(), W_OK) != 0) {
    error = std::strerror(errno);
    return nullptr;
  }
  const WholeLines none_is_left;  // a signal waits until the file would be removed
  std::string temporary = target + std::string(mark_of_temporary);
  const int descriptor = mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) {
    error = std::strerror(errno);
    return nullptr;
  }
  const mode_t mode = exists ? info.st_mode & 07777u : 0666u & ~current_umask();
  if (fchmod(descriptor, mode) != 0) error.clear();  // a file system without modes is no reason to stop
  return std::unique_ptr<OutputFile>(new OutputFile(descriptor, target, std::move(temporary)));
}

void OutputFile::fail(int number) {
  if (number == EPIPE)
    reader_is_gone_ = true;
  else
    error_ = std::strerror(number);
}

bool OutputFile::write_through(std::string_view bytes) {
  // The reader of a pipe gets whole lines, whatever ends the run; an incomplete file never appears.
  const std::unique_ptr<WholeLines> whole = temporary_.empty() ? std::make_unique<WholeLines>() : nullptr;
  bool is_in_line = false;
  while (!bytes.empty()) {
    if (whole != nullptr && WholeLines::shall_end()) {
      if (!is_in_line) break;
      bytes = bytes.substr(0, bytes.find('\n') + (bytes.find('\n') != std::string_view::npos ? 1 : 0));
    }
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n >= 0) {
      if (n > 0) is_in_line = bytes[static_cast<std::size_t>(n) - 1] != '\n';
      bytes.remove_prefix(static_cast<std::size_t>(n));
    } else if (errno != EINTR) {
      fail(errno);
      return false;
    }
  }
  return true;
}

bool OutputFile::flush() {
  const std::string_view waiting(buffer_.get(), used_);
  used_ = 0;
  return write_through(waiting);
}

bool OutputFile::write(std::string_view bytes) {
  if (reader_is_gone_ || is_over_allowance_ || !error_.empty()) return false;
  is_over_allowance_ = bytes.size() > allowance_;
  if (is_over_allowance_) return false;
  allowance_ -= bytes.size();
  const bool is_large = bytes.size() >= large_piece;  // comes from a buffer already
  if ((is_large || bytes.size() > buffer_size - used_) && !flush()) return false;
  if (is_large) return write_through(bytes);
  if (!bytes.empty()) std::memcpy(buffer_.get() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
  return true;
}

bool OutputFile::complete() {
  if (reader_is_gone_ || !error_.empty() || !flush()) return false;
  if (descriptor_ > STDERR_FILENO) {
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) return fail(errno), false;
  }
  return true;
}

bool OutputFile::commit() {
  if (!complete()) return false;
  if (is_complete_ != nullptr) *is_complete_ = true;
  if (temporary_.empty()) return true;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) return fail(errno), false;
  keep_when_killed(temporary_.c_str());
  temporary_.clear();
  return true;
}

void OutputFile::remove_left_behind(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  const std::string name = target.filename().string();
  const std::string_view mark = mark_of_temporary.substr(0, mark_of_temporary.find('X'));
  std::vector<fs::path> found;
  for (fs::directory_iterator at(target.parent_path(), error), end; !error && at != end; at.increment(error)) {
    const std::string other = at->path().filename().string();
    const bool is_one = other.size() == name.size() + mark_of_temporary.size() && other.starts_with(name) &&
                        other.compare(name.size(), mark.size(), mark) == 0;
    if (is_one) found.push_back(at->path());
  }
  for (const fs::path& file : found) ::unlink(file.c_str());
}

int print(std::string_view text, int status) {
  const std::unique_ptr<OutputFile> out = OutputFile::standard_output();
  out->write(text);
  if (out->commit() || out->reader_is_gone()) return status;
  std::fprintf(stderr, "isogloss: standard output cannot be written: %s\n", out->error().c_str());
  return cannot_start;
}

}  // namespace isogloss::cli
