/// Lines of the control's data files: assignments, values, heads of files, and words of definitions. Every view lies in
/// the text of the file, so that its place is known.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "language/siemens_environment.hpp"

namespace siemens {

inline constexpr const char* no_place = "no table has a place for it";

inline std::size_t place_in(const ig::Import& file, std::string_view part) {
  return static_cast<std::size_t>(part.data() - file.text().data());
}

/// A line without block number, comment and checksum, nor control characters at its ends.
std::string_view code_of(std::string_view line);

inline std::string shown(std::string_view text) { return ig::shown_part(text); }

/// 12.5, 1.2EX-3, 'H2F', 'B101', TRUE. Nothing for anything else, and for a number that no double holds.
std::optional<double> number_of(std::string_view value);
/// "…", without its quotation marks.
std::optional<std::string_view> quoted_text(std::string_view value);

/// Reads a line from left to right.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}
  /// The next character that is no blank; NUL at the end.
  char peek();
  bool accept(char c);
  /// A name, or a view of no characters.
  std::string_view word();
  /// Up to the first of these characters that stands outside of brackets and texts.
  std::string_view until(std::string_view ends);
  std::string_view rest() const { return text_.substr(at_); }
  bool is_at_end() { return peek() == '\0' && at_ >= text_.size(); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Parts between commas, without blanks around them. Commas in brackets and texts do not count.
std::vector<std::string_view> split(std::string_view list);

/// NAME[indices]=value.
struct Assignment {
  std::string name;                 ///< in capitals, with its $
  std::vector<std::string> index;   ///< numbers without leading zeros, names in capitals
  std::string_view value, written;  ///< `written` is the whole assignment

  std::string full_name() const;
  /// The index with this position as a number, -1 where it is none.
  std::int64_t number(std::size_t position) const;
};

/// The assignment that begins at the cursor, which then stands behind it. Nothing where none does.
std::optional<Assignment> read_assignment(Cursor& cursor);

/// "%_N_NAME_EXT", or "%MPF1" of older controls.
struct FileHead {
  std::string name, extension;
  bool holds_programs() const;
  bool holds_data() const;
};
std::optional<FileHead> read_head(std::string_view line);

/// M17 and other ends of a file.
bool is_file_end(std::string_view code);

/// Conditions, loops, jumps and calls. What stands between IF and ENDIF, or in a loop, is left out.
class FlowFilter {
 public:
  /// True where the line is no data; it has been reported.
  bool leaves_out(ig::Import& file, std::string_view code);
  void restart() { depth_ = 0; }

 private:
  static void leave_out(ig::Import& file, std::string_view code);
  std::size_t depth_ = 0;
};

}  // namespace siemens
