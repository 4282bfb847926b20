/// A text that a process and those that it forks see.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

namespace isogloss::cli {

class SharedText {
 public:
  SharedText() {
    void* const shared = mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory for a check");
    text_ = static_cast<char*>(shared);
  }
  ~SharedText() { munmap(text_, room); }
  SharedText(const SharedText&) = delete;
  SharedText& operator=(const SharedText&) = delete;

  /// What does not fit is cut off.
  void write(std::string_view text) {
    const std::size_t size = std::min(text.size(), room - 1);
    std::memcpy(text_, text.data(), size);
    text_[size] = '\0';
  }
  std::string read() const { return {text_, strnlen(text_, room)}; }

 private:
  static constexpr std::size_t room = 16 << 10;
  char* text_;
};

}  // namespace isogloss::cli
