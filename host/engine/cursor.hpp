/// Cuts a source into lines, reading it in windows, so that memory does not grow with the program.
#pragma once

#include <string_view>
#include <vector>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

struct Line {
  std::string_view text;  ///< without its end; alive until the next call
  std::uint32_t number = 0;
  bool truncated = false;  ///< longer than the limit; the rest is skipped
};

/// Lines end in LF or CR LF; a file without any LF has lines that end in CR. A leading byte order mark is skipped.
class Cursor {
 public:
  Cursor(Source& source, std::size_t maximum_line_bytes);
  bool next(Line& line);
  bool is_utf16() const { return utf16_; }
  std::uint64_t bytes() const { return bytes_; }

 private:
  bool fill();  // false: nothing more came
  void start();

  Source& source_;
  std::size_t maximum_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  char terminator_ = '\n';
  bool started_ = false, at_end_ = false, utf16_ = false;
  std::uint32_t number_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace isogloss
