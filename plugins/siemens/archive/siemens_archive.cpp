// Text archives of active data: tool offsets (TOA), settable frames (UFR), R parameters (RPA), values of global user
// data (GUD), alone or together. Binary archives (.ARC that begin with @@MMC) have no published form.

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "archive/archive_reader.hpp"
#include "archive/written_file.hpp"
#include "frames/settable_frames.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

enum class ArchiveUnit { file, mm, inch };

bool is_binary(std::string_view text) { return text.starts_with("@@MMC"); }

struct SiemensArchive {
  static constexpr auto spec =
      ig::importer("SiemensArchive", "Text archives of SINUMERIK data: tools, frames, R parameters, user data.")
          .files("*.arc *.ini *.toa *.ufr *.rpa *.gud *.tea")
          .fills("ToolOffsetTable", "SiemensCoordinateTable", "SiemensVariables", "SiemensMacros");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0343", "'{0}' is not read as a frame, so {1} stays as it was before this line"),
      ig::diagnostic(IG_WARNING, "SIE-0344",
                     "{0} has an index that is not a number of the table, so the line is left out"),
      ig::diagnostic(IG_WARNING, "SIE-0345",
                     "{0} is rotated, scaled or mirrored in a form that no row can hold, so only its shift is read"),
      ig::diagnostic(IG_WARNING, "SIE-0346",
                     "{0} is a further base frame with a shift, so BASE is the sum of all: check that all are active"),
      ig::diagnostic(IG_WARNING, "SIE-0347",
                     "the system frame {0} is not zero and is not executed: positions may differ by it"),
      ig::diagnostic(IG_WARNING, "SIE-0348",
                     "tool {0} is a turning tool (type {1}), so the lengths of all such tools are left out"),
      ig::diagnostic(IG_ERROR, "SIE-0353",
                     "this is a binary archive, which is not read: save the data as a text archive (punched tape)"),
      ig::diagnostic(IG_WARNING, "SIE-0356",
                     "row {0} belongs to another tool, so tool {1}, edge {2} is left out: check the option edge-step"),
      ig::diagnostic(IG_WARNING, "SIE-0357",
                     "the archive does not tell its unit, so its lengths are read as mm: give unit=mm or unit=inch"),
  };

  ig::Choice<ArchiveUnit> unit{"unit", "file|mm|inch", "file",
                               "The basic system of the machine; file: as the file tells it, else mm."};
  ig::IntegerOption channel{"channel", "1", {1, 99}, "The channel whose data are read."};
  ig::TextOption axes{"axes", "", "The table's letters of other axes of the machine: X1=X, Z1=Z."};
  ig::IntegerOption edge_step{
      "edge-step", "0", {0, 100'000}, "Rows between two edges of a tool; 0: edge 2 of tool 5 is row 5.2."};

  static unsigned recognise(std::string_view text, std::string_view) {
    if (is_binary(text)) return 100;
    std::size_t good = 0, bad = 0, system = 0, r = 0;
    bool has_mark = false, is_read = true;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      if (const auto head = read_head(line.text)) {
        is_read = head->holds_data();
        has_mark = has_mark || (is_read && head->extension != "DEF");
        continue;
      }
      const std::string_view code = code_of(line.text);
      if (!is_read || code.empty() || is_file_end(code)) continue;
      Cursor cursor(code);
      const std::string word = upper(Cursor(code).word());
      const std::optional<Assignment> a = read_assignment(cursor);
      has_mark = has_mark || word == "CHANDATA";
      system += a && a->name[0] == '$';
      r += a && cursor.is_at_end() && is_r_name(a->name) && number_of(a->value);
      ++(word == "CHANDATA" || word == "DEF" || word == "DEFINE" || word == "METRIC" || word == "INCH" || a ? good
                                                                                                            : bad);
    }
    if (has_mark) return bad <= good ? 95 : 0;
    if (system > 0) return bad * 10 <= good ? 90 : 0;
    return r > 0 && r == good && bad == 0 ? 40 : 0;
  }

  void read(ig::Import& file) const {
    if (is_binary(file.text())) return file.report(ig::diag("SIE-0353"), 0, file.text().size());
    ArchiveReader reader(file, channel, std::string(axes.text()));
    reader.read();
    const bool is_inch = unit == ArchiveUnit::inch || (unit == ArchiveUnit::file && reader.is_inch().value_or(false));
    ArchiveLengths lengths(file, is_inch ? mm_per_inch : 1, unit == ArchiveUnit::file && !reader.is_inch());
    reader.give(lengths, edge_step);
  }

  void write(ig::Export& out) const {
    const double mm = unit == ArchiveUnit::inch ? mm_per_inch : 1;
    write_tools(out, mm);
    write_frames(out, mm);
    write_variables(out);
  }

 private:
  void write_tools(ig::Export& out, double mm) const {
    static constexpr const char* table = "ToolOffsetTable";
    WrittenFile tools(out, "TO1_TOA_INI");
    for (std::uint32_t i = 0; i < out.rows(table); ++i) {
      const std::string_view row = out.key(table, i);
      const std::size_t point = row.find('.');
      const std::int64_t id = static_cast<std::int64_t>(number_of(row.substr(0, point)).value_or(0));
      std::int64_t tool = id, edge = 1;
      if (point != std::string_view::npos)
        edge = static_cast<std::int64_t>(number_of(row.substr(point + 1)).value_or(1));
      if (edge_step > 0) tool = (id - 1) % edge_step + 1, edge = (id - 1) / edge_step + 1;
      if (edge > most_edges) {
        out.unused("edges above 99", "the control has no such edges: check the option edge-step");
        continue;
      }
      const std::string t = std::to_string(tool), place = '[' + t + ',' + std::to_string(edge) + "]=";
      const std::string_view name = out.cell(table, i, "Name");
      if (!name.empty() && (edge != 1 || name.find('"') != std::string_view::npos))
        out.unused("names of further edges, and with a quotation mark",
                   "a tool has one name, as a text in quotation marks");
      else if (!name.empty())
        tools.line("$TC_TP2[" + t + "]=\"" + std::string(name) + '"');
      const auto line = [&](const char* variable, const char* column, double unit_mm) {
        const std::string value = written(out.cell(table, i, column), unit_mm);
        if (!value.empty()) tools.line(variable + place + value);
        return !value.empty();
      };
      const double type = number_of(out.cell(table, i, "Type")).value_or(-1);
      const bool is_of_control = type >= 100 && type <= 999 && type == std::floor(type);
      if (is_of_control) tools.line("$TC_DP1" + place + std::to_string(static_cast<int>(type)));
      if (type >= 0 && !is_of_control) out.unused("types of another control", "the control has types from 100 to 999");
      const double radius_scale = is_of_control && type >= 700 && type < 710 ? mm / 2 : mm;  // a saw has its diameter
      // The table has the length together with the adapter.
      if (line("$TC_DP3", "H", mm)) tools.line("$TC_DP21" + place + '0');
      line("$TC_DP6", "D", radius_scale);
      line("$TC_DP12", "HWear", mm);
      line("$TC_DP15", "DWear", radius_scale);
      line("$TC_DP7", "CornerRadius", mm);
      line("$TC_DP16", "CornerRadiusWear", mm);
      for (const char* const column :
           {"TipAngle", "Teeth", "MaximumSpeed", "CuttingLength", "PlungeAngle", "Life", "LifeAtCall", "UsedLife"})
        if (!out.cell(table, i, column).empty())
          out.unused(std::string("column ") + column, "which $TC_DP holds it depends on the version of the control");
    }
  }

  static void write_frames(ig::Export& out, double mm) {
    static constexpr const char* table = "SiemensCoordinateTable";
    WrittenFile frames(out, "CH1_UFR_INI");
    for (std::uint32_t i = 0; i < out.rows(table); ++i) {
      const std::string_view row = out.key(table, i);
      std::string shift, value = "CTRANS(";
      for (const char* axis : {"X", "Y", "Z", "A", "B", "C"})
        if (const std::string cell = written(out.cell(table, i, axis), *axis < 'X' ? 1 : mm); !cell.empty())
          shift += (shift.empty() ? "" : ",") + std::string(axis) + ',' + cell;
      value += shift + ')' + written_links(out, i, mm);
      std::string frame = "$P_CHBFR[0]";
      if (const std::optional<double> code = number_of(row.substr(!row.empty())); code && row != "BASE")
        frame = "$P_UIFR[" + std::to_string(settable_number(static_cast<std::int64_t>(*code))) + ']';
      frames.line(frame + '=' + value);
    }
  }

  /// The links after CTRANS, for columns that the row names.
  static std::string written_links(ig::Export& out, std::uint32_t row, double mm) {
    std::string links;
    const auto link = [&](const char* name, char column, double step, bool names_axes_only) {
      std::string arguments;
      for (const char axis : {'X', 'Y', 'Z'}) {
        const std::string cell = written(out.cell("SiemensCoordinateTable", row, std::string{column, axis}), step);
        if (cell.empty() || (names_axes_only && cell == "0")) continue;
        arguments += (arguments.empty() ? "" : ",") + std::string(1, axis) + (names_axes_only ? "" : ',' + cell);
      }
      if (!arguments.empty()) links += std::string(":") + name + '(' + arguments + ')';
    };
    link("CFINE", 'F', mm, false);
    link("CROT", 'R', 1, false);
    link("CSCALE", 'S', 1, false);
    link("CMIRROR", 'M', 1, true);
    return links;
  }
};

const ig::Register<SiemensArchive> siemens_archive;

}  // namespace
}  // namespace siemens
