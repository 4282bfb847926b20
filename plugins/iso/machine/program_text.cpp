// How a control writes what the host wants to have written: the motions of a run as plain blocks, and the blocks that
// restore a state. Templates as data, so that neither the host nor this file holds a code of a program.
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct ProgramText {
  static constexpr auto spec =
      ig::dependency("ProgramText", "How the control writes motions, and blocks that restore a state.")
          .rows("Block", "name")
          .provides("isogloss.program-text/1");

  ig::Column when{"when", nullptr, "", {}, "Conditions on fields of the state, separated by blanks: Unit.System=Inch.",
                  true};
  ig::Column text{"text", nullptr, "", {}, "The block: {X} stands for a value, [ X{X}] is left out without one.", true};
  ig::Table table;

  /// The host reads the rows themselves; the answer only tells that they are there.
  const void* service(std::string_view id) const { return id == "isogloss.program-text/1" ? &answer : nullptr; }

  std::string row_fault(std::string_view row) const {
    const std::string_view written = table.text(row, text);
    if (written.empty()) return "text is missing: text=\"G00[ X{X}]\"";
    char open = '\0';
    bool is_optional = false;
    for (const char c : written) {
      const bool is_wrong = (c == '{' && open == '{') || (c == '}' && open != '{') || (c == '[' && is_optional) ||
                            (c == ']' && (!is_optional || open == '{'));
      if (is_wrong) return "text has a " + std::string(1, c) + " that does not belong there";
      if (c == '{') open = '{';
      if (c == '}') open = '\0';
      if (c == '[') is_optional = true;
      if (c == ']') is_optional = false;
    }
    return open == '{' || is_optional ? "text lacks the closing " + std::string(open == '{' ? "}" : "]") : "";
  }

 private:
  struct Answer {
    std::uint32_t struct_size = sizeof(Answer);
    std::uint32_t reserved = 0;
  };
  Answer answer;
};

const ig::Register<ProgramText> program_text;

}  // namespace
}  // namespace iso
