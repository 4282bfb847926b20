/// System variables whose value is in the document or in a table: the position, the tool and its offsets, the settable
/// frames, the codes in force. Values that a program writes to frames and offsets go into the tables of this run.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

/// The result of an assignment to a system variable.
enum class Written { no, taken, without_effect };

class SystemData {
 public:
  /// The parts of $P_UIFR[1,X,TR]: $P_UIFR, 1, X, TR.
  struct Name {
    std::string_view base;
    std::array<std::string_view, 3> index;
    std::size_t count = 0;

    explicit Name(std::string_view text) : base(text.substr(0, text.find('['))) {
      if (base.size() == text.size()) return;
      text = text.substr(base.size() + 1, text.size() - base.size() - 2);
      for (;;) {
        const std::size_t end = std::min(text.find(','), text.size());
        if (count < index.size()) index[count] = text.substr(0, end);
        ++count;
        if (end == text.size()) return;
        text.remove_prefix(end + 1);
      }
    }
    std::optional<std::int64_t> number(std::size_t i) const {
      std::int64_t n = 0;
      if (i >= std::min(count, index.size())) return std::nullopt;
      const auto [end, error] = std::from_chars(index[i].data(), index[i].data() + index[i].size(), n);
      return error == std::errc{} && end == index[i].data() + index[i].size() ? std::optional(n) : std::nullopt;
    }
  };

  std::optional<double> read(const ig::Block& b, std::string_view text) const {
    const Name name(text);
    if (const auto p = position(b, name)) return p;
    if (const auto frame = frame_of(b, name)) return part_of_frame(b, name, *frame);
    if (name.base == "$P_PFRAME") return programmed(b, name);
    if (const auto row = offset_row(b, name)) return offset(b, *row, column_of(name));
    if (name.base == "$P_GG" && name.count == 1) return group(b, name.number(0).value_or(0));
    if (name.base == "$P_TOOLL" && name.count == 1)  // 1 lies along the tool; a milling tool has 0 for 2 and 3
      return name.index[0] == "1" ? b.get_or(length_, 0.0) / unit(b) : 0.0;
    return plain(b, name.base);
  }

  /// The code that puts the frame $P_UIFR[n] in force.
  static std::optional<std::uint32_t> code_of(std::string_view text) {
    const Name name(text);
    const auto n = name.number(0);
    if (name.base != "$P_UIFR" || name.count != 1 || !n || *n < 0 || *n > 99) return std::nullopt;
    return static_cast<std::uint32_t>(*n == 0 ? 500 : *n < 5 ? 53 + *n : 500 + *n);
  }
  /// True for variables that write() may accept.
  static bool takes(std::string_view text) {
    const Name name(text);
    return name.base == "$P_UIFR" || name.base == "$P_CHBFR" || name.base == "$P_UBFR" ||
           (name.base != "$P_AD" && column_of(name));
  }
  Written write(const ig::Block& b, std::string_view text, std::optional<double> value) const {
    const Name name(text);
    if (const auto frame = frame_of(b, name); frame && name.base != "$P_IFRAME")
      return value ? write_frame(b, name, *frame, *value) : Written::no;
    if (name.base == "$P_AD") return Written::no;
    if (const auto row = offset_row(b, name); row && value && tools_) {
      const double mm = *value * unit(b);
      const bool done = std::fabs(mm) < 1e9 && tools_->set(tools_->self, *row, *column_of(name), mm) != 0;
      return done ? Written::taken : Written::no;
    }
    return moves_nothing(name.base) ? Written::without_effect : Written::no;
  }

