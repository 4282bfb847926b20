#include "run/cursor.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace isogloss {

namespace {

constexpr std::size_t window = 64 * 1024;  // more would only touch more pages: reading costs the same

/// Bytes of a descriptor, read again after a signal; negative: the reason is in errno.
template <class F>
ssize_t try_again(F&& call) {
  ssize_t n;
  do n = call();
  while (n < 0 && errno == EINTR);
  return n;
}

template <class F>
std::size_t retry(F&& call) {
  const ssize_t n = try_again(std::forward<F>(call));
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

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

void Cursor::open(Source& source, std::size_t maximum_line_bytes, const Segmenter& segmenter) {
  source_ = &source;
  segmenter_ = &segmenter;
  joins_ = !segmenter.continuation.empty();
  skips_ = false;
  maximum_ = std::max<std::size_t>(maximum_line_bytes, 1);
  if (buffer_.empty()) buffer_.resize(window);
  begin_ = end_ = whole_ = 0;
  offset_ = 0;
  terminator_ = '\n';
  started_ = at_end_ = utf16_ = has_failed_ = false;
  number_ = 0;
}

bool Cursor::fill() {
  if (at_end_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    whole_ = whole_ > begin_ ? whole_ - begin_ : 0;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(buffer_.size() * 2);
  const std::size_t n = source_->read_at(offset_ + end_, buffer_.data() + end_, buffer_.size() - end_);
  end_ += n;
  at_end_ = n == 0;
  if (at_end_) has_failed_ = !source_->failure().empty();
  return n > 0;
}

void Cursor::start() {
  started_ = true;
  while (end_ < 4 && fill()) {
  }
  const auto byte = [&](std::size_t i) { return i < end_ ? static_cast<unsigned char>(buffer_[i]) : 0u; };
  if (byte(0) == 0xef && byte(1) == 0xbb && byte(2) == 0xbf) begin_ = 3;
  offset_ = first_ = begin_;
  utf16_ = (byte(0) == 0xff && byte(1) == 0xfe) || (byte(0) == 0xfe && byte(1) == 0xff);
  // The first line may be longer than the window.
  const auto holds = [&](char c) { return std::memchr(buffer_.data(), c, end_) != nullptr; };
  while (!holds('\n') && !holds('\r') && end_ < maximum_ && fill()) {
  }
  if (!holds('\n') && holds('\r')) terminator_ = '\r';
}

void Cursor::seek(std::uint64_t offset, std::uint32_t number) {
  if (!started_) start();
  skips_ = false;
  number_ = number - 1;
  offset = std::max(offset, first_);
  const std::uint64_t first = offset_ - (begin_ - whole_), last = offset_ + (end_ - begin_);
  if (offset >= first && offset <= last) {
    begin_ = whole_ + static_cast<std::size_t>(offset - first);
  } else {
    begin_ = end_ = whole_ = 0;
    at_end_ = has_failed_ = false;
  }
  offset_ = offset;
}

/// From byte `size` of the block on. False where none came: `size` is then all that there is, or more than the limit.
inline bool Cursor::find_end(std::size_t& size) {
  while (true) {  // `size`: bytes known to hold no end
    const char* const from = buffer_.data() + begin_ + size;
    if (const void* const found = std::memchr(from, terminator_, end_ - begin_ - size)) {
      size = static_cast<std::size_t>(static_cast<const char*>(found) - (buffer_.data() + begin_));
      return true;
    }
    size = end_ - begin_;
    if (size > maximum_ || !fill()) return false;
  }
}

bool Cursor::goes_on(std::string_view line) const {
  const auto ends_in_mark = [&](std::string_view text) {
    const std::size_t last = text.find_last_not_of(" \t\r");
    return last != std::string_view::npos && text.substr(0, last + 1).ends_with(segmenter_->continuation);
  };
  if (ends_in_mark(line)) return true;
  const std::size_t comment = segmenter_->comment.empty() ? std::string_view::npos : line.find(segmenter_->comment);
  return comment != std::string_view::npos && ends_in_mark(line.substr(0, comment));
}

/// More lines for a block whose first line ends at `size`. False when the last one has no end.
bool Cursor::join(Line& line, std::size_t& size) {
  std::size_t begin = 0;
  while (size <= maximum_ && goes_on({buffer_.data() + begin_ + begin, size - begin})) {
    begin = ++size;
    const bool has_end = find_end(size);
    if (!has_end && size == begin) {  // the mark stood in the last line
      --size;
      return true;
    }
    ++line.lines;
    ++number_;
    if (!has_end) return false;
  }
  // For the reader a block that is too long ends here; its remaining lines are not a block either.
  skips_ = size > maximum_ && goes_on({buffer_.data() + begin_ + begin, size - begin});
  return true;
}

/// Line by line, so that a block takes no more memory than the limit.
bool Cursor::skip_rest_of_block() {
  while (skips_) {
    std::size_t size = 0;
    const bool has_end = find_end(size);
    if (size == 0 && !has_end) return false;
    ++number_;
    Line line;
    if (!has_end && size > maximum_) {
      skips_ = false;
      cut_long_line(line, size);
      continue;
    }
    skips_ = goes_on({buffer_.data() + begin_, size});
    const std::size_t used = size + (has_end ? 1 : 0);
    begin_ += used;
    offset_ += used;
    bytes_ += used;
  }
  return true;
}

bool Cursor::next(Line& line) {
  if (!started_) start();
  if (skips_ && !skip_rest_of_block()) return false;
  std::size_t size = 0;
  bool has_end = find_end(size);
  if (size == 0 && !has_end) return false;
  line.number = ++number_;
  line.lines = 1;
  line.offset = offset_;
  if (joins_ && has_end) has_end = join(line, size);
  line.truncated = size > maximum_;
  if (line.truncated && !has_end) return cut_long_line(line, size);
  line.text = std::string_view(buffer_.data() + begin_, std::min(size, maximum_));
  const std::size_t used = size + (has_end ? 1 : 0);
  begin_ += used;
  offset_ += used;
  bytes_ += used;
  if (terminator_ == '\n' && line.text.ends_with('\r')) line.text.remove_suffix(1);
  return true;
}

/// Reads and drops the rest of the line; the kept part is moved out of the way.
bool Cursor::cut_long_line(Line& line, std::size_t size) {
  std::vector<char> kept(buffer_.data() + begin_, buffer_.data() + begin_ + maximum_);
  const char* found = nullptr;
  do {
    begin_ = end_;
    offset_ += size;
    bytes_ += size;
    if (!fill()) break;
    found = static_cast<const char*>(std::memchr(buffer_.data() + begin_, terminator_, end_ - begin_));
    size = end_ - begin_;
  } while (found == nullptr);
  if (found != nullptr) {
    const std::size_t behind = static_cast<std::size_t>(found - buffer_.data()) + 1;
    offset_ += behind - begin_;
    begin_ = behind;
  }
  whole_ = begin_;
  if (begin_ < kept.size()) {  // make room in front of what was read on
    buffer_.insert(buffer_.begin(), kept.size(), '\0');
    begin_ += kept.size();
    end_ += kept.size();
    whole_ += kept.size();
  }
  std::copy(kept.begin(), kept.end(), buffer_.begin());
  line.text = std::string_view(buffer_.data(), kept.size());
  return true;
}

LinePlace LinePlace::of(std::string_view text, std::size_t position) { return LinePlaces().at(text, position); }

LinePlace LinePlaces::at(std::string_view text, std::size_t position) {
  if (position < looked_) forget();
  if (end_ == '\0') end_ = text.find('\n') != std::string_view::npos ? '\n' : '\r';
  for (const std::size_t last = std::min(position, text.size()); looked_ < last; ++looked_)
    if (text[looked_] == end_) place_ = {place_.line + 1, looked_ + 1};
  return place_;
}

// ---- spool

namespace {
constexpr std::size_t kept_in_memory = 1u << 20;
}

Spool::~Spool() {
  if (file_ >= 0) ::close(file_);
}

std::size_t Spool::read(char* buffer, std::size_t size) {
  const std::size_t n = read_at(given_, buffer, size);
  given_ += n;
  return n;
}

std::size_t Spool::pull(char* buffer, std::size_t size) {
  if (ended_) return 0;
  const std::size_t n = from_.read(buffer, size);
  ended_ = n == 0;
  keep(buffer, n);
  size_ += n;
  return n;
}

void Spool::keep(const char* bytes, std::size_t size) {
  const std::size_t in_memory = std::min(size, kept_in_memory - head_.size());
  head_.append(bytes, in_memory);
  bytes += in_memory;
  size -= in_memory;
  if (size == 0 || lost_) return;
  if (file_ < 0) {
    const char* const folder = std::getenv("TMPDIR");
    std::string name = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/isogloss-XXXXXX";
    file_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (file_ >= 0) ::unlink(name.c_str());
  }
  while (size > 0 && file_ >= 0) {
    const std::size_t n = retry([&] { return ::write(file_, bytes, size); });
    if (n == 0) break;
    bytes += n;
    size -= n;
  }
  lost_ = size > 0;
}

std::size_t Spool::read_at(std::uint64_t offset, char* buffer, std::size_t size) {
  if (size == 0) return 0;
  while (offset > size_) {
    char passed[4096];
    if (pull(passed, static_cast<std::size_t>(std::min<std::uint64_t>(sizeof passed, offset - size_))) == 0) return 0;
  }
  if (offset == size_) return pull(buffer, size);
  const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(size, size_ - offset));
  if (offset < head_.size()) {
    const std::size_t n = std::min(wanted, head_.size() - static_cast<std::size_t>(offset));
    std::memcpy(buffer, head_.data() + offset, n);
    return n;
  }
  if (lost_) return 0;
  return retry([&] { return ::pread(file_, buffer, wanted, static_cast<off_t>(offset - kept_in_memory)); });
}

}  // namespace isogloss
