// A page as Markdown for other tools to show. It stays as it was written, but for tags and links that lead nowhere.
#include <md4c.h>

#include <map>

#include "docs/page_text.hpp"

namespace isogloss::cli::docs {

namespace {

/// What the parser finds, by its place in the source.
class Cleaner {
 public:
  Cleaner(const PageText& page, const Addresses& addresses) : page_(page), addresses_(addresses) {}

  ShownText run() {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TABLES;
    const auto ignore = [](MD_BLOCKTYPE, void*, void*) { return 0; };
    parser.enter_block = ignore;
    parser.leave_block = ignore;
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) {
      if (type == MD_SPAN_A) me(self).link(static_cast<MD_SPAN_A_DETAIL*>(detail)->href);
      if (type == MD_SPAN_IMG) me(self).replace_link(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src, "#");
      return 0;
    };
    parser.leave_span = [](MD_SPANTYPE, void*, void*) { return 0; };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
      if (type == MD_TEXT_HTML) me(self).tag({text, size});
      return 0;
    };
    md_parse(page_.markdown.data(), static_cast<MD_SIZE>(page_.markdown.size()), &parser, this);
    return {edited(), std::move(dead_links_)};
  }

 private:
  struct Edit {
    std::size_t size;
    std::string by;
  };

  static Cleaner& me(void* self) { return *static_cast<Cleaner*>(self); }

  /// Where a part of the source stands; npos for a text that the parser put together.
  std::size_t place(const char* text) const {
    const std::less<> before;
    const char* const begin = page_.markdown.data();
    return text == nullptr || before(text, begin) || !before(text, begin + page_.markdown.size())
               ? std::string::npos
               : static_cast<std::size_t>(text - begin);
  }

  void tag(std::string_view html) {
    const std::size_t begin = place(html.data());
    for (std::size_t i = 0; i < html.size() && begin != std::string::npos; ++i)
      if (html[i] == '<') edits_[begin + i] = {1, "&lt;"};
  }

  void link(const MD_ATTRIBUTE& href) {
    const std::string_view link(href.text, href.size);
    if (link.starts_with('#')) return;
    const std::string target = target_of_link(link, page_.file, addresses_, ".md");
    if (target != link) replace_link(href, target);
  }

  void replace_link(const MD_ATTRIBUTE& href, const std::string& by) {
    if (by.empty() || by == "#") dead_links_.emplace_back(href.text, href.size);
    const std::size_t begin = place(href.text);
    if (begin == std::string::npos)
      has_hidden_link_ = true;
    else
      edits_[begin] = {href.size, by.empty() ? "#" : by};
  }

  std::string edited() const {
    const std::string& source = page_.markdown;
    // The title is that of the page in the reference.
    std::size_t at = source.starts_with("# ") ? std::min(source.find('\n'), source.size()) : 0;
    std::string out;
    for (const auto& [begin, edit] : edits_) {
      if (begin < at) continue;
      out += source.substr(at, begin - at) + edit.by;
      at = begin + edit.size;
    }
    out += source.substr(at);
    return has_hidden_link_ ? without_links(out) : out;
  }

  /// For a page that writes an address with escapes or entities, which cannot be found in its source.
  static std::string without_links(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '[' ? "&#91;" : std::string(1, c);
    return out;
  }

  const PageText& page_;
  const Addresses& addresses_;
  std::map<std::size_t, Edit> edits_;
  std::vector<std::string> dead_links_;
  bool has_hidden_link_ = false;
};

}  // namespace

ShownText text_as_markdown(const PageText& page, const Addresses& addresses) { return Cleaner(page, addresses).run(); }

}  // namespace isogloss::cli::docs
