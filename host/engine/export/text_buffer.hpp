/// One buffer between an exporter and its Output.
#pragma once

#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "export/number_writer.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

/// Bytes of the well-formed UTF-8 sequence at the head of `text`, which is not empty; 0 when there is none.
std::size_t utf8_length(std::string_view text);
/// The text with U+FFFD in place of each invalid UTF-8 sequence. A program may hold any byte.
std::string valid_utf8(std::string_view text);
/// A JSON string with its quotes; valid UTF-8, whatever the text holds.
std::string json_string(std::string_view text);

/// Collects bytes and hands them on in large pieces. Hot code reserves room once and writes through a plain pointer:
///   char* p = buffer.reserve(200); p = put(p, "…"); buffer.commit(p);
class TextBuffer {
 public:
  explicit TextBuffer(Output& output) : output_(&output) { grow(initial_size); }

  /// At least `room` bytes; valid until the next call.
  char* reserve(std::size_t room) {
    if (room > static_cast<std::size_t>(limit_ - at_)) make_room(room);
    return at_;
  }
  void commit(char* end) { at_ = end; }

  void append(std::string_view text) {
    char* p = reserve(text.size());
    if (!text.empty()) std::memcpy(p, text.data(), text.size());
    commit(p + text.size());
  }

  /// False once the output accepts no more; later text is dropped.
  bool ok() const { return ok_; }
  bool flush() {
    const std::string_view waiting(data_.get(), static_cast<std::size_t>(at_ - data_.get()));
    if (ok_ && !waiting.empty()) ok_ = output_->write(waiting);
    at_ = data_.get();
    return ok_;
  }

 private:
  static constexpr std::size_t initial_size = std::size_t{64} << 10;

  void make_room(std::size_t room) {
    flush();
    if (room > static_cast<std::size_t>(limit_ - at_)) grow(room);
  }
  void grow(std::size_t size) {
    data_ = std::make_unique_for_overwrite<char[]>(size);
    at_ = data_.get();
    limit_ = at_ + size;
  }

  Output* output_;
  std::unique_ptr<char[]> data_;
  char* at_ = nullptr;
  char* limit_ = nullptr;
  bool ok_ = true;
};

/// A literal, its length known to the compiler.
template <std::size_t N>
char* put(char* out, const char (&literal)[N]) {
  std::memcpy(out, literal, N - 1);
  return out + N - 1;
}
inline char* put(char* out, std::string_view text) {
  if (!text.empty()) std::memcpy(out, text.data(), text.size());
  return out + text.size();
}

}  // namespace isogloss
