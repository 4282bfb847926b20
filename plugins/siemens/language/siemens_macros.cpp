// Macros of the machine, from SMAC.DEF, MMAC.DEF and UMAC.DEF or by hand: DEFINE NAME AS TEXT for all programs. Manual
// Job planning, "Macro technique (DEFINE ... AS)".
#include <algorithm>

#include <isogloss/rows.hpp>

#include "flow/flow_words.hpp"
#include "language/macro_table.hpp"

namespace siemens {

using namespace ig::cnc;

std::string macro_fault(std::string_view name, std::string_view text) {
  const bool is_name = !name.empty() && is_name_start(name[0]) && skip_name(name, 0) == name.size();
  if (!is_name || name.size() < 2) return "its name is not a word of two or more characters, as OPEN_DOOR or M20 is";
  for (const std::string_view word : {"DEF", "REDEF", "DEFINE", "PROC", "EXTERN", "RET"})
    if (name == word) return "its name is a word of the language, which is read first";
  if (flow_word(name) != FlowWord::none) return "its name is a word of the language, which is read first";
  if (trim(text).empty()) return "its text is empty";
  if (std::count(text.begin(), text.end(), '"') % 2 != 0) return "a quotation mark in its text is not closed";
  if (statement_end(text, 0) < text.size()) return "its text has a comment or a line end";
  return {};
}

namespace {

struct SiemensMacros {
  static constexpr auto spec = ig::dependency("SiemensMacros", "Macros of the machine: names that stand for texts.")
                                   .rows("Macro", "name")
                                   .provides(macro_service);

  ig::Column text{"Text", nullptr, "", {}, "What the control reads in place of the name: M24, or G0 SUPA Z0.", true};
  ig::Table table;
  ig::RowNames names;
  MacroTable macros;

  SiemensMacros() {
    for (const std::string& name : names) {
      first_.emplace(upper(name), name);
      if (row_fault(name).empty()) macros[upper(name)] = {std::string(trim(table.text(name, text))), name};
    }
  }

  const void* service(std::string_view id) const { return id == macro_service ? &macros : nullptr; }

  std::string row_fault(std::string_view row) const {
    const std::string name = upper(row);
    if (const auto first = first_.find(name); first != first_.end() && first->second != row)
      return "the row " + first->second + " is the same macro";
    return macro_fault(name, table.text(row, text));
  }

 private:
  std::unordered_map<std::string, std::string> first_;  // the rows as the user named them
};

const ig::Register<SiemensMacros> siemens_macros;

}  // namespace
}  // namespace siemens
