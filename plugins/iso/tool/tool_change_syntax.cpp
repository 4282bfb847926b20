/// T and M06: T names a tool (the magazine may turn), M06 puts the last named tool into the spindle. Both may stand in
/// one block, in either order: T acts first.
#include <cmath>
#include <string>

#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/cnc/whole_number.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

/// A tool's number and the digits after its point: T12.03.
struct NamedTool {
  std::int64_t number = 0;
  std::int64_t suffix = 0;
};

/// The fields in which a section keeps a tool; a suffix of 0 is not shown.
struct ToolField {
  explicit ToolField(const std::string& name, ig::About about = {})
      : number("ToolChange." + name + "Id", about),
        suffix("ToolChange." + name + "Suffix",
               {ig::Life::modal, "", "The extension that distinguishes tools with the same number."}) {}

  ig::Out<std::int64_t> number, suffix;

  std::optional<NamedTool> get(const ig::Block& b) const {
    const auto n = b.get(number);
    if (!n) return std::nullopt;
    return NamedTool{*n, b.get(suffix).value_or(0)};
  }
  void set(ig::Block& b, const NamedTool& tool) const {
    b.set(number, tool.number);
    if (tool.suffix != 0)
      b.set(suffix, tool.suffix);
    else if (b.has(suffix))
      b.erase(suffix);
  }
};

struct ToolChange {
  static constexpr auto spec = ig::syntax("ToolChangeSyntax", "T preselects a tool, M06 changes it.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0213", "T{0} is not a valid tool number and is not executed"),
      ig::diagnostic(IG_WARNING, "ISO-0214", "M06 without any T before it: the tool in the spindle is not known"),
  };

  enum class Identification { none, hundredths };
  ig::Choice<Identification> identification_{
      "identification", "none|hundredths", "none",
      "What may follow the point of T: nothing, or two digits that distinguish tools with the same number."};
  enum class ChangesBy { m06, t };
  ig::Choice<ChangesBy> changes_by_{
      "changes-by", "m06|t", "m06",
      "What puts a tool into the spindle: M06, or T directly (turrets, and machines without a magazine)."};
  ig::Word t_{"Parsing.T"};
  ig::Word next_word_{"Parsing.NextTool"};
  ig::Codes change_{"M06"};
  ToolField tool_{"Tool"};
  ToolField next_{"NextTool", {ig::Life::modal, "", "The tool that comes after the next change."}};
  ig::Out<bool> is_change_{"ToolChange.IsChange"};
  ig::Out<ig::Symbol> term_{"ToolChange.Term"};
  ToolField spindle_tool_{"SpindleTool"};
  ig::Name t_name_{"T"};

  ig::Status build(ig::Block& b) {
    const bool has_t = name(b, t_, tool_);
    const bool has_next = name(b, next_word_, next_);
    const bool has_m06 = b.take(change_).has_value();
    if (!has_m06 && !(has_t && changes_by_ == ChangesBy::t))
      return has_t || has_next ? ig::Status::changed : ig::Status::unchanged;
    b.set(is_change_, true);
    b.set(term_, has_m06 ? change_.name(0) : t_name_);
    if (const auto tool = tool_.get(b)) {
      spindle_tool_.set(b, *tool);
    } else {
      b.report(ig::diag("ISO-0214"), ig::Where::word(change_.id(0)));
    }
    if (const auto next = next_.get(b)) {
      tool_.set(b, *next);
      b.erase(next_.number);
      b.erase(next_.suffix);
    }
    return ig::Status::changed;
  }

 private:
  bool name(ig::Block& b, const ig::Word& word, const ToolField& field) const {
    const auto value = b.take(word);
    if (!value) return false;
    const double part = identification_ == Identification::hundredths ? 100 : 1;
    if (const auto whole = whole_number(std::round(*value * part * 1e6) / 1e6))
      field.set(b, {*whole / static_cast<std::int64_t>(part), *whole % static_cast<std::int64_t>(part)});
    else
      b.report(ig::diag("ISO-0213"), ig::Where::word(word.id()), *value);
    return true;
  }
};

const ig::Register<ToolChange> tool_change_syntax;

}  // namespace
}  // namespace iso
