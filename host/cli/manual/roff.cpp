#include "manual/roff.hpp"

#include <algorithm>

namespace isogloss::cli {

std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '\\': out += "\\e"; break;
      case '-': out += "\\-"; break;  // a plain one is a hyphen, which nobody can copy into a command line
      case '\'': out += "\\(aq"; break;
      case '`': out += "\\(ga"; break;
      case '^': out += "\\(ha"; break;
      case '~': out += "\\(ti"; break;
      default: out += c;
    }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string roff_paragraphs(std::string_view text) {
  constexpr std::size_t width = 78;
  std::string out, line;
  const auto flush = [&] {
    if (!line.empty()) out += line + "\n";
    line.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = text.find_first_of(" \n", at);
    if (end == std::string_view::npos) end = text.size();
    const std::string word = roff(text.substr(at, end - at));
    if (line.size() + word.size() >= width) flush();
    if (!word.empty()) line += (line.empty() ? "" : " ") + word;
    if (text.substr(end).starts_with("\n\n") && (!out.empty() || !line.empty())) {
      flush();
      out += ".PP\n";
    }
    at = end + 1;
  }
  flush();
  return out;
}

std::string roff_example(std::string_view text) {
  std::string out = ".nf\n";
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    out += roff(line) + "\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return out + ".fi\n";
}

}  // namespace isogloss::cli
