#include "link/pattern.hpp"

#include <algorithm>

namespace isogloss {

namespace {

bool digits(std::string_view s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Takes the first segment off the path. The decimal of a code belongs to it: one letter and digits before the point,
/// digits after it.
std::string_view next_segment(std::string_view& path) {
  std::size_t dot = path.find('.');
  if (dot != std::string_view::npos && dot > 1 && digits(path.substr(1, dot - 1))) {
    const std::size_t after = path.find('.', dot + 1);
    if (digits(path.substr(dot + 1, after - dot - 1))) dot = after;
  }
  const std::string_view segment = path.substr(0, dot);
  path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
  return segment;
}

bool match(const std::vector<std::string>& pattern, std::size_t p, std::string_view path) {
  if (p == pattern.size()) return path.empty();
  if (path.empty()) return false;
  const std::string_view segment = next_segment(path);
  if (pattern[p] == "**") {
    while (true) {
      if (match(pattern, p + 1, path)) return true;
      if (path.empty()) return false;
      next_segment(path);
    }
  }
  const bool fits = pattern[p] == "*" || (pattern[p] == "?" ? segment.size() == 1 : pattern[p] == segment);
  return fits && match(pattern, p + 1, path);
}

}  // namespace

std::vector<std::string> path_segments(std::string_view path) {
  std::vector<std::string> out;
  while (!path.empty()) out.emplace_back(next_segment(path));
  return out;
}

FieldPattern::FieldPattern(std::string_view text) {
  if (text.ends_with('}'))
    if (const std::size_t open = text.rfind('{'); open != std::string_view::npos) {
      unit_ = text.substr(open + 1, text.size() - open - 2);
      any_unit_ = false;
      text = text.substr(0, open);
    }
  path_ = text;
  if (const std::size_t open = path_.find('{'), close = path_.find("}.");
      open != std::string::npos && close != std::string::npos && open < close) {
    owner_unit_ = path_.substr(open + 1, close - open - 1);
    owner_segments_ = path_segments(std::string_view(path_).substr(0, open)).size();
    path_.erase(open, close + 1 - open);
    text = path_;
  }
  segments_ = path_segments(text);
  literal_ = text.find_first_of("*?") == std::string_view::npos;
  prefix_size_ = std::min(text.find_first_of("*?"), text.size());
  if (segments_.size() > 1 && segments_.back().find_first_of("*?") == std::string::npos)
    suffix_ = "." + segments_.back();
  if (!suffix_.empty()) last_ = suffix_.back();
  const std::string_view wild = text.substr(prefix_size_);
  wild_ = wild == "**"    ? Wild::all
          : wild == "?"   ? Wild::letter
          : wild == "*"   ? Wild::segment
          : wild == "*.?" ? Wild::segment_and_letter
                          : Wild::other;
  if (!suffix_.empty() && !digits(suffix_.substr(1)) && wild == "*" + suffix_) wild_ = Wild::segment_and_suffix;
}

std::string_view FieldPattern::owner(std::string_view path) const {
  std::string_view rest = path;
  for (std::size_t i = 0; i < owner_segments_; ++i) next_segment(rest);
  // Without the point between the two.
  return rest.empty() ? path : path.substr(0, path.size() - rest.size() - 1);
}

bool FieldPattern::matches(std::string_view path, std::string_view unit) const {
  if (!any_unit_ && unit != unit_) return false;
  if (!path.ends_with(suffix_) || !path.starts_with(std::string_view(path_).substr(0, prefix_size_))) return false;
  const std::size_t rest = path.size() - prefix_size_;
  // The common endings of patterns need no segments.
  switch (wild_) {
    case Wild::all: return rest > 0;
    case Wild::letter: return rest == 1;
    case Wild::segment:
      if (path.find('.', prefix_size_) == std::string_view::npos) return rest > 0;
      break;
    case Wild::segment_and_suffix: {
      const std::string_view middle = path.substr(prefix_size_, rest - std::min(rest, suffix_.size()));
      const std::size_t dot = middle.find('.');
      if (dot == std::string_view::npos) return !middle.empty();
      // Only the decimals of a code stand after a point of the same segment.
      if (dot + 1 == middle.size() || !digits(middle.substr(dot + 1, 1))) return false;
      break;
    }
    case Wild::segment_and_letter: {
      const std::size_t dot = path.find('.', prefix_size_);
      if (dot == std::string_view::npos) return false;
      // A single letter after the only point; a digit there may be the decimal of a code.
      if (dot + 2 == path.size() && dot > prefix_size_ && (path.back() < '0' || path.back() > '9')) return true;
      break;
    }
    case Wild::other: break;
  }
  return match(segments_, 0, path);
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
