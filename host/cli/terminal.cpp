#include "terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "crash_guard.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t fewest_columns = 60, most_columns = 200;

std::array<bool, 2> terminals{};
bool remembered = false;

bool is_dumb() {
  const char* const terminal = std::getenv("TERM");
  return terminal == nullptr || std::string_view(terminal) == "dumb";
}

/// Where the text of a line begins that follows upon its first: below its description, or as far in as the line.
std::size_t hanging(std::string_view line, std::size_t columns) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  if (begin == 0) return 0;
  const std::size_t gap = line.find("  ", begin);
  if (gap == std::string_view::npos || gap > columns) return begin;
  return std::min(line.find_first_not_of(' ', gap), line.size());
}

}  // namespace

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::size_t columns_of(int descriptor) {
  std::size_t columns = 0;
  if (const char* const told = std::getenv("COLUMNS")) {
    const auto [end, error] = std::from_chars(told, told + std::strlen(told), columns);
    if (error != std::errc() || *end != '\0') columns = 0;
  }
  winsize size{};
  if (columns == 0 && isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return columns == 0 ? 0 : std::clamp(columns, fewest_columns, most_columns);
}

bool is_terminal(int descriptor) {
  return remembered ? terminals[descriptor == STDERR_FILENO ? 1 : 0] : isatty(descriptor) != 0;
}

void remember_terminals() {
  terminals = {isatty(STDOUT_FILENO) != 0, isatty(STDERR_FILENO) != 0};
  remembered = true;
}

bool shows_colours(int descriptor) {
  const char* const none = std::getenv("NO_COLOR");
  return isatty(descriptor) != 0 && (none == nullptr || *none == '\0') && !is_dumb();
}

std::string in_columns(std::string_view words, std::size_t columns, std::size_t indentation) {
  std::string out;
  std::size_t used = 0;
  for (std::size_t begin = 0; (begin = words.find_first_not_of(' ', begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string_view word = words.substr(begin, end - begin);
    const std::size_t size = characters(word);
    if (used != 0 && used + 1 + size > columns) {
      out += '\n' + std::string(indentation, ' ');
      used = 0;
    }
    if (used != 0) out += ' ';
    used += size + (used != 0 ? 1 : 0);
    out += word;
    begin = end;
  }
  return out;
}

std::string fitted(std::string_view text, std::size_t columns) {
  if (columns == 0) return std::string(text);
  std::string out;
  bool is_example = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    is_example = is_example || line.starts_with("Example");
    std::size_t indentation = hanging(line, columns);
    if (is_example || characters(line) <= columns) {
      out += line;
    } else {
      // A description that would be too narrow beside its option stands below it.
      constexpr std::size_t narrowest = 24, below = 6;
      const std::string_view head = line.substr(0, indentation);
      if (indentation + narrowest > columns) {
        const std::size_t last = head.find_last_not_of(' ');
        indentation = below;
        if (last != std::string_view::npos) (out += head.substr(0, last + 1)) += '\n';
        out += std::string(below, ' ');
      } else {
        out += head;
      }
      out += in_columns(line.substr(head.size()), columns - indentation, indentation);
    }
    if (end < text.size()) out += '\n';
  }
  return out;
}

Progress::Progress() : is_enabled_(isatty(STDERR_FILENO) != 0 && !is_dumb()) {}

void Progress::data_goes_to_stdout() { is_enabled_ = is_enabled_ && isatty(STDOUT_FILENO) == 0; }

void Progress::show(std::uint64_t done, std::uint64_t total, std::string_view what) {
  constexpr auto patience = std::chrono::seconds(1);
  constexpr auto interval = std::chrono::milliseconds(100);
  if (!is_enabled_) return;
  const Clock::time_point now = Clock::now();
  if (now - begin_ < patience || now - last_ < interval) return;
  last_ = now;
  constexpr std::size_t bar_size = 24, usual_columns = 80;
  std::string line;
  if (total != 0) {
    const double part = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
    const auto full = static_cast<std::size_t>(part * bar_size);
    line = fmt::format("[{}{}] {:3.0f} %  ", std::string(full, '#'), std::string(bar_size - full, '.'), part * 100);
  }
  const std::size_t columns = columns_of(STDERR_FILENO);
  const std::size_t room = (columns == 0 ? usual_columns : columns) - 1;
  for (const char c : what) line += static_cast<unsigned char>(c) < ' ' ? '?' : c;
  if (characters(line) > room) {
    std::size_t size = 0;  // of the first `room` characters
    for (std::size_t seen = 0; size < line.size(); ++size)
      if ((static_cast<unsigned char>(line[size]) & 0xc0) != 0x80 && ++seen > room) break;
    line.resize(size);
  }
  const Writing writing;
  std::fputs(("\r\033[K" + line).c_str(), stderr);
  std::fflush(stderr);
  is_shown_ = true;
}

void Progress::hide() {
  if (!is_shown_) return;
  const Writing writing;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  is_shown_ = false;
}

}  // namespace isogloss::cli
