#include "dialect/text_edits.hpp"

#include <algorithm>
#include <utility>

namespace isogloss::cli {

TextEdits::TextEdits(const std::string& text) : text_(text), elements_(text) {
  constexpr std::pair<std::string_view, std::string_view> others[] = {
      {"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
  for (std::size_t at = 0; (at = elements_.find('<', at)) != std::string::npos; ++at)
    for (const auto& [open, close] : others) {
      if (elements_.compare(at, open.size(), open) != 0) continue;
      const std::size_t end = elements_.find(close, at + open.size());
      const std::size_t size = (end == std::string::npos ? elements_.size() : end + close.size()) - at;
      elements_.replace(at, size, size, ' ');
    }
}

std::string TextEdits::apply() {
  std::stable_sort(all_.begin(), all_.end(), [](const One& a, const One& b) { return a.begin < b.begin; });
  std::string out;
  std::size_t at = 0;
  for (const One& one : all_) {
    if (one.begin > at) out += text_.substr(at, one.begin - at);
    out += one.by;
    at = std::max(at, one.end);
  }
  return out + text_.substr(at);
}

std::size_t TextEdits::offset(const Location& where) const {
  std::size_t at = text_.starts_with("\xef\xbb\xbf") ? 3 : 0;
  for (std::uint32_t line = 1; line < where.line && at < text_.size(); ++line) {
    at = std::min(text_.find_first_of("\r\n", at), text_.size() - 1) + 1;
    if (text_[at - 1] == '\r' && at < text_.size() && text_[at] == '\n') ++at;
  }
  return std::min(at + where.column - 1, text_.size());
}

std::size_t TextEdits::end_of(std::size_t begin) const {
  const std::size_t name_end = std::min(elements_.find_first_of(" \t\r\n/>", begin + 1), elements_.size());
  const std::string name = elements_.substr(begin + 1, name_end - begin - 1);
  std::size_t at = name_end;
  for (char quote = '\0'; at < elements_.size() && (quote != '\0' || elements_[at] != '>'); ++at)
    quote = quote != '\0'                                   ? (elements_[at] == quote ? '\0' : quote)
            : elements_[at] == '"' || elements_[at] == '\'' ? elements_[at]
                                                            : '\0';
  if (at > 0 && at < elements_.size() && elements_[at - 1] == '/') return at + 1;
  const std::size_t close = elements_.find("</" + name, at);
  return close == std::string::npos ? elements_.size() : std::min(elements_.find('>', close), elements_.size() - 1) + 1;
}

std::size_t TextEdits::line_begin(std::size_t at) const {
  const std::size_t newline = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
  return newline == std::string::npos ? 0 : newline + 1;
}

std::string TextEdits::indentation(std::size_t at) const {
  const std::size_t begin = line_begin(at);
  const std::size_t first = std::min(text_.find_first_not_of(" \t", begin), text_.size());
  return text_.substr(begin, std::min(first, at) - begin);
}

void TextEdits::remove(std::size_t begin) {
  const std::size_t end = end_of(begin), first = line_begin(begin);
  const std::size_t newline = text_.find('\n', end);
  const std::string_view tail = std::string_view(text_).substr(end, newline == std::string::npos ? 0 : newline - end);
  const bool is_alone = text_.find_first_not_of(" \t", first) == begin && newline != std::string::npos &&
                        tail.find_first_not_of(" \t\r") == std::string_view::npos;
  is_alone ? replace(first, newline + 1, "") : replace(begin, end, "");
}

}  // namespace isogloss::cli
