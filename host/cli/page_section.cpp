#include "page_section.hpp"

#include <algorithm>
#include <cstring>

#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

struct Heading {
  std::string title;
  std::size_t level, begin;
};

std::vector<Heading> find_headings(std::string_view page) {
  std::vector<Heading> out;
  bool in_fence = false;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t end = std::min(page.find('\n', at), page.size());
    std::string_view line = page.substr(at, end - at);
    if (line.starts_with("```")) in_fence = !in_fence;
    const std::size_t level = std::min(line.find_first_not_of('#'), line.size());
    if (!in_fence && level > 0 && level < line.size() && line[level] == ' ')
      out.push_back({std::string(line.substr(line.find_first_not_of(' ', level))), level, at});
    at = end + 1;
  }
  return out;
}

std::string in_small_letters(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return out;
}

}  // namespace

std::string printable_page(const char* page) {
  constexpr std::size_t longest = std::size_t{1} << 20;
  return page == nullptr ? std::string() : printable({page, strnlen(page, longest)}, "\n\t");
}

std::vector<std::string> headings(std::string_view page) {
  std::vector<std::string> out;
  for (Heading& h : find_headings(page)) out.push_back(std::move(h.title));
  return out;
}

std::optional<std::string> section_of(std::string_view page, std::string_view title) {
  const std::vector<Heading> all = find_headings(page);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (in_small_letters(all[i].title) != in_small_letters(title)) continue;
    std::size_t end = page.size();
    for (std::size_t k = i + 1; k < all.size() && end == page.size(); ++k)
      if (all[k].level <= all[i].level) end = all[k].begin;
    std::string out(page.substr(all[i].begin, end - all[i].begin));
    while (out.ends_with('\n')) out.pop_back();
    return out + "\n";
  }
  return std::nullopt;
}

}  // namespace isogloss::cli
