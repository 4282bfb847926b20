// A page as HTML. The library parses; raw HTML is switched off, so what looks like a tag is text.
#include <fmt/format.h>
#include <md4c.h>

#include "docs/case_view.hpp"
#include "docs/page_text.hpp"

namespace isogloss::cli::docs {

namespace {

/// "the-r-plane", as other programs name the place of a heading.
std::string slug(std::string_view title) {
  std::string out;
  for (const char c : title)
    if (c == ' ' || c == '-')
      out += '-';
    else if (c >= 'A' && c <= 'Z')
      out += static_cast<char>(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_')
      out += c;
  return out.empty() ? "section" : out;
}

class Renderer {
 public:
  Renderer(const PageText& page, const Addresses& addresses, std::set<std::string> known)
      : page_(page), addresses_(addresses), known_anchors_(std::move(known)) {}

  ShownText run() {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* self) { return me(self).enter(type, detail); };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* self) { return me(self).leave(type); };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* self) { return me(self).enter_span(type, detail); };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* self) { return me(self).leave_span(type); };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* text, MD_SIZE size, void* self) {
      return me(self).text(type, {text, size});
    };
    md_parse(page_.markdown.data(), static_cast<MD_SIZE>(page_.markdown.size()), &parser, this);
    return std::move(shown_);
  }
  const std::set<std::string>& anchors() const { return anchors_; }

 private:
  static Renderer& me(void* self) { return *static_cast<Renderer*>(self); }

  static std::string_view tag(MD_BLOCKTYPE type) {
    switch (type) {
      case MD_BLOCK_QUOTE: return "blockquote";
      case MD_BLOCK_UL: return "ul";
      case MD_BLOCK_OL: return "ol";
      case MD_BLOCK_LI: return "li";
      case MD_BLOCK_P: return "p";
      case MD_BLOCK_THEAD: return "thead";
      case MD_BLOCK_TBODY: return "tbody";
      case MD_BLOCK_TR: return "tr";
      case MD_BLOCK_TH: return "th";
      case MD_BLOCK_TD: return "td";
      default: return "";
    }
  }

  int enter(MD_BLOCKTYPE type, void* detail) {
    if (type == MD_BLOCK_DOC) return 0;
    if (depth_++ == 0 && type != MD_BLOCK_P && type != MD_BLOCK_CODE) end_case();
    if (depth_ == 1) {
      begin_ = shown_.text.size();
      plain_.clear();
    }
    if (type == MD_BLOCK_H) {
      level_ = static_cast<MD_BLOCK_H_DETAIL*>(detail)->level;
      begin_ = shown_.text.size();
      plain_.clear();
    } else if (type == MD_BLOCK_CODE) {
      is_in_fence_ = true;
      fence_.clear();
    } else if (type == MD_BLOCK_TABLE) {
      shown_.text += "<div class=\"wide\"><table>\n";
    } else if (type == MD_BLOCK_HR) {
      shown_.text += "<hr>\n";
    } else if (type == MD_BLOCK_OL) {
      shown_.text += fmt::format("<ol start=\"{}\">\n", static_cast<MD_BLOCK_OL_DETAIL*>(detail)->start);
    } else if (type != MD_BLOCK_P || depth_ > 1) {
      shown_.text += fmt::format("<{}>", tag(type));
    }
    return 0;
  }

  int leave(MD_BLOCKTYPE type) {
    if (type == MD_BLOCK_DOC) {
      end_case();
      return 0;
    }
    --depth_;
    if (type == MD_BLOCK_H)
      end_heading();
    else if (type == MD_BLOCK_CODE)
      end_fence();
    else if (type == MD_BLOCK_TABLE)
      shown_.text += "</table></div>\n";
    else if (type == MD_BLOCK_P && depth_ == 0)
      end_paragraph();
    else if (type != MD_BLOCK_HR)
      shown_.text += fmt::format("</{}>\n", tag(type));
    return 0;
  }

  void end_heading() {
    const std::string content = shown_.text.substr(begin_);
    shown_.text.resize(begin_);
    if (level_ == 1 && begin_ == 0) return;  // the title, which the page of the reference has already
    const std::string base = slug(plain_);
    std::string anchor = base;
    for (int n = 1; !anchors_.insert(anchor).second; ++n) anchor = fmt::format("{}-{}", base, n);
    shown_.text += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", std::max(level_, 2U), anchor, content);
  }

  void end_paragraph() {
    CasePart part = case_label(plain_);
    const std::string content = shown_.text.substr(begin_);
    shown_.text.resize(begin_);
    if (part.label.empty()) {
      end_case();
      shown_.text += "<p>" + content + "</p>\n";
    } else {
      case_.push_back(std::move(part));
    }
  }

  void end_fence() {
    is_in_fence_ = false;
    if (depth_ == 0 && !case_.empty() && !case_.back().has_fence) {
      case_.back().has_fence = true;
      case_.back().text = std::move(fence_);
      return;
    }
    if (depth_ == 0) end_case();
    shown_.text += "<pre><code>" + escaped_html(fence_) + "</code></pre>\n";
  }

  void end_case() {
    if (!case_.empty()) shown_.text += case_as_html(case_, page_.file, addresses_);
    case_.clear();
  }

  int enter_span(MD_SPANTYPE type, void* detail) {
    if (type == MD_SPAN_EM) shown_.text += "<em>";
    if (type == MD_SPAN_STRONG) shown_.text += "<strong>";
    if (type == MD_SPAN_CODE) is_in_code_ = true;
    if (type == MD_SPAN_A) enter_link(static_cast<MD_SPAN_A_DETAIL*>(detail)->href);
    // Of an image only its text is shown: the reference loads nothing.
    if (type == MD_SPAN_IMG) add_dead_link(static_cast<MD_SPAN_IMG_DETAIL*>(detail)->src);
    return 0;
  }

  int leave_span(MD_SPANTYPE type) {
    if (type == MD_SPAN_EM) shown_.text += "</em>";
    if (type == MD_SPAN_STRONG) shown_.text += "</strong>";
    if (type == MD_SPAN_CODE) {
      shown_.text +=
          is_in_link_ ? "<code>" + escaped_html(code_) + "</code>" : code_html(code_, page_.file, addresses_);
      code_.clear();
      is_in_code_ = false;
    }
    if (type == MD_SPAN_A && is_in_link_) {
      shown_.text += "</a>";
      is_in_link_ = false;
    }
    return 0;
  }

  void add_dead_link(const MD_ATTRIBUTE& href) { shown_.dead_links.emplace_back(href.text, href.size); }

  /// Entities stay as they are: an address that hides behind them is none of those that are let through.
  void enter_link(const MD_ATTRIBUTE& href) {
    const std::string_view link(href.text, href.size);
    const bool is_own = link.starts_with('#') && known_anchors_.contains(std::string(link.substr(1)));
    const std::string target = is_own ? std::string(link) : target_of_link(link, page_.file, addresses_, ".html");
    is_in_link_ = !target.empty();
    if (is_in_link_)
      shown_.text += fmt::format("<a href=\"{}\">", escaped_html(target));
    else
      add_dead_link(href);
  }

  int text(MD_TEXTTYPE type, std::string_view text) {
    if (is_in_fence_) {
      fence_ += text;
      return 0;
    }
    const bool is_break = type == MD_TEXT_SOFTBR || type == MD_TEXT_BR;
    plain_ += is_break ? "\n" : text;
    if (is_in_code_)
      code_ += is_break ? " " : text;
    else if (type == MD_TEXT_BR)
      shown_.text += "<br>\n";
    else if (type == MD_TEXT_SOFTBR)
      shown_.text += '\n';
    else if (type == MD_TEXT_ENTITY)
      shown_.text += text;
    else
      shown_.text += is_in_link_ ? escaped_html(text) : linked_html(text, page_.file, addresses_);
    return 0;
  }

  const PageText& page_;
  const Addresses& addresses_;
  std::set<std::string> known_anchors_, anchors_;
  ShownText shown_;
  unsigned depth_ = 0, level_ = 0;
  std::size_t begin_ = 0;  ///< of the heading or paragraph
  std::string plain_, code_, fence_;
  bool is_in_code_ = false, is_in_fence_ = false, is_in_link_ = false;
  std::vector<CasePart> case_;
};

}  // namespace

ShownText text_as_html(const PageText& page, const Addresses& addresses) {
  Renderer first(page, addresses, {});
  ShownText out = first.run();
  if (page.markdown.find("](#") == std::string::npos) return out;
  return Renderer(page, addresses, first.anchors()).run();  // now that the places on the page are known
}

}  // namespace isogloss::cli::docs