  /// $P_UIFR[n] and similar frames as a whole: X Y Z A B C.
  using Shift = std::array<double, 6>;
  bool write_shift(const ig::Block& b, std::string_view text, const Shift& shift) const {
    const Name name(text);
    const auto frame = frame_of(b, name);
    if (!frame || name.base == "$P_IFRAME" || name.count > (name.base == "$P_UBFR" ? 0u : 1u) || !offsets_)
      return false;
    double mm[3], degrees[3];
    for (std::size_t i = 0; i < 3; ++i) {
      mm[i] = shift[i] * unit(b);
      degrees[i] = shift[3 + i];
      if (!(std::fabs(mm[i]) < 1e9 && std::fabs(degrees[i]) < 1e9)) return false;
    }
    offsets_->set_rotary(offsets_->self, ig::to_text(*frame), degrees);
    return offsets_->set(offsets_->self, ig::to_text(*frame), mm) != 0;
  }
  std::optional<Shift> shift_of(const ig::Block& b, std::string_view text) const {
    double mm[3], degrees[3];
    const auto frame = frame_of(b, Name(text));
    if (!frame || !offsets_ || offsets_->get(offsets_->self, ig::to_text(*frame), mm) == 0 ||
        offsets_->get_rotary(offsets_->self, ig::to_text(*frame), degrees) == 0)
      return std::nullopt;
    return Shift{mm[0] / unit(b), mm[1] / unit(b), mm[2] / unit(b), degrees[0], degrees[1], degrees[2]};
  }

 private:
  static constexpr std::int64_t edge_step = 100;

  /// mm per unit of the system's lengths, which are inches under G700.
  double unit(const ig::Block& b) const { return b.is(unit_term_, g700_) ? mm_per_inch : 1; }
  static std::size_t axis_of(std::string_view name) {
    return name.size() == 1 ? std::string_view("XYZABC").find(name[0]) : std::string_view::npos;
  }

  /// $AA_IW[X], $AA_IM[X], $P_EP[X]: the position at the end of the block before.
  std::optional<double> position(const ig::Block& b, const Name& name) const {
    const bool of_machine = name.base == "$AA_IM";
    if (!of_machine && name.base != "$AA_IW" && name.base != "$P_EP" && name.base != "$AA_WCS") return std::nullopt;
    const std::size_t axis = name.count == 1 ? axis_of(name.index[0]) : std::string_view::npos;
    if (axis == std::string_view::npos) return std::nullopt;
    const auto at = b.get(of_machine || axis > 2 ? machine_[axis] : program_[axis]);
    return of_machine || axis < 3 || !at ? at : *at - turned_.get(b).value[axis - 3];
  }

  // ---- Frames

  static std::string settable(std::int64_t n) {
    return n == 0 ? "G500" : n < 5 ? "G" + std::to_string(53 + n) : "G" + std::to_string(500 + n);
  }
  std::optional<std::string> frame_of(const ig::Block& b, const Name& name) const {
    const bool is_numbered = name.base == "$P_UIFR" || name.base == "$P_CHBFR";
    const auto n = name.number(0);
    if (is_numbered && (!n || *n < 0 || *n > 99)) return std::nullopt;
    if (name.base == "$P_UIFR") return settable(*n);
    if (name.base == "$P_IFRAME") return std::string(b.text(b.get_or(offset_id_, ig::Symbol{})));
    if (name.base == "$P_UBFR" || (name.base == "$P_CHBFR" && *n == 0)) return "BASE";
    return std::nullopt;
  }
  static std::pair<std::string_view, std::string_view> axis_and_part(const Name& name) {
    const std::size_t first = name.base == "$P_UIFR" || name.base == "$P_CHBFR" ? 1 : 0;
    if (name.count != first + 2) return {};
    return {name.index[first], name.index[first + 1]};
  }
  std::optional<double> part_of_frame(const ig::Block& b, const Name& name, const std::string& frame) const {
    const auto [axis, part] = axis_and_part(name);
    const std::size_t i = axis_of(axis);
    if (i == std::string_view::npos || !offsets_) return std::nullopt;
    if (part == "SC") return 1;
    if (part == "FI" || part == "MI" || part == "RT") return 0;
    double v[3] = {0, 0, 0};
    if (part != "TR") return std::nullopt;
    if (i > 2) return offsets_->get_rotary(offsets_->self, ig::to_text(frame), v) != 0 ? std::optional(v[i - 3]) : 0.0;
    return offsets_->get(offsets_->self, ig::to_text(frame), v) != 0 ? std::optional(v[i] / unit(b)) : 0.0;
  }
  Written write_frame(const ig::Block& b, const Name& name, const std::string& frame, double value) const {
    const auto [axis, part] = axis_and_part(name);
    const std::size_t i = axis_of(axis);
    if (i == std::string_view::npos || !offsets_) return Written::no;
    if (part != "TR") return value == (part == "SC" ? 1 : 0) ? Written::without_effect : Written::no;
    double v[3] = {0, 0, 0};
    const ig_text id = ig::to_text(frame);
    const double own = i > 2 ? value : value * unit(b);
    if (!(std::fabs(own) < 1e9)) return Written::no;
    (i > 2 ? offsets_->get_rotary : offsets_->get)(offsets_->self, id, v);
    v[i % 3] = own;
    const bool done = (i > 2 ? offsets_->set_rotary : offsets_->set)(offsets_->self, id, v) != 0;
    return done ? Written::taken : Written::no;
  }
  std::optional<double> programmed(const ig::Block& b, const Name& name) const {
    const auto [axis, part] = axis_and_part(name);
    const std::size_t i = axis_of(axis);
    std::array<double, 16> m{};
    if (i > 2 || part != "TR") return std::nullopt;
    return b.get(frame_, m) ? m[12 + i] / unit(b) : 0.0;
  }

