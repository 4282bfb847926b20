/// What a terminal can take: how wide it is, whether it shows colours, a line of progress.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace isogloss::cli {

/// Columns for what goes to this descriptor: COLUMNS, or else the terminal's own, from 60 to 200. 0: no limit, since
/// nobody reads it on a terminal.
std::size_t columns_of(int descriptor);

/// Whether standard output or standard error is one, also where another process hands on what this one prints.
bool is_terminal(int descriptor);
/// From now on is_terminal() tells what is so now.
void remember_terminals();

/// On a terminal, unless NO_COLOR is set or the terminal is dumb.
bool shows_colours(int descriptor);

/// Breaks lines between words where they are longer than `columns`; what follows stands below the description of an
/// option (text after two blanks), or is indented as its line. Lines after "Example" are commands and stay. 0: as it
/// is.
std::string fitted(std::string_view text, std::size_t columns);

/// Words in lines of this many columns, the later ones indented. Longer words stay whole.
std::string in_columns(std::string_view words, std::size_t columns, std::size_t indentation);

/// How many characters of UTF-8 the text has.
std::size_t characters(std::string_view text);

/// One line on standard error, when that is a terminal and the work takes longer than a second. It never shows in a
/// pipe, nor where data scrolls over the same terminal.
class Progress {
 public:
  Progress();
  ~Progress() { hide(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` (0: nobody knows) and what is at work. Cheap enough for each step.
  void show(std::uint64_t done, std::uint64_t total, std::string_view what);
  /// Takes the line away, before anything else is written.
  void hide();
  /// Data goes to standard output: where that is the terminal, too, no line is shown.
  void data_goes_to_stdout();

 private:
  using Clock = std::chrono::steady_clock;
  bool is_enabled_, is_shown_ = false;
  Clock::time_point begin_ = Clock::now(), last_ = {};
};

}  // namespace isogloss::cli
