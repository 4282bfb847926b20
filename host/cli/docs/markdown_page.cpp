#include <fmt/format.h>

#include <algorithm>

#include "docs/page.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli::docs {

namespace {

/// A code span may hold backticks when more of them stand around it.
std::string backticks(std::string_view content) {
  std::size_t most = 0, run = 0;
  for (const char c : content) {
    run = c == '`' ? run + 1 : 0;
    most = std::max(most, run);
  }
  return std::string(most + 1, '`');
}

/// A line in a cell of a table: its bars are escaped, in code spans too.
std::string cell(const Markup& content) {
  std::string out;
  for (const char c : content) out += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return out;
}

class MarkdownPage : public Page {
 public:
  using Page::Page;

  Markup text(std::string_view plain) const override {
    std::string out;
    for (const char c : printable(plain, "\n\t")) {
      if (c == '<') {
        out += "&lt;";
        continue;
      }
      if (std::string_view("\\`*_[]#>!~&").find(c) != std::string_view::npos) out += '\\';
      out += c;
    }
    return out;
  }
  Markup code(std::string_view plain) const override {
    const std::string shown = printable(plain), fence = backticks(shown);
    if (shown.empty()) return {};
    const bool touches = shown.front() == '`' || shown.back() == '`';
    return touches ? fence + " " + shown + " " + fence : fence + shown + fence;
  }
  Markup link(const Address& to, const Markup& label) const override {
    return fmt::format("[{}]({})", label, relative_link(file(), to, ".md"));
  }
  Markup line_break() const override { return "<br>"; }

  void heading(unsigned level, const Markup& title, const std::string& anchor) override {
    out_ += fmt::format("{} <a id=\"{}\"></a>{}\n\n", std::string(level, '#'), anchor, title);
  }
  void paragraph(const Markup& content) override { out_ += content + "\n\n"; }
  void list(const std::vector<Markup>& items) override {
    for (const Markup& item : items) out_ += "* " + item + "\n";
    out_ += '\n';
  }
  std::vector<std::string> page_text(const std::string& markdown) override {
    ShownText shown = text_as_markdown({file(), markdown}, addresses());
    const std::size_t begin = std::min(shown.text.find_first_not_of('\n'), shown.text.size());
    const std::size_t end = shown.text.find_last_not_of('\n') + 1;
    out_ += shown.text.substr(begin, std::max(begin, end) - begin) + "\n\n";
    return std::move(shown.dead_links);
  }
  void graph(const Json&) override {
    const std::string name = file().substr(file().rfind('/') + 1);
    out_ += fmt::format("![The chain as a graph]({}.svg)\n\n", name);
  }
  std::string whole() const override { return "# " + text(title()) + "\n\n" + out_; }

 private:
  Markup prose_text(std::string_view plain) const override { return text(plain); }
  Markup prose_code(std::string_view plain) const override { return code(plain); }

  void full_table(const std::vector<std::string>& head, const std::vector<Row>& rows) override {
    std::string rule = "|";
    out_ += '|';
    for (const std::string& one : head) {
      out_ += " " + cell(text(one)) + " |";
      rule += "---|";
    }
    out_ += "\n" + rule + "\n";
    for (const Row& row : rows) {
      out_ += row.anchor.empty() ? "|" : fmt::format("| <a id=\"{}\"></a>", row.anchor);
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        out_ += (i == 0 && !row.anchor.empty() ? "" : " ") + cell(row.cells[i]) + " |";
      out_ += '\n';
    }
    out_ += '\n';
  }
};

}  // namespace

std::unique_ptr<Page> markdown_page(std::string file, std::string title, const Addresses& addresses) {
  return std::make_unique<MarkdownPage>(std::move(file), std::move(title), addresses);
}

}  // namespace isogloss::cli::docs
