// The work and tool offsets that a Fanuc control puts out as G10 blocks (EXT_WKZ.TXT, TOOLOFST.TXT). The file is
// formally a program; only its G10 blocks are read, and nothing of it is executed. Fanuc operator's manual,
// "Programmable data input (G10)".
#include <cmath>
#include <utility>

#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/sdk.hpp>

#include "punch_out/punched_block.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class Memory { file, a, b, c };
enum class WithoutPoint { increments, units };
enum class Increment { is_a, is_b, is_c };

struct FanucOffsets {
  static constexpr const char *tools = "ToolOffsetTable", *work = "IsoCoordinateTable";
  static constexpr auto spec =
      ig::importer("FanucOffsets", "Work and tool offsets that a Fanuc control puts out as G10.")
          .files("TOOLOFST.* EXT_WKZ.* *.ofs")
          .fills(work, tools);
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0231",
                     "this G10 has no P that names an offset of the control, so it is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0232",
                     "G10 under G91 adds to a value that is not in the file, so the block is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0233",
                     "the file has lengths (L10) but no radii (L12): with offset memory B give the option memory=B"),
  };

  ig::Choice<OffsetUnit> unit{
      "unit", "unknown|mm|inch", "unknown",
      "The unit of the control when it wrote the file without G20, G21; unknown: mm is assumed."};
  ig::Choice<ToolRadius> tool_radius{"tool-radius", "radius|diameter", "radius",
                                     "What cutter offsets are on this control: parameter 5004 bit 2."};
  ig::Choice<Memory> memory{"memory", "file|A|B|C", "file",
                            "Tool offset memory; file: A where the file has neither L10 nor L12, otherwise C."};
  ig::Choice<WithoutPoint> without_point{"without-point", "increments|units", "increments",
                                         "What a value without a decimal point counts: parameter 3401 bit 0."};
  ig::Choice<Increment> increment{"increment", "IS-A|IS-B|IS-C", "IS-B", "The increment system of the control."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount offsets;
    PunchedBlock block;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      block.read(line);
      if (block.is_empty() || (block.is_sound() && !is_offset(block) && block.is_frame())) continue;
      offsets.add(block.is_sound() && is_offset(block));
    }
    return offsets.confidence(80);
  }

  void read(ig::Import& file) const {
    State state{file, Memory::c, unit_of_file()};
    find_memory(state);
    PunchedBlock block;
    for (const ig::TextLine& line : file.lines()) {
      block.read(line);
      if (!block.is_empty()) read_block(state, block);
    }
    // All importers raise the size alike, so that the tables of two files agree.
    if (state.highest > most_shipped_offsets)
      file.option(tools, "size", std::to_string(most_offsets), file.text().size());
  }

  void write(ig::Export& out) const {
    out.write(unit == OffsetUnit::inch ? "%\nG90\nG20\n" : "%\nG90\nG21\n");
    write_work_offsets(out);
    write_tool_offsets(out);
    out.write("%\n");
  }

 private:
  static constexpr std::int64_t most_shipped_offsets = 400, most_offsets = 99'999;

  struct State {
    ig::Import& file;
    Memory memory;
    PunchedUnit unit;
    bool is_absolute = true, is_block_list = false, may_be_b = false;
    std::int64_t highest = 0;
  };

  PunchedUnit unit_of_file() const {
    return {unit == OffsetUnit::inch, without_point == WithoutPoint::increments,
            increment == Increment::is_a   ? 100.
            : increment == Increment::is_b ? 1000.
                                           : 10000.,
            unit == OffsetUnit::unknown};
  }

  /// G10 of a variable has L85.
  static bool is_offset(const PunchedBlock& block) {
    return block.has('G', 10) && (l_of(block) == 0 ? block.find('R') != nullptr : l_of(block) != 85);
  }
  /// L of a G10; 0 where it has none.
  static std::int64_t l_of(const PunchedBlock& block) {
    const PunchedWord* const l = block.find('L');
    return l == nullptr ? 0 : l->whole().value_or(0);
  }

  /// A control with memory A writes neither lengths nor radii of their own; one with B writes no radii.
  void find_memory(State& state) const {
    bool has_length = false, has_radius = false;
    PunchedBlock block;
    for (const ig::TextLine& line : state.file.lines()) {
      block.read(line);
      if (!block.has('G', 10)) continue;
      has_length = has_length || l_of(block) == 10;
      has_radius = has_radius || l_of(block) == 12 || l_of(block) == 13;
    }
    state.memory = memory != Memory::file ? memory : has_length || has_radius ? Memory::c : Memory::a;
    state.may_be_b = memory == Memory::file && has_length && !has_radius;
  }

  void read_block(State& state, const PunchedBlock& block) const {
    if (!block.is_sound()) return block.report_fault(state.file);
    for (const PunchedWord& w : block.words()) {
      if (w.letter != 'G') continue;
      if (w.is('G', 90) || w.is('G', 91)) state.is_absolute = w.is('G', 90);
      if (w.is('G', 11)) state.is_block_list = false;
      if (!w.is('G', 20) && !w.is('G', 21)) continue;
      state.unit.is_inch = w.is('G', 20);
      state.unit.is_assumed = false;
    }
    const auto unused = [&](std::string_view what, std::string_view why) {
      state.file.unused(what, why, block.begin(), block.end());
    };
    if (!block.has('G', 10)) {
      if (state.is_block_list) return unused("block of a list up to G11", "no table has a place for it");
      if (!block.is_frame()) unused("block without G10", "blocks of a program are not executed");
      return;
    }
    const std::int64_t l = l_of(block);
    state.is_block_list = l == 3 || l >= 50;
    const bool is_work = l == 2 || l == 20, is_tool = l <= 1 || (l >= 10 && l <= 13);
    if (!is_work && !is_tool) return unused("G10 L" + std::to_string(l), "no table has a place for it");
    if (!state.is_absolute) return state.file.report(ig::diag("FAN-0232"), block.begin(), block.end());
    block.report_repeated(state.file);
    if (is_work) return read_work_offset(state, block, l);
    read_tool_offset(state, block, l);
  }

  static void read_work_offset(State& state, const PunchedBlock& block, std::int64_t l) {
    const PunchedWord* const p = block.find('P');
    const WorkOffsetId id = p == nullptr ? WorkOffsetId::basic(-1)
                            : l == 2     ? WorkOffsetId::basic(p->number.value)
                                         : WorkOffsetId::additional(p->number.value);
    if (id.text().empty() || (l == 20 && p->number.value > most_offsets))
      return state.file.report(ig::diag("FAN-0231"), block.begin(), block.end());
    for (const PunchedWord& w : block.words()) {
      if (std::string_view("GLPN").find(w.letter) != std::string_view::npos) continue;
      if (std::string_view("XYZABC").find(w.letter) == std::string_view::npos) {
        state.file.unused(std::string("word ") + w.letter, "no table has a place for it", w.begin, w.end);
        continue;
      }
      const double value = is_rotary(w.letter) ? state.unit.degrees(w.number) : state.unit.mm(state.file, w);
      put_offset(state.file, id.text(), w.letter, value, w);
    }
  }

  void read_tool_offset(State& state, const PunchedBlock& block, std::int64_t l) const {
    const PunchedWord *const p = block.find('P'), *const r = block.find('R');
    if (r == nullptr || block.find('X') != nullptr || block.find('Z') != nullptr)
      return state.file.unused("tool offset of a lathe", "no table has a place for it", block.begin(), block.end());
    for (const PunchedWord& w : block.words())
      if (std::string_view("GLPRN").find(w.letter) == std::string_view::npos)
        state.file.unused(std::string("word ") + w.letter, "no table has a place for it", w.begin, w.end);
    const std::int64_t row = p == nullptr ? 0 : p->whole().value_or(0);
    if (row < 1 || row > most_offsets) return state.file.report(ig::diag("FAN-0231"), block.begin(), block.end());
    state.highest = std::max(state.highest, row);
    if (l == 10 && std::exchange(state.may_be_b, false))
      state.file.report(ig::diag("FAN-0233"), block.begin(), block.end());
    const double mm = state.unit.mm(state.file, *r), radius = mm / (tool_radius == ToolRadius::diameter ? 2 : 1);
    state.file.row(tools, row, block.begin());
    const bool is_wear = state.memory != Memory::a && (l == 11 || l == 13);
    const bool is_length = l <= 11, is_radius = l >= 12 || state.memory != Memory::c;
    if (is_length) state.file.cell(is_wear ? "HWear" : "H", mm, block.begin());
    if (is_radius) state.file.cell(is_wear ? "DWear" : "D", radius, block.begin());
  }

  // ---- writing

  static std::string value_of(std::string_view cell, double per_unit) {
    const ig::Decimal n = ig::read_decimal(cell, 0);
    if (!n.ok || n.end != cell.size()) return {};
    constexpr double steps = 1e6;  // finer than any control
    return punched_number(std::round(n.value / per_unit * steps) / steps);
  }
  double per_unit() const { return unit == OffsetUnit::inch ? mm_per_inch : 1; }

  /// "L2P1" of G54, "L20P7" of G54.1P7; empty where G10 has no such offset.
  static std::string place_of(std::string_view id) {
    if (id == "EXT") return "L2P0";
    if (id.starts_with("G54.1P")) return "L20P" + std::string(id.substr(6));
    const bool is_basic = id.size() == 3 && id.starts_with("G5") && id[2] >= '4' && id[2] <= '9';
    return is_basic ? "L2P" + std::to_string(id[2] - '3') : std::string();
  }

  void write_work_offsets(ig::Export& out) const {
    for (std::uint32_t row = 0; row < out.rows(work); ++row) {
      const std::string place = place_of(out.key(work, row));
      if (place.empty()) {
        out.unused("row " + std::string(out.key(work, row)), "G10 has no such work offset");
        continue;
      }
      std::string words;
      for (const char axis : std::string_view("XYZABC"))
        if (const std::string value = value_of(out.cell(work, row, {&axis, 1}), is_rotary(axis) ? 1 : per_unit());
            !value.empty())
          words += axis + value;
      if (!words.empty()) out.write("G10" + place + words + "\n");
    }
  }

  /// Memory C, which has a place for every column.
  void write_tool_offsets(ig::Export& out) const {
    struct Column {
      const char *name, *l;
      bool is_radius;
    };
    const double per_radius = per_unit() / (tool_radius == ToolRadius::diameter ? 2 : 1);
    for (std::uint32_t row = 0; row < out.rows(tools); ++row) {
      const std::string_view id = out.key(tools, row);
      if (id.find('.') != std::string_view::npos) {
        out.unused("rows with an index", "a Fanuc has one length and radius for each number");
        continue;
      }
      for (const Column& c :
           {Column{"H", "L10", false}, {"HWear", "L11", false}, {"D", "L12", true}, {"DWear", "L13", true}})
        if (const std::string value = value_of(out.cell(tools, row, c.name), c.is_radius ? per_radius : per_unit());
            !value.empty())
          out.write(std::string("G10") + c.l + "P" + std::string(id) + "R" + value + "\n");
    }
  }
};

const ig::Register<FanucOffsets> fanuc_offsets;

}  // namespace
}  // namespace fanuc