  // ---- Tools

  /// The table column that $TC_DP3[t,d], $P_AD[3], $P_TOOLL[1] or $P_TOOLR names.
  static std::optional<std::uint32_t> column_of(const Name& name) {
    std::string_view number = name.base.starts_with("$TC_DP") ? name.base.substr(6) : std::string_view();
    if (name.base == "$P_AD" && name.count == 1) number = name.index[0];
    if (number == "3") return 0;
    if (number == "12") return 1;
    if (number == "6") return 2;
    if (number == "15") return 3;
    return std::nullopt;
  }
  std::optional<std::int64_t> offset_row(const ig::Block& b, const Name& name) const {
    if (!column_of(name)) return std::nullopt;
    if (name.base == "$P_AD") return b.get_or(row_, std::int64_t{0});
    const auto tool = name.number(0), edge = name.number(1);
    if (name.count != 2 || !tool || !edge || *tool < 1 || *edge < 1 || *edge > 99) return std::nullopt;
    return *tool + (*edge - 1) * edge_step;  // the numbering of SiemensToolOffsetSyntax
  }
  std::optional<double> offset(const ig::Block& b, std::int64_t row, std::optional<std::uint32_t> column) const {
    double mm = 0;
    if (row == 0) return 0;
    if (!tools_ || !column || tools_->get(tools_->self, row, *column, &mm) == 0) return std::nullopt;
    return mm / unit(b);
  }
  std::optional<double> plain(const ig::Block& b, std::string_view name) const {
    const std::int64_t row = b.get_or(row_, std::int64_t{0});
    if (name == "$P_TOOLNO" || name == "$TC_MPP6")
      if (const auto tool = b.get(tool_)) return static_cast<double>(*tool);
    if (name == "$P_TOOLP")  // the preselected tool
      if (const auto tool = b.get(next_tool_)) return static_cast<double>(*tool);
    if (name == "$P_TOOL") return static_cast<double>(b.get_or(edge_, std::int64_t{0}));
    if (name == "$P_TOOLR")
      if (const auto own = offset(b, row, 2), wear = offset(b, row, 3); own && wear) return *own + *wear;
    if (name == "$P_F" || name == "$AC_F") return b.get(feed_);
    if (name == "$P_S") return b.get(speed_);
    if (name == "$P_SDIR") return b.is(direction_, cw_) ? 3 : b.is(direction_, ccw_) ? 4 : 5;
    if (name == "$P_UIFRNUM") return offset_number(b) - 1;
    // The program runs from its beginning as on the machine: no block search, no simulation, no test. Markers and
    // parameters of the channel are 0 until the program writes them.
    for (const std::string_view off : {"$P_SEARCH", "$P_SIM", "$P_ISTEST", "$P_DRYRUN", "$AC_MARKER", "$AC_PARAM"})
      if (name == off) return 0;
    return std::nullopt;
  }
  /// True for data that move no axis here: names, types and magazine places of tools, clocks, counters.
  static bool moves_nothing(std::string_view base) {
    for (const std::string_view known :
         {"$AC_TIMER", "$AC_OPERATING_TIME", "$AC_CYCLE_TIME", "$AC_CUTTING_TIME", "$AC_REQUIRED_PARTS",
          "$AC_TOTAL_PARTS", "$AC_ACTUAL_PARTS", "$AC_SPECIAL_PARTS"})
      if (base == known) return true;
    if (base.starts_with("$TC_TP") || base.starts_with("$TC_MPP") || base.starts_with("$TC_DPCE")) return true;
    for (const std::string_view known : {"$TC_DP1", "$TC_DP2", "$TC_DP10", "$TC_DP11", "$TC_DP24", "$TC_DP25"})
      if (base == known) return true;
    return false;
  }

