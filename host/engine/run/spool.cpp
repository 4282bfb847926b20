#include "run/spool.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "run/try_again.hpp"

namespace isogloss {

namespace {

constexpr std::size_t kept_in_memory = 1u << 20;

/// The bytes that a call read or wrote; none after a fault.
template <class F>
std::size_t bytes_of(F&& call) {
  const ssize_t n = try_again(call);
  return n > 0 ? static_cast<std::size_t>(n) : 0;
}

}  // namespace

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
    const char* const named = std::getenv("TMPDIR");
    const std::string folder = named != nullptr && *named != '\0' ? named : "/tmp";
    file_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
    if (file_ < 0) {  // not on every file system
      std::string name = folder + "/isogloss-XXXXXX";
      file_ = ::mkostemp(name.data(), O_CLOEXEC);
      if (file_ >= 0) ::unlink(name.c_str());
    }
  }
  while (size > 0 && file_ >= 0) {
    const std::size_t n = bytes_of([&] { return ::write(file_, bytes, size); });
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
  return bytes_of([&] { return ::pread(file_, buffer, wanted, static_cast<off_t>(offset - kept_in_memory)); });
}

}  // namespace isogloss
