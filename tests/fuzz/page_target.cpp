// Pages with cases: read with diagnostics, and run.
#include "isogloss/engine/cases.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

class PageTarget : public Target {
 public:
  PageTarget() { workspace().library().load_all(); }

  void run(std::string_view bytes) override {
    constexpr std::size_t most_cases = 4;
    DiagnosticList said;
    Page page = read_page(bytes, "page.md", said);
    if (workspace().library().syntax(page.syntax) == nullptr && workspace().library().importer(page.syntax) == nullptr)
      page.syntax = "DwellSyntax";
    if (!page.cases.empty() && !said.has_errors()) accept();
    for (std::size_t i = 0; i < page.cases.size() && i < most_cases; ++i)
      static_cast<void>(run_case(page, page.cases[i], "page.md", {}, workspace().library()));
  }
  std::vector<std::string> words() const override { return declared_names(); }
  std::vector<std::string> samples() const override { return texts_of_files("plugins", ".md"); }
};

}  // namespace

std::unique_ptr<Target> make_page_target() { return std::make_unique<PageTarget>(); }

}  // namespace isogloss::fuzz
