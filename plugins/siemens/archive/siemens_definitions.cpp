// Definitions of global user data (GUD) and macros: SGUD.DEF, MGUD.DEF, UGUD.DEF, GUD4.DEF to GUD9.DEF, UMAC.DEF and so
// on. Manual Job planning, "Definition of global user data (GUD)".
#include <isogloss/sdk.hpp>

#include "archive/variable_rows.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensDefinitions {
  static constexpr auto spec =
      ig::importer("SiemensDefinitions", "Definition files of a SINUMERIK: global user data (GUD) and macros.")
          .files("*.def *.gud")
          .fills("SiemensVariables", "SiemensMacros")
          .initial_values();

  static unsigned recognise(std::string_view text, std::string_view) {
    std::size_t definitions = 0, macros = 0, others = 0;
    bool has_head = false;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      const std::string_view code = code_of(line.text);
      if (code.empty() || is_file_end(code)) continue;
      if (const auto head = read_head(line.text)) {
        if (head->extension != "DEF" && head->extension != "GUD") return 0;
        has_head = true;
        continue;
      }
      Cursor cursor(code);
      const std::string first = upper(cursor.word()), second = upper(cursor.word());
      if (first == "CHANDATA") return 0;  // values stand beside the definitions: SiemensArchive reads both
      if (first == "DEF" && (second == "NCK" || second == "CHAN"))
        ++definitions;
      else if (first == "DEFINE")
        ++macros;
      else
        ++others;
    }
    if (definitions > 0 || has_head) return definitions + macros > 0 && others <= definitions + macros ? 95 : 0;
    return macros > 0 && others * 4 <= macros ? 90 : 0;  // programs begin with some DEFINE, too
  }

  void read(ig::Import& file) const {
    FlowFilter flow;
    VariableRows rows;
    for (const ig::TextLine& line : file.lines()) {
      if (read_head(line.text)) {
        flow.restart();
        continue;
      }
      const std::string_view code = code_of(line.text);
      if (code.empty() || is_file_end(code) || flow.leaves_out(file, code) || rows.define(file, code)) continue;
      const std::size_t begin = place_in(file, code);
      file.report(ig::diag("SIE-0340"), begin, begin + code.size(), shown(code));
    }
    rows.give(file);
  }
};

const ig::Register<SiemensDefinitions> siemens_definitions;

}  // namespace
}  // namespace siemens
