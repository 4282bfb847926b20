#include "cursor.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace isogloss {

namespace {

constexpr std::size_t window = 64 * 1024;  // more would only touch more pages: reading costs the same

class FileSource : public Source {
 public:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {}
  ~FileSource() override {
    if (descriptor_ > 2) ::close(descriptor_);
  }
  std::size_t read(char* buffer, std::size_t size) override {
    ssize_t n;
    do n = ::read(descriptor_, buffer, size);
    while (n < 0 && errno == EINTR);
    return n > 0 ? static_cast<std::size_t>(n) : 0;
  }

 private:
  int descriptor_;
};

class MemorySource : public Source {
 public:
  explicit MemorySource(std::string_view text) : text_(text) {}
  std::size_t read(char* buffer, std::size_t size) override {
    const std::size_t n = std::min(size, text_.size());
    std::memcpy(buffer, text_.data(), n);
    text_.remove_prefix(n);
    return n;
  }

 private:
  std::string_view text_;
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

Cursor::Cursor(Source& source, std::size_t maximum_line_bytes)
    : source_(source), maximum_(std::max<std::size_t>(maximum_line_bytes, 1)), buffer_(window) {}

bool Cursor::fill() {
  if (at_end_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(buffer_.size() * 2);
  const std::size_t n = source_.read(buffer_.data() + end_, buffer_.size() - end_);
  end_ += n;
  at_end_ = n == 0;
  return n > 0;
}

void Cursor::start() {
  started_ = true;
  while (end_ < 4 && fill()) {
  }
  const auto byte = [&](std::size_t i) { return i < end_ ? static_cast<unsigned char>(buffer_[i]) : 0u; };
  if (byte(0) == 0xef && byte(1) == 0xbb && byte(2) == 0xbf) begin_ = 3;
  utf16_ = (byte(0) == 0xff && byte(1) == 0xfe) || (byte(0) == 0xfe && byte(1) == 0xff);
  if (std::memchr(buffer_.data(), '\n', end_) == nullptr && std::memchr(buffer_.data(), '\r', end_) != nullptr)
    terminator_ = '\r';
}

bool Cursor::next(Line& line) {
  if (!started_) start();
  std::size_t searched = 0;  // bytes of this line known to hold no end
  const char* found = nullptr;
  while (true) {
    const char* const from = buffer_.data() + begin_ + searched;
    found = static_cast<const char*>(std::memchr(from, terminator_, end_ - begin_ - searched));
    if (found != nullptr) break;
    searched = end_ - begin_;
    if (searched > maximum_ || !fill()) break;
  }
  std::size_t size = found != nullptr ? static_cast<std::size_t>(found - (buffer_.data() + begin_)) : end_ - begin_;
  if (size == 0 && found == nullptr) return false;
  line.truncated = size > maximum_;
  line.number = ++number_;
  if (line.truncated && found == nullptr) {
    // The rest of the line is read away; what is kept is moved out of the way of the reads.
    std::vector<char> kept(buffer_.data() + begin_, buffer_.data() + begin_ + maximum_);
    do {
      begin_ = end_;
      bytes_ += size;
      if (!fill()) break;
      found = static_cast<const char*>(std::memchr(buffer_.data() + begin_, terminator_, end_ - begin_));
      size = end_ - begin_;
    } while (found == nullptr);
    if (found != nullptr) begin_ = static_cast<std::size_t>(found - buffer_.data()) + 1;
    if (begin_ < kept.size()) {  // make room in front of what was read on
      buffer_.insert(buffer_.begin(), kept.size(), '\0');
      begin_ += kept.size();
      end_ += kept.size();
    }
    std::copy(kept.begin(), kept.end(), buffer_.begin());
    line.text = std::string_view(buffer_.data(), kept.size());
    return true;
  }
  line.text = std::string_view(buffer_.data() + begin_, std::min(size, maximum_));
  const std::size_t used = size + (found != nullptr ? 1 : 0);
  begin_ += used;
  bytes_ += used;
  if (terminator_ == '\n' && line.text.ends_with('\r')) line.text.remove_suffix(1);
  return true;
}

}  // namespace isogloss
