// A block as JSON for one syntax, which the first two bytes choose: refused with a diagnostic, or built to a block that
// can be read again.
#include <algorithm>

#include "isogloss/engine/cases.hpp"
#include "target.hpp"

namespace isogloss::fuzz {

namespace {

class BlockTarget : public Target {
 public:
  BlockTarget() {
    workspace().library().load_all();
    syntaxes_ = workspace().library().syntax_ids();
    std::sort(syntaxes_.begin(), syntaxes_.end());
  }

  void run(std::string_view bytes) override {
    if (bytes.size() < 2) return;
    const std::size_t chosen = static_cast<unsigned char>(bytes[0]) * 256u + static_cast<unsigned char>(bytes[1]);
    const std::string& syntax = syntaxes_[chosen % syntaxes_.size()];
    DiagnosticList said;
    const auto built = apply(application(syntax, std::string(bytes.substr(2))), {}, workspace().library(), said);
    for (const Diagnostic& d : said.all)
      if (d.code == "IG-0402") fail("no block makes a syntax break the contract: " + d.message);
    if (!built) return;
    accept();
    DiagnosticList again;
    if (!apply(application(syntax, *built), {}, workspace().library(), again) && !again.has_errors())
      fail("a block that cannot be built is reported");
  }

  std::vector<std::string> words() const override { return declared_names(); }
  std::vector<std::string> samples() const override {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < syntaxes_.size(); ++i) {
      const ig_syntax* const syntax = workspace().library().syntax(syntaxes_[i]);
      DiagnosticList ignored;
      if (syntax == nullptr || syntax->page == nullptr) continue;
      const Page page = read_page(syntax->page, syntaxes_[i], ignored);
      if (page.cases.empty() || !page.cases[0].before) continue;
      out.push_back({static_cast<char>(i / 256), static_cast<char>(i % 256)});
      out.back() += page.cases[0].before->text;
    }
    return out;
  }

 private:
  static Application application(const std::string& syntax, std::string before) {
    return {syntax, std::move(before), std::nullopt, "", {"block.json", 1, 1}};
  }

  std::vector<std::string> syntaxes_;
};

}  // namespace

std::unique_ptr<Target> make_block_target() { return std::make_unique<BlockTarget>(); }

}  // namespace isogloss::fuzz
