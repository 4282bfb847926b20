#include "lsp/open_program.hpp"

#include <algorithm>
#include <charconv>

namespace isogloss::editors {

namespace {

constexpr std::string_view file_scheme = "file://";

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("/-_.~").find(c) != std::string_view::npos;
}

}  // namespace

Json to_json(const Position& p) { return {{"line", p.line}, {"character", p.character}}; }
Json to_json(const Range& r) { return {{"start", to_json(r.start)}, {"end", to_json(r.end)}}; }

std::string uri_of(const std::string& path) {
  if (path.find(':') != std::string::npos && !path.starts_with('/')) return path;
  constexpr char digits[] = "0123456789ABCDEF";
  std::string out(file_scheme);
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_plain(c))
      out += c;
    else
      out.append({'%', digits[byte >> 4], digits[byte & 15]});
  }
  return out;
}

std::string path_of(const std::string& uri) {
  if (!uri.starts_with(file_scheme)) return {};
  const std::size_t begin = uri.find('/', file_scheme.size());
  if (begin == std::string::npos) return {};
  std::string out;
  for (std::size_t i = begin; i < uri.size(); ++i) {
    unsigned byte = 0;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, uri.data() + i + 3, byte, 16).ptr == uri.data() + i + 3) {
      out += static_cast<char>(byte);
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

Range line_range(const TextDocument& text, std::uint32_t line) {
  const std::string_view content = text.run_line(line);
  const std::size_t begin = text.run_line_begin(line);
  const std::size_t first = std::min(content.find_first_not_of(" \t"), content.size());
  const std::size_t last = content.find_last_not_of(" \t");
  return text.range_of(begin + first, begin + (last == std::string_view::npos ? first : last + 1));
}

Json location_of(const OpenProgram& program, const Surroundings& around, const std::string& file, std::uint32_t line) {
  if (file == program.path) return {{"uri", program.uri}, {"range", to_json(line_range(program.text, line))}};
  Range range{{line > 0 ? line - 1 : 0, 0}, {line > 0 ? line - 1 : 0, 0}};
  if (const auto text = around.text_of(file)) range = line_range(*text, line);
  return {{"uri", uri_of(file)}, {"range", to_json(range)}};
}

}  // namespace isogloss::editors
