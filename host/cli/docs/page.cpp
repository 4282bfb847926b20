#include "docs/page.hpp"

#include <algorithm>

namespace isogloss::cli::docs {

Markup Page::prose(std::string_view sentence) const {
  Markup out;
  for (std::size_t at = 0;;) {
    const std::size_t begin = sentence.find('`', at);
    const std::size_t end = begin == std::string_view::npos ? begin : sentence.find('`', begin + 1);
    if (end == std::string_view::npos) return out + prose_text(sentence.substr(at));
    out += prose_text(sentence.substr(at, begin - at)) + prose_code(sentence.substr(begin + 1, end - begin - 1));
    at = end + 1;
  }
}

Markup Page::name(Kind kind, const std::string& name) const {
  const Address* const address = addresses_.find(kind, name);
  return address == nullptr ? code(name) : link(*address, code(name));
}

Markup Page::names(Kind kind, const std::vector<std::string>& names) const {
  Markup out;
  for (const std::string& one : names) out += (out.empty() ? "" : ", ") + name(kind, one);
  return out;
}

void Page::table(const std::vector<std::string>& head, const std::vector<Row>& rows) {
  if (rows.empty()) return;
  std::vector<std::string> used_head;
  std::vector<Row> used(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) used[i].anchor = rows[i].anchor;
  for (std::size_t column = 0; column < head.size(); ++column) {
    if (std::all_of(rows.begin(), rows.end(), [&](const Row& row) { return row.cells[column].empty(); })) continue;
    used_head.push_back(head[column]);
    for (std::size_t i = 0; i < rows.size(); ++i) used[i].cells.push_back(rows[i].cells[column]);
  }
  full_table(used_head, used);
}

}  // namespace isogloss::cli::docs
