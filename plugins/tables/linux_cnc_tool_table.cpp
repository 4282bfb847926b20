// tool.tbl of LinuxCNC: a tool a line, words in any order, a comment behind ';'. LinuxCNC manual, "Tool table format".
#include <array>
#include <cmath>

#include <isogloss/sdk.hpp>

#include "file_unit.hpp"
#include "tool_rows.hpp"

namespace tables {

using namespace ig::cnc;

namespace {

constexpr std::string_view blanks = " \t";
constexpr double largest = 1e9;  // no machine has such a tool

struct LinuxCncToolTable {
  static constexpr auto spec =
      ig::importer("LinuxCncToolTable", "The tool table of LinuxCNC.").files("*.tbl").fills("ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "TAB-0101", "'{0}' is not a word of a tool, so it is left out"),
      ig::diagnostic(IG_WARNING, "TAB-0102", "this line has no T, so it is left out"),
  };

  ig::Choice<FileUnit> unit{"unit", "unknown|mm|inch", "unknown",
                            "The unit of the machine, LINEAR_UNITS in its INI file; unknown: mm is assumed."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount tools;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      const std::string_view code = before_comment(line.text);
      if (code.empty()) continue;
      const bool is_tool = code[0] == 'T' || code[0] == 'P';
      tools.add(is_tool && code.find(code[0] == 'T' ? " P" : " T") != std::string_view::npos);
    }
    return tools.confidence(80);
  }

  void read(ig::Import& file) const {
    ToolRows rows(file);
    FileLengths lengths(file, unit);
    for (const ig::TextLine& line : file.lines())
      if (const std::string_view code = before_comment(line.text); !code.empty())
        read_tool(file, rows, lengths, line, code);
    rows.finish();
  }

 private:
  struct Word {
    char letter;
    double value;
    std::size_t begin, end;  // in the file
  };

  static std::string_view before_comment(std::string_view line) {
    line = line.substr(0, line.find(';'));
    const std::size_t first = line.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view() : line.substr(first);
  }

  static void read_tool(ig::Import& file, ToolRows& rows, FileLengths& lengths, const ig::TextLine& line,
                        std::string_view code) {
    const std::size_t offset = line.begin + static_cast<std::size_t>(code.data() - line.text.data());
    std::vector<Word> words;
    for (std::size_t i = 0; (i = code.find_first_not_of(blanks, i)) != std::string_view::npos;) {
      const std::size_t end = std::min(code.find_first_of(blanks, i), code.size());
      const ig::Decimal n = ig::read_decimal(code, i + 1);
      if (n.ok && n.end == end && std::fabs(n.value) < largest)
        words.push_back({code[i], n.value, offset + i, offset + end});
      else
        file.report(ig::diag("TAB-0101"), offset + i, offset + end, code.substr(i, end - i));
      i = end;
    }
    std::array<const Word*, 256> last{};
    for (const Word& w : words) last[static_cast<unsigned char>(w.letter)] = &w;
    const Word* const tool = last['T'];
    if (tool == nullptr) return file.report(ig::diag("TAB-0102"), offset, offset + code.size());
    if (tool->value == 0) return file.unused("tool T0", "it stands for no tool", tool->begin, tool->end);
    const std::string key = ToolRows::key_of(code.substr(tool->begin - offset, tool->end - tool->begin));
    if (key.empty())
      return file.report(ig::diag("TAB-0104"), tool->begin, tool->end,
                         code.substr(tool->begin - offset + 1, tool->end - tool->begin - 1));
    rows.begin(key, tool->begin, tool->end);
    for (const Word& w : words)
      if (last[static_cast<unsigned char>(w.letter)] == &w || w.letter == 'Z' ||
          w.letter == 'D')  // the later value wins
        read_word(file, lengths, w);
      else
        file.unused(std::string("word ") + w.letter, "the line has a later one, which is read", w.begin, w.end);
    read_comment(file, line);
  }

  static void read_word(ig::Import& file, FileLengths& lengths, const Word& w) {
    switch (w.letter) {
      case 'T': return;
      case 'Z': return file.cell("H", lengths.mm(w.value, w.begin, w.end), w.begin);
      case 'D': return file.cell("D", lengths.mm(w.value, w.begin, w.end) / 2, w.begin);
      default: file.unused(std::string("word ") + w.letter, "no table has a place for it", w.begin, w.end);
    }
  }

  static void read_comment(ig::Import& file, const ig::TextLine& line) {
    const std::size_t semicolon = line.text.find(';');
    if (semicolon == std::string_view::npos) return;
    const std::size_t begin = line.text.find_first_not_of(blanks, semicolon + 1);
    if (begin == std::string_view::npos) return;
    file.cell("Name", line.text.substr(begin, line.text.find_last_not_of(blanks) + 1 - begin), line.begin + begin);
  }
};

const ig::Register<LinuxCncToolTable> linux_cnc_tool_table;

}  // namespace
}  // namespace tables
