/// T and M06: T names a tool (the magazine may turn), M06 puts the tool named last into the spindle. Both may stand in
/// one block, in either order: T counts first.
#include "modal_group.hpp"
#include "whole_number.hpp"

namespace iso {
namespace {

struct ToolChange {
  static constexpr auto spec = ig::syntax("ToolChangeSyntax", "T preselects a tool, M06 changes it.");

  ig::Word t_{"Parsing.T"};
  ig::Codes change_{"M06"};
  ig::Out<std::int64_t> tool_{"ToolChange.ToolId"};
  ig::Out<bool> is_change_{"ToolChange.IsChange"};
  ig::Out<ig::Symbol> term_{"ToolChange.Term"};
  ig::Out<std::int64_t> spindle_tool_{"ToolChange.SpindleToolId"};

  ig::Status build(ig::Block& b) {
    const auto t = b.take(t_);
    if (t) {
      if (const auto id = whole_number(*t)) {
        b.set(tool_, *id);
      } else {
        b.report(diag("ISO-0213"), ig::Where::word(t_.id()), *t);
      }
    }
    if (!b.take(change_)) return t ? ig::Status::changed : ig::Status::unchanged;
    b.set(is_change_, true);
    b.set(term_, change_.name(0));
    if (const auto tool = b.get(tool_)) {
      b.set(spindle_tool_, *tool);
    } else {
      b.report(diag("ISO-0214"), ig::Where::word(change_.id(0)));
    }
    return ig::Status::changed;
  }
};

const ig::Register<ToolChange> registered;

}  // namespace
}  // namespace iso
