/// T="NAME": the tool of that name in the tool table. A number that no tool has as its name is a tool's number. Where
/// the table has no names, they are numbered in the order in which the program uses them.
#include <string>
#include <vector>

#include <isogloss/cnc/tool_names.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensToolName {
  static constexpr auto spec =
      ig::syntax("SiemensToolNameSyntax", "T=\"NAME\" becomes the number of a tool.").before("ToolChangeSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0235",
                     "the tool table has no tool '{0}', so the tool does not change: add its name"),
      ig::diagnostic(IG_NOTE, "SIE-0232", "the tool '{0}' has a name: it is row {1} of the tool table"),
  };

  ig::TextField name_{"ToolName.Text", ig::read | ig::wake};
  ToolNames table_;
  ig::Word t_{"Parsing.T", ig::write, ""};
  std::vector<std::string> names_;

  ig::Status restart(ig::Block&) {
    names_.clear();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    if (!b.has(name_)) return ig::Status::unchanged;
    const std::string_view name = b.text(name_);
    if (const auto id = table_.number(name)) {
      b.set(t_, static_cast<double>(*id % IG_TOOL_INDEX_STEP));
      return ig::Status::changed;
    }
    const ig::Decimal n = ig::read_decimal(name, 0);
    if (const auto id = n.ok && n.end == name.size() ? whole_number(n.value) : std::nullopt) {
      b.set(t_, static_cast<double>(*id));
      return ig::Status::changed;
    }
    if (table_.has_names()) {
      b.report(ig::diag("SIE-0235"), ig::Where::block(), name);
      return ig::Status::changed;
    }
    std::size_t i = 0;
    while (i < names_.size() && names_[i] != name) ++i;
    if (i == names_.size()) {
      if (names_.size() < most_names) names_.emplace_back(name);
      b.report(ig::diag("SIE-0232"), ig::Where::block(), name, static_cast<double>(i + 1));
    }
    b.set(t_, static_cast<double>(i + 1));
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t most_names = 1000;
};

const ig::Register<SiemensToolName> siemens_tool_name_syntax;

}  // namespace
}  // namespace siemens
