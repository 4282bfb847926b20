#include <fmt/format.h>

#include "dialect/chain_map.hpp"
#include "docs/page.hpp"

namespace isogloss::cli::docs {

namespace {

class HtmlPage : public Page {
 public:
  using Page::Page;

  Markup text(std::string_view plain) const override { return escaped_html(plain); }
  Markup code(std::string_view plain) const override { return "<code>" + escaped_html(plain) + "</code>"; }
  Markup link(const Address& to, const Markup& label) const override {
    return fmt::format("<a href=\"{}\">{}</a>", relative_link(file(), to, ".html"), label);
  }
  Markup line_break() const override { return "<br>"; }

  void heading(unsigned level, const Markup& title, const std::string& anchor) override {
    out_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", level, anchor, title);
  }
  void paragraph(const Markup& content) override { out_ += "<p>" + content + "</p>\n"; }
  void list(const std::vector<Markup>& items) override {
    out_ += "<ul>\n";
    for (const Markup& item : items) out_ += "<li>" + item + "</li>\n";
    out_ += "</ul>\n";
  }
  std::vector<std::string> page_text(const std::string& markdown) override {
    ShownText shown = text_as_html({file(), markdown}, addresses());
    out_ += "<article>\n" + shown.text + "</article>\n";
    return std::move(shown.dead_links);
  }
  void graph(const Json& chain) override {
    out_ += "<div class=\"wide graph\">\n" +
            chain_as_svg(chain,
                         [&](const std::string& syntax) {
                           const Address* const page = addresses().find(Kind::part, syntax);
                           return page == nullptr ? std::string() : relative_link(file(), *page, ".html");
                         }) +
            "</div>\n";
  }

  std::string whole() const override {
    static constexpr std::pair<const char*, const char*> places[] = {
        {"syntaxes", "Syntaxes"},       {"codes", "Codes"},       {"fields", "Fields"},
        {"diagnostics", "Diagnostics"}, {"dialects", "Dialects"}, {"machines", "Machines"},
        {"plugins", "Plugins"},         {"tables", "Tables"},     {"importers", "Importers"}};
    const std::string root = file().find('/') == std::string::npos ? "" : "../";
    std::string navigation;
    for (const auto& [place, label] : places) navigation += link({place, {}}, label) + "\n";
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{0} – Isogloss reference</title>\n"
        "<link rel=\"stylesheet\" href=\"{1}style.css\">\n</head>\n<body>\n<header>\n"
        "<a class=\"home\" href=\"{1}index.html\">Isogloss reference</a>\n<nav>\n{2}</nav>\n"
        "<div class=\"search\" data-root=\"{1}\" hidden><input type=\"search\" aria-label=\"Search names\" "
        "placeholder=\"G83, DwellSyntax, ISO-0302\"><ul></ul></div>\n</header>\n<main>\n<h1>{0}</h1>\n{3}</main>\n"
        "<script src=\"{1}names.js\"></script>\n<script src=\"{1}search.js\"></script>\n</body>\n</html>\n",
        escaped_html(title()), root, navigation, out_);
  }

 private:
  Markup prose_text(std::string_view plain) const override { return linked_html(plain, file(), addresses()); }
  Markup prose_code(std::string_view plain) const override { return code_html(plain, file(), addresses()); }

  void full_table(const std::vector<std::string>& head, const std::vector<Row>& rows) override {
    out_ += "<div class=\"wide\"><table>\n<thead><tr>";
    for (const std::string& one : head) out_ += "<th>" + escaped_html(one) + "</th>";
    out_ += "</tr></thead>\n<tbody>\n";
    for (const Row& row : rows) {
      out_ += row.anchor.empty() ? "<tr>" : fmt::format("<tr id=\"{}\">", row.anchor);
      // The label is what a narrow screen shows in place of the head.
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        if (!row.cells[i].empty())
          out_ += fmt::format("<td data-label=\"{}\">{}</td>", escaped_html(head[i]), row.cells[i]);
        else
          out_ += "<td></td>";
      out_ += "</tr>\n";
    }
    out_ += "</tbody>\n</table></div>\n";
  }
};

}  // namespace

std::unique_ptr<Page> html_page(std::string file, std::string title, const Addresses& addresses) {
  return std::make_unique<HtmlPage>(std::move(file), std::move(title), addresses);
}

}  // namespace isogloss::cli::docs
