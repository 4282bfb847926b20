/// T="NAME": the tool of that name in the tool table. A number that no tool has as its name is a tool's number. Where
/// the table has no names, they are numbered in the order in which the program uses them.
#include <string>
#include <unordered_map>
#include <utility>

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
      ig::diagnostic(
          IG_NOTE, "SIE-0236",
          "tools {1} and {2} are both called '{0}': the first is used, as the life of tools is not known here"),
  };

  ig::TextField name_{"ToolName.Text", ig::read | ig::wake};
  ToolNames table_;
  ig::Word t_{"Parsing.T", ig::write, ""};

  ig::Status restart(ig::Block&) {
    ++run_;
    count_ = 0;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    if (!b.has(name_)) return ig::Status::unchanged;
    const std::string_view name = b.text(name_);
    if (const auto id = table_.number(name)) {
      const std::int64_t tool = *id % IG_TOOL_INDEX_STEP;
      if (use(name, tool).second)
        if (const auto sister = table_.sister(name, *id))
          b.report(ig::diag("SIE-0236"), ig::Where::block(), name, static_cast<double>(tool),
                   static_cast<double>(*sister % IG_TOOL_INDEX_STEP));
      b.set(t_, static_cast<double>(tool));
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
    const auto [used, is_new] = use(name, count_ + 1);
    const auto number = static_cast<double>(used);
    if (is_new) b.report(ig::diag("SIE-0232"), ig::Where::block(), name, number);
    b.set(t_, number);
    return ig::Status::changed;
  }

 private:
  struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
  };

  struct Use {
    std::int64_t number = 0;  // of the tool of the table, or in the order of use where the table has no names
    std::uint64_t run = 0;
  };

  /// The number that the name stands for, and whether this is its first use in the run.
  std::pair<std::int64_t, bool> use(std::string_view name, std::int64_t number) {
    auto found = used_.find(name);
    if (found == used_.end()) found = used_.try_emplace(std::string(name)).first;
    if (found->second.run == run_) return {found->second.number, false};
    found->second = {number, run_};
    ++count_;
    return {number, true};
  }

  std::unordered_map<std::string, Use, Hash, std::equal_to<>> used_;  // names of earlier runs stay, without effect
  std::uint64_t run_ = 1;
  std::int64_t count_ = 0;  // of names in this run
};

const ig::Register<SiemensToolName> siemens_tool_name_syntax;

}  // namespace
}  // namespace siemens
