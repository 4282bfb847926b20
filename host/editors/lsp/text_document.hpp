/// The text of an open file, as the editor changes it, and the two ways to name a place in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::editors {

/// In which units the client counts the columns of a line.
enum class Columns : std::uint8_t { utf8, utf16 };

/// As the protocol has it: both count from 0.
struct Position {
  std::uint32_t line = 0, character = 0;
  bool operator==(const Position&) const = default;
};
struct Range {
  Position start, end;
};

class TextDocument {
 public:
  TextDocument() : TextDocument(std::string(), Columns::utf16) {}
  TextDocument(std::string text, Columns columns) : columns_(columns) { replace_all(std::move(text)); }

  const std::string& text() const { return text_; }
  void replace_all(std::string text);
  /// A range that ends before it begins is turned around; what lies beyond the text is its end.
  void replace(const Range& range, std::string_view with);

  /// Beyond the end of a line: its end. Beyond the last line: the end of the text.
  std::size_t offset_of(const Position& position) const;
  Position position_of(std::size_t offset) const;
  Range range_of(std::size_t begin, std::size_t end) const { return {position_of(begin), position_of(end)}; }
  std::size_t lines() const { return lines_.size(); }
  /// Without its end.
  std::string_view line(std::size_t index) const;

  // A run counts lines from 1 and columns in bytes from 1, and ends no line at a CR beside lines that end in LF.
  std::size_t offset_in_run(std::uint32_t line, std::uint32_t column) const;
  std::uint32_t run_line_of(std::size_t offset) const;
  std::size_t run_line_begin(std::uint32_t line) const { return offset_in_run(line, 1); }
  std::string_view run_line(std::uint32_t line) const;
  std::size_t run_lines() const { return run_lines_.size(); }
  /// The line of the protocol in which a line of a run begins.
  Position position_in_run(std::uint32_t line, std::uint32_t column) const {
    return position_of(offset_in_run(line, column));
  }

 private:
  void find_lines();
  std::size_t end_of(std::size_t line) const;

  std::string text_;
  Columns columns_;
  std::vector<std::size_t> lines_, run_lines_;  // offsets at which lines begin
  /// The place that was counted last: whoever asks for one place after the other of a long line counts it once.
  struct Counted {
    std::size_t begin = std::string::npos, at = 0;  // the line's begin
    std::uint32_t units = 0;
  };
  mutable Counted counted_;
};

}  // namespace isogloss::editors
