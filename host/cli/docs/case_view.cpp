#include "docs/case_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "docs/page_text.hpp"

namespace isogloss::cli::docs {

namespace {

struct Label {
  std::string_view word, caption;
  bool is_result;
};

constexpr Label labels[] = {{"Previous", "Previous block", false},
                            {"Ahead", "Blocks ahead", false},
                            {"Dependencies", "Options and tables", false},
                            {"BeforeBuild", "Before", false},
                            {"File", "File", false},
                            {"Options", "Options", false},
                            {"AfterBuild", "After", true},
                            {"Tables", "Tables", true},
                            {"Unused", "Not read", true},
                            {"Written", "Written back", true},
                            {"LeftOut", "Not written", true},
                            {"Diagnostics", "Diagnostics", true}};

const Label* find_label(std::string_view word) {
  const auto* const found =
      std::find_if(std::begin(labels), std::end(labels), [&](const Label& l) { return l.word == word; });
  return found == std::end(labels) ? nullptr : found;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

/// Without indentation and the comma that separates it from the next one; empty where only brackets stand there.
std::string_view content_of(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  line.remove_prefix(begin);
  while (!line.empty() && (line.back() == ' ' || line.back() == ',')) line.remove_suffix(1);
  return line.find_first_not_of("{}[] ") == std::string_view::npos ? std::string_view() : line;
}

/// Marks the lines that the other side lacks.
std::string marked(const std::string& text, const std::string& other, std::string_view mark) {
  std::set<std::string_view> known;
  for (const std::string_view line : lines_of(other)) known.insert(content_of(line));
  std::string out;
  for (const std::string_view line : lines_of(text)) {
    const std::string_view content = content_of(line);
    const bool differs = !content.empty() && !known.contains(content);
    out += differs ? fmt::format("<{0}>{1}</{0}>\n", mark, escaped_html(line)) : escaped_html(line) + "\n";
  }
  return out;
}

const CasePart* part_of(const std::vector<CasePart>& parts, std::string_view label) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const CasePart& p) { return p.label == label; });
  return found == parts.end() ? nullptr : &*found;
}

}  // namespace

CasePart case_label(std::string_view paragraph) {
  CasePart out;
  const std::size_t colon = paragraph.find(':');
  if (!paragraph.starts_with('#') || colon == std::string_view::npos) return out;
  if (find_label(paragraph.substr(1, colon - 1)) == nullptr) return out;
  out.label = paragraph.substr(1, colon - 1);
  out.value = paragraph.substr(std::min(paragraph.find_first_not_of(' ', colon + 1), paragraph.size()));
  return out;
}

std::string case_as_html(const std::vector<CasePart>& parts, const std::string& from_file, const Addresses& addresses) {
  const CasePart* const before = part_of(parts, "BeforeBuild");
  const CasePart* const after = part_of(parts, "AfterBuild");
  std::string sides[2];
  for (const CasePart& part : parts) {
    const Label& label = *find_label(part.label);
    std::string& side = sides[label.is_result ? 1 : 0];
    side += fmt::format("<figure><figcaption>{}{}</figcaption>", label.caption,
                        part.value.empty() ? "" : " " + linked_html(part.value, from_file, addresses));
    if (part.has_fence) {
      const std::string text = &part == before && after != nullptr   ? marked(part.text, after->text, "del")
                               : &part == after && before != nullptr ? marked(part.text, before->text, "ins")
                               : part.label == "Diagnostics"         ? linked_html(part.text, from_file, addresses)
                                                                     : escaped_html(part.text);
      side += "<pre><code>" + text + "</code></pre>";
    }
    side += "</figure>\n";
  }
  return fmt::format("<div class=\"case\">\n<div>\n{}</div>\n<div>\n{}</div>\n</div>\n", sides[0], sides[1]);
}

}  // namespace isogloss::cli::docs
