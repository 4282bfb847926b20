#include "kept_program.hpp"

#include <unistd.h>

#include <filesystem>

#include "dialect_guess.hpp"

namespace isogloss::cli {

namespace {

class KeptSource : public Source {
 public:
  explicit KeptSource(int file, std::uint64_t begin = 0) : file_(file), begin_(begin) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = read_at(offset_, buffer, size);
    offset_ += n;
    return n;
  }
  bool has_places() const override { return true; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    const ssize_t n = ::pread(file_, buffer, size, static_cast<off_t>(begin_ + offset));
    return n > 0 ? static_cast<std::size_t>(n) : 0;
  }

 private:
  int file_;
  std::uint64_t begin_, offset_ = 0;
};

std::unique_ptr<Source> open_program(const std::string& path, Session& session) {
  std::error_code code;
  std::string error = "it is a folder";
  std::unique_ptr<Source> source;
  if (!std::filesystem::is_directory(path, code)) source = open_file(path, error);
  if (source == nullptr) session.report("IG-0510", {path}, {error});
  return source;
}

}  // namespace

std::unique_ptr<KeptProgram> KeptProgram::open(const std::string& path, Session& session) {
  std::unique_ptr<KeptProgram> out(new KeptProgram(path));
  std::error_code code;
  const std::unique_ptr<Source> source = open_program(path, session);
  if (source == nullptr) return nullptr;
  if (path != "-" && std::filesystem::is_regular_file(path, code)) return out;
  if (path == "-" && source->has_places()) {
    out->input_ = STDIN_FILENO;
    out->begin_ = static_cast<std::uint64_t>(::lseek(STDIN_FILENO, 0, SEEK_CUR));
    return out;
  }
  out->kept_ = std::tmpfile();
  std::string error = out->kept_ == nullptr ? "there is no room for a temporary file" : "";
  char buffer[1 << 16];
  while (error.empty()) {
    const std::size_t n = source->read(buffer, sizeof buffer);
    if (n == 0) break;
    if (std::fwrite(buffer, 1, n, out->kept_) != n) error = "there is no room for a temporary file";
  }
  if (error.empty() && std::fflush(out->kept_) != 0) error = "there is no room for a temporary file";
  if (error.empty()) error = source->failure();
  if (error.empty()) return out;
  session.report("IG-0510", {path}, {error});
  return nullptr;
}

KeptProgram::~KeptProgram() {
  if (kept_ != nullptr) std::fclose(kept_);
}

std::unique_ptr<Source> KeptProgram::source(Session& session) const {
  if (kept_ != nullptr) return std::make_unique<KeptSource>(fileno(kept_));
  if (input_ >= 0) return std::make_unique<KeptSource>(input_, begin_);
  return open_program(path_, session);
}

std::string KeptProgram::head(Session& session) const {
  const std::unique_ptr<Source> from = source(session);
  std::string out(guessed_head_bytes, '\0');
  std::size_t size = 0;
  while (from != nullptr && size < out.size()) {
    const std::size_t n = from->read(out.data() + size, out.size() - size);
    if (n == 0) break;
    size += n;
  }
  out.resize(size);
  return out;
}

}  // namespace isogloss::cli
