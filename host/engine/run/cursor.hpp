/// Cuts a source into lines, reading it in windows, so that memory does not grow with the program.
#pragma once

#include <string_view>
#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/runner.hpp"

namespace isogloss {

struct Line {
  std::string_view text;  ///< without its end; alive until the next call. It includes the ends of continued lines
  std::uint64_t offset = 0;
  std::uint32_t number = 0;
  std::uint32_t lines = 1;  ///< that the segmenter joined
  bool truncated = false;   ///< longer than the limit; the rest is skipped
};

/// Where byte `position` of joined lines stands.
struct LinePlace {
  std::uint32_t line = 0;  ///< lines before it
  std::size_t begin = 0;   ///< of its own line
  static LinePlace of(std::string_view text, std::size_t position);
};

/// The same for one text, of which each part is looked at once as long as the questions come in order.
class LinePlaces {
 public:
  LinePlace at(std::string_view text, std::size_t position);
  /// Another text follows.
  void forget() { *this = {}; }

 private:
  char end_ = '\0';  // of lines; NUL: no text was seen
  std::size_t looked_ = 0;
  LinePlace place_;
};

/// Lines end in LF or CR LF; a file without any LF has lines that end in CR. A leading byte order mark is skipped.
/// Going back costs nothing as long as the place lies in the window.
class Cursor {
 public:
  Cursor() = default;
  /// The source has places. The segmenter outlives the cursor.
  Cursor(Source& source, std::size_t maximum_line_bytes, const Segmenter& segmenter) {
    open(source, maximum_line_bytes, segmenter);
  }
  /// From the beginning of another source; the buffer stays.
  void open(Source& source, std::size_t maximum_line_bytes, const Segmenter& segmenter);
  bool next(Line& line);
  /// The same for a line of which it is known that its text has so many bytes and is joined to no other. False where
  /// more has to be read, or where that cannot be: nothing has changed then.
  bool next(Line& line, std::uint32_t size) {
    if (skips_ || end_ - begin_ < size + std::size_t{2}) return false;
    const char* const text = buffer_.data() + begin_;
    const std::size_t last = size + (terminator_ == '\n' && text[size] == '\r' ? 1u : 0u);
    if (text[last] != terminator_) return false;
    line = {{text, size}, offset_, ++number_, 1, false};
    begin_ += last + 1;
    offset_ += last + 1;
    bytes_ += last + 1;
    return true;
  }
  /// The next line is the one that begins at this offset.
  void seek(std::uint64_t offset, std::uint32_t number);
  bool is_utf16() const { return utf16_; }
  /// The source could not be read to its end: the line that next() gave last may lack its rest.
  bool has_failed() const { return has_failed_; }
  std::uint64_t bytes() const { return bytes_; }
  const Source* source() const { return source_; }
  std::uint64_t offset() const { return offset_; }           ///< of the next line
  std::uint32_t next_number() const { return number_ + 1; }  ///< of the next line

 private:
  bool fill();  // false: nothing more came
  void start();
  bool find_end(std::size_t& size);
  bool is_unmarked(std::size_t size);
  bool goes_on(std::string_view line) const;
  bool join(Line& line, std::size_t& size);
  bool skip_rest_of_block();
  bool cut_long_line(Line& line, std::size_t size);

  Source* source_ = nullptr;
  const Segmenter* segmenter_ = nullptr;
  bool joins_ = false, skips_ = false;
  std::size_t maximum_ = 1;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::size_t whole_ = 0;       // from here to end_ the buffer holds the source's bytes as they are
  std::uint64_t offset_ = 0;    // of the byte at begin_
  std::uint64_t first_ = 0;     // of the first line
  std::uint64_t unmarked_ = 0;  // no mark of a continuation stands between offset_ and here
  char terminator_ = '\n';
  bool started_ = false, at_end_ = false, utf16_ = false, has_failed_ = false;
  std::uint32_t number_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace isogloss
