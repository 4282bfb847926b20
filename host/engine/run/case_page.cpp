/// Reads the cases of a page.
#include <utility>

#include "isogloss/engine/byte_order_mark.hpp"
#include "isogloss/engine/cases.hpp"

namespace isogloss {

namespace {

std::string_view without_blanks(std::string_view s) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!s.empty() && blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && blank(s.back())) s.remove_suffix(1);
  return s;
}

class PageReader {
 public:
  PageReader(const std::string& file, DiagnosticSink& sink) : file_(file), sink_(sink) {}

  Page read(std::string_view text) {
    text = behind_byte_order_mark(text);
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (inside_) fault(fence_.line, "a fence is not closed");
    close_case();
    return std::move(page_);
  }

 private:
  void line(std::string_view raw) {
    ++line_;
    const std::string_view text = without_blanks(raw);
    if (inside_) {
      if (text.starts_with("```"))
        close_fence();
      else
        (fence_.text += raw) += '\n';
    } else if (text.starts_with("```")) {
      inside_ = true;
      fence_ = {"", line_ + 1};
    } else if (text.starts_with("## ")) {
      close_case();
      heading_ = text.substr(3);
    } else if (text.starts_with("# ")) {
      if (page_.syntax.empty()) page_.syntax = without_blanks(text.substr(2));
    } else if (text == "#Diagnostics: any") {
      begin_case();
      case_.accepts_any_code = true;
    } else if (text.starts_with("#File: ")) {
      if (case_.file || case_.before) close_case();
      begin_case();
      case_.file_name = without_blanks(text.substr(7));
      awaited_ = &case_.file;
    } else if (std::optional<Fence>* const wanted = marker(text)) {
      awaited_ = wanted;
    }
  }

  /// The member that a marker line fills; a marker that was filled already begins the next case.
  std::optional<Fence>* marker(std::string_view text) {
    static constexpr std::pair<std::string_view, std::optional<Fence> Case::*> markers[] = {
        {"#Previous:", &Case::previous},  {"#Ahead:", &Case::ahead},      {"#Dependencies:", &Case::dependencies},
        {"#BeforeBuild:", &Case::before}, {"#AfterBuild:", &Case::after}, {"#Diagnostics:", &Case::diagnostics},
        {"#Options:", &Case::options},    {"#Tables:", &Case::tables},    {"#Unused:", &Case::unused},
        {"#Written:", &Case::written},    {"#LeftOut:", &Case::left_out},
    };
    for (const auto& [name, member] : markers) {
      if (text != name) continue;
      if ((case_.*member).has_value()) close_case();
      begin_case();
      return &(case_.*member);
    }
    return nullptr;
  }

  void begin_case() {
    if (case_.line == 0) case_.line = line_;
  }

  void close_fence() {
    inside_ = false;
    if (awaited_ != nullptr) *awaited_ = std::move(fence_);
    awaited_ = nullptr;
  }

  void close_case() {
    awaited_ = nullptr;
    Case done = std::move(case_);
    case_ = {};
    if (done.line == 0) return;
    done.heading = heading_;
    if (!done.file_name.empty()) {
      if (!done.file) return fault(done.line, "a case without the fence of its #File:");
      if (!done.tables) return fault(done.line, "a case without #Tables: and its fence");
      page_.cases.push_back(std::move(done));
      return;
    }
    if (!done.before) return fault(done.line, "a case without #BeforeBuild: and its fence");
    if (!done.after) return fault(done.line, "a case without #AfterBuild: and its fence");
    page_.cases.push_back(std::move(done));
  }

  void fault(std::uint32_t at, std::string what) {
    sink_.add(host_diagnostic("IG-0501", {file_, at, 0}, {std::move(what)}));
  }

  const std::string& file_;
  DiagnosticSink& sink_;
  Page page_;
  Case case_;
  Fence fence_;
  std::string heading_;
  std::optional<Fence>* awaited_ = nullptr;
  std::uint32_t line_ = 0;
  bool inside_ = false;
};

}  // namespace

Page read_page(std::string_view text, const std::string& file, DiagnosticSink& sink) {
  return PageReader(file, sink).read(text);
}

}  // namespace isogloss
