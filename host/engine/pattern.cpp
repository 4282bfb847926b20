#include "pattern.hpp"

#include <algorithm>

namespace isogloss {

namespace {

bool digits(std::string_view s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool match(const std::vector<std::string>& pattern, std::size_t p, const std::vector<std::string>& path,
           std::size_t s) {
  if (p == pattern.size()) return s == path.size();
  if (pattern[p] == "**") {
    for (std::size_t next = s + 1; next <= path.size(); ++next)
      if (match(pattern, p + 1, path, next)) return true;
    return false;
  }
  if (s == path.size()) return false;
  const bool fits = pattern[p] == "*" || (pattern[p] == "?" ? path[s].size() == 1 : pattern[p] == path[s]);
  return fits && match(pattern, p + 1, path, s + 1);
}

}  // namespace

std::vector<std::string> path_segments(std::string_view path) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t dot = path.find('.');
    const std::string_view segment = path.substr(0, dot);
    // The decimal of a code belongs to it: one letter and digits before the point, digits after it.
    if (!out.empty() && digits(segment) && out.back().size() > 1 && digits(std::string_view(out.back()).substr(1)))
      out.back().append(".").append(segment);
    else
      out.emplace_back(segment);
    if (dot == std::string_view::npos) return out;
    path.remove_prefix(dot + 1);
  }
}

FieldPattern::FieldPattern(std::string_view text) {
  if (text.ends_with('}'))
    if (const std::size_t open = text.find('{'); open != std::string_view::npos) {
      unit_ = text.substr(open + 1, text.size() - open - 2);
      any_unit_ = false;
      text = text.substr(0, open);
    }
  path_ = text;
  segments_ = path_segments(text);
  literal_ = text.find_first_of("*?") == std::string_view::npos;
}

bool FieldPattern::matches(std::string_view path, std::string_view unit) const {
  return (any_unit_ || unit == unit_) && match(segments_, 0, path_segments(path), 0);
}

std::vector<FieldPattern> parse_patterns(std::string_view text) {
  std::vector<FieldPattern> out;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r\n", at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
    out.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return out;
}

}  // namespace isogloss
