// Where a program comes from: a file, standard input or memory.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "isogloss/engine/runner.hpp"
#include "run/try_again.hpp"

namespace isogloss {

namespace {

class FileSource : public Source {
 public:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {
    struct stat status {};
    // Standard input may be a file of which a part has been read already.
    const off_t place = ::lseek(descriptor, 0, SEEK_CUR);
    has_places_ = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && place >= 0;
    if (has_places_) base_ = static_cast<std::uint64_t>(place);
    if (has_places_) size_ = status.st_size;
  }
  ~FileSource() override {
    if (descriptor_ > 2) ::close(descriptor_);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::size_t read(char* buffer, std::size_t size) override {
    const ssize_t n = try_again([&] { return ::read(descriptor_, buffer, size); });
    return count(n, ::lseek(descriptor_, 0, SEEK_CUR));
  }
  bool has_places() const override { return has_places_; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    const off_t place = static_cast<off_t>(base_ + offset);
    return count(try_again([&] { return ::pread(descriptor_, buffer, size, place); }), place);
  }
  std::string failure() const override { return failure_; }
  std::unique_ptr<Source> again() const override {
    const int copy = has_places_ ? ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 3) : -1;
    if (copy < 0) return nullptr;
    auto out = std::make_unique<FileSource>(copy);
    out->base_ = base_;
    out->size_ = size_;
    return out;
  }

 private:
  std::size_t count(ssize_t n, off_t place) {
    failure_.clear();
    if (n > 0) return static_cast<std::size_t>(n);
    struct stat status {};
    if (n < 0)
      failure_ = std::strerror(errno);
    else if (has_places_ && place < size_ && ::fstat(descriptor_, &status) == 0 && status.st_size < size_)
      failure_ = "it became shorter during the run";
    return 0;
  }

  std::string failure_;
  off_t size_ = 0;  // when it was opened
  int descriptor_;
  bool has_places_ = false;
  std::uint64_t base_ = 0;
};

class MemorySource : public Source {
 public:
  explicit MemorySource(std::string_view text) : text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = read_at(given_, buffer, size);
    given_ += n;
    return n;
  }
  bool has_places() const override { return true; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    const std::string_view rest = text_.substr(std::min<std::uint64_t>(offset, text_.size()));
    const std::size_t n = std::min(size, rest.size());
    std::memcpy(buffer, rest.data(), n);
    return n;
  }
  std::unique_ptr<Source> again() const override { return memory_source(text_); }

 private:
  std::string_view text_;
  std::size_t given_ = 0;
};

}  // namespace

std::unique_ptr<Source> open_file(const std::string& path, std::string& error) {
  if (path == "-") return std::make_unique<FileSource>(0);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    error = std::strerror(errno);
    return nullptr;
  }
  if (S_ISDIR(status.st_mode)) {
    ::close(descriptor);
    error = "is a folder";
    return nullptr;
  }
  return std::make_unique<FileSource>(descriptor);
}

std::unique_ptr<Source> memory_source(std::string_view text) { return std::make_unique<MemorySource>(text); }

}  // namespace isogloss
