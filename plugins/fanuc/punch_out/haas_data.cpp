// Settings, offsets, parameters and variables that a Haas control of the classic kind sends over its serial port:
// running numbers N with whole numbers V. Which register a number is, and the unit of its value, depend on the version
// of the software; the file names neither, so nothing of it is read.
#include <utility>

#include <isogloss/sdk.hpp>

#include "punch_out/punched_block.hpp"

namespace fanuc {
namespace {

struct HaasData {
  static constexpr auto spec =
      ig::importer("HaasData", "Numbered data of a Haas control before the next generation; not read.")
          .files("*.ofs *.set *.par")
          .fills("HaasSettings", "ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0240",
                     "the meaning of these numbers depends on the software of the Haas, so nothing is read"),
  };

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount entries;
    PunchedBlock block;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      block.read(line);
      if (block.is_empty()) continue;
      const std::vector<PunchedWord>& words = block.words();
      const bool is_end = words.size() == 1 && words[0].is('N', 9999);
      const bool is_register = words.size() == 2 && words[0].letter == 'N' && words[1].letter == 'V';
      entries.add(block.is_sound() && (is_end || is_register));
    }
    return entries.confidence(85);
  }

  void read(ig::Import& file) const {
    bool is_first = true;
    PunchedBlock block;
    for (const ig::TextLine& line : file.lines()) {
      block.read(line);
      if (block.is_empty()) continue;
      if (std::exchange(is_first, false)) file.report(ig::diag("FAN-0240"), block.begin(), block.end());
      file.unused("data number", "which register it is depends on the software", block.begin(), block.end());
    }
  }
};

const ig::Register<HaasData> haas_data;

}  // namespace
}  // namespace fanuc