  // ---- Codes in force

  double offset_number(const ig::Block& b) const {
    const std::string_view id = b.text(b.get_or(offset_id_, ig::Symbol{}));
    int n = 500;
    if (id.size() > 1) std::from_chars(id.data() + 1, id.data() + id.size(), n);
    return n >= 505 ? n - 499 : n == 500 ? 1 : n - 52;
  }
  /// $P_GG[n]: the number of the code in its group, from the list of G groups.
  std::optional<double> group(const ig::Block& b, std::int64_t group) const {
    const auto index = [&](const ig::In<ig::Symbol>& field, std::initializer_list<std::string_view> codes) {
      double n = 0;
      const std::string_view term = b.text(b.get_or(field, ig::Symbol{}));
      for (const std::string_view code : codes) {
        ++n;
        if (code == term) return std::optional(n);
      }
      return std::optional<double>();
    };
    switch (group) {
      case 1: return index(motion_, {"G00", "G01", "G02", "G03", "CIP"});
      case 6: return index(plane_, {"G17", "G18", "G19"});
      case 7: return index(compensation_, {"G40", "G41", "G42"}).value_or(1);
      case 8: return offset_number(b);
      case 13: return index(unit_term_, {"G70", "G71", "G700", "G710"});
      case 14: return index(positioning_, {"G90", "G91"});
      case 15: return index(feed_mode_, {"G93", "G94", "G95", "G96", "G97"});
      default: return std::nullopt;
    }
  }

  RotaryOffsetSection turned_{"CoordinateOffset", ig::read};
  std::array<ig::In<double>, 6> machine_{ig::In<double>{"MachineCoordinate.X"}, ig::In<double>{"MachineCoordinate.Y"},
                                         ig::In<double>{"MachineCoordinate.Z"}, ig::In<double>{"MachineCoordinate.A"},
                                         ig::In<double>{"MachineCoordinate.B"}, ig::In<double>{"MachineCoordinate.C"}};
  std::array<ig::In<double>, 3> program_{ig::In<double>{"ProgramXyz.X"}, ig::In<double>{"ProgramXyz.Y"},
                                         ig::In<double>{"ProgramXyz.Z"}};
  ig::In<std::int64_t> tool_{"ToolChange.SpindleToolId"};
  ig::In<std::int64_t> next_tool_{"ToolChange.ToolId"};
  ig::In<std::int64_t> row_{"ToolHeightCompensation.OffsetId"};
  ig::Field<std::int64_t> edge_{
      "ToolHeightCompensation.Edge", ig::read, {ig::Life::modal, "", "D: the cutting edge in force; 0: none."}};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::In<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::In<ig::Symbol> offset_id_{"CoordinateOffset.CoordinateId"};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::In<ig::Symbol> plane_{"PlaneSelect.Term"};
  ig::In<ig::Symbol> compensation_{"RadiusCompensation.Term"};
  ig::In<ig::Symbol> unit_term_{"Unit.Term"};
  ig::In<ig::Symbol> positioning_{"PositioningMode.Term"};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Transform frame_{"ProgrammableFrame", ig::read};
  ig::Name g700_{"G700"}, cw_{"CW"}, ccw_{"CCW"};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::optional, "Read and written as frames."};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "Read and written as $TC_DP."};
};

}  // namespace siemens
