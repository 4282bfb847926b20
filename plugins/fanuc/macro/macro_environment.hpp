/// What expressions read and assignments write: the stored variables, and the variables of the control, which stand for
/// positions, modal codes, offsets and clocks. A member of each syntax that evaluates.
#pragma once

#include <ctime>
#include <string>
#include <vector>

#include <isogloss/cnc/units.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/cnc/work_offset_id.hpp>
#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// O1234 is 1234; a name in brackets is no number.
inline std::optional<double> program_number(std::string_view name) {
  const ig::Decimal number = name.size() > 1 && name[0] == 'O' ? ig::read_decimal(name, 1) : ig::Decimal{};
  return number.ok ? std::optional(number.value) : std::nullopt;
}

/// Which local variables are the present ones: those of the macro call that the block's frame belongs to.
class MacroFrame {
 public:
  ig::Flow flow;

  /// Before the first expression of a block: the local variables are those of its macro call.
  void enter(const ig::Block& b) const {
    const ig_frame frame = flow.frame(b);
    if (store_->is_new_frame(frame.id, frame.pass)) select_level(b, frame);
  }

  MacroStore& store() const { return *store_; }

  /// A program that a code called sees all codes as they are.
  bool is_in_bound_program(const ig::Block& b) const {
    const ig_frame frame = flow.frame(b);
    for (std::uint32_t level = 1; level <= frame.depth; ++level)
      if (const auto at = flow.frame(b, level); at && (at->tag & called_by_code) != 0) return true;
    return false;
  }

 private:
  void select_level(const ig::Block& b, const ig_frame& frame) const {
    ig_frame at = frame;
    for (std::uint32_t level = frame.depth; level > 0 && !has_locals(at);) {
      const auto below = flow.frame(b, --level);
      if (!below) break;
      at = *below;
    }
    store_->select(at.depth == 0 ? 0 : at.tag & ~called_by_code, at.depth == 0 ? 1 : at.pass);
  }
  static bool has_locals(const ig_frame& frame) {
    return (frame.tag & ~begins_inside) != 0 && (frame.tag & shares_locals) == 0;
  }

  /// The service of MacroVariables; a store of its own where a dialect has none.
  class Store {
   public:
    Store() : service_(macro_store_service, ig::Need::optional, "What macro programs read and write.") {
      if (!service_) own_.define(*NumberRanges::read("100-199"), *NumberRanges::read("500-999"));
    }
    MacroStore* operator->() const { return &**this; }
    MacroStore& operator*() const { return service_ ? *const_cast<MacroStore*>(service_.operator->()) : own_; }

   private:
    ig::Service<MacroStore> service_;
    mutable MacroStore own_;
  };

  Store store_;
};

/// A member of each syntax that notes or reads what #4113 and #4114 answer.
class PassedCodeMark {
 public:
  void note(ig::Block& b, MacroStore& store, char letter, double number) const {
    if (!b.is_raised(noted_here_)) store.passed.begin_block();
    b.raise(noted_here_);
    store.passed.note(letter == 'M' ? PassedCodes::m : PassedCodes::n, number);
  }
  std::optional<double> of_blocks_before(const ig::Block& b, const MacroStore& store, PassedCodes::Which which) const {
    return b.is_raised(noted_here_) ? store.passed.before(which) : store.passed.last(which);
  }

 private:
  ig::Signal noted_here_{"PassedCode.~NotedHere", ig::read | ig::write};
};

class MacroEnvironment : public MacroFrame {
 public:
  const ExpressionRules& rules() const { return store().settings.rules; }

  /// What an expression of this block reads: for evaluate() and its like.
  class Reader final : public VariableSource {
   public:
    Reader(const MacroEnvironment& environment, ig::Block& b) : environment_(environment), block_(b) {}
    Fault read(std::uint32_t number, MacroValue& out) const override { return environment_.read(block_, number, out); }
    Fault parameter(std::uint32_t number, std::uint32_t axis, MacroValue& out) const override {
      return environment_.read_parameter(block_, number, axis, out);
    }

   private:
    const MacroEnvironment& environment_;
    ig::Block& block_;
  };
  Reader reader(ig::Block& b) const { return {*this, b}; }

  /// Of the variables of the control that were read since the last forget_signals().
  struct Signals {
    std::uint32_t last = 0;    ///< a signal of the machine whose state is not known here; 0: none was read
    bool others_also = false;  ///< one that may change by itself
  };
  void forget_signals() const { signals_ = {}; }
  const Signals& signals() const { return signals_; }

  /// The block shows what it read.
  Fault read(ig::Block& b, std::uint32_t number, MacroValue& out) const {
    if (const double* const stored = store().find(number)) {
      out = std::isnan(*stored) ? MacroValue::null() : MacroValue{*stored, Kind::number};
    } else if (const Fault fault = read_system(b, number, out); fault != Fault::none) {
      return fault;
    }
    if (number != 0) {
      const std::array<ig_value, 2> shown{ig_value{.number = static_cast<double>(number)}, {.number = out.number}};
      b.append(read_.data(), out.is_null() ? 1 : 2, shown.data());
    }
    return Fault::none;
  }

  /// What an assignment did.
  enum class Written { done, no_variable, read_only, no_row };
  Written write(ig::Block& b, std::uint32_t number, const MacroValue& value) {
    if (number == 0) return Written::read_only;
    if (store().set(number, value.is_null() ? MacroStore::null : value.number)) return Written::done;
    return write_system(b, number, value.number);
  }

  /// Says why an expression has no value.
  void report(ig::Block& b, const Outcome& o, std::string_view text) const {
    std::size_t end = std::max(o.fault_end, o.fault_begin);
    if (end > text.size()) end = text.size();
    const std::size_t begin = std::min(o.fault_begin, end);
    const auto where = ig::Where::columns(begin, std::max(end, begin + 1));
    if (o.fault == Fault::too_deep)
      return b.report(diagnostic_of(o.fault), where, static_cast<double>(rules().deepest));
    std::string_view piece = text.substr(begin, end - begin);
    if (piece.empty() || piece.front() == '\r' || piece.front() == '\n') piece = "the end of the block";
    if (o.variable != 0) return b.report(diagnostic_of(o.fault), where, name_of(piece, o.variable));
    b.report(diagnostic_of(o.fault), where, piece);
  }

  /// #[11000+#1] says nothing of which variable it is: its number stands behind it.
  static std::string name_of(std::string_view written, std::uint32_t number) {
    std::string name(written);
    if (name.find_first_of("[#", 1) != std::string::npos) name += " (#" + std::to_string(number) + ")";
    return name;
  }

  bool has_deep_brackets(const Outcome& o) const { return o.depth > store().settings.nesting; }
  void warn_of_depth(ig::Block& b, const Outcome& o, std::size_t begin, std::size_t end) const {
    b.report(ig::diag("FAN-0117"), ig::Where::columns(begin, end), static_cast<double>(o.depth),
             static_cast<double>(store().settings.nesting));
  }

 private:
  static ig::DiagnosticCode diagnostic_of(Fault fault) {
    switch (fault) {
      case Fault::not_closed: return ig::diag("FAN-0102");
      case Fault::too_deep: return ig::diag("FAN-0103");
      case Fault::number_too_large: return ig::diag("FAN-0104");
      case Fault::unknown_function: return ig::diag("FAN-0105");
      case Fault::named_variable: return ig::diag("FAN-0106");
      case Fault::double_hash: return ig::diag("FAN-0107");
      case Fault::no_variable: return ig::diag("FAN-0108");
      case Fault::unknown_variable: return ig::diag("FAN-0109");
      case Fault::not_known_here: return ig::diag("FAN-0110");
      case Fault::division_by_zero: return ig::diag("FAN-0111");
      case Fault::out_of_domain: return ig::diag("FAN-0112");
      case Fault::overflow: return ig::diag("FAN-0113");
      case Fault::no_bits: return ig::diag("FAN-0114");
      case Fault::truth_as_number: return ig::diag("FAN-0115");
      case Fault::no_comparison: return ig::diag("FAN-0116");
      default: return ig::diag("FAN-0101");
    }
  }

  // ---- variables of the control: reading

  Fault read_system(ig::Block& b, std::uint32_t n, MacroValue& out) const {
    double value = 0;
    const bool is_signal = is_signal_of_machine(n) && store().is_assumed(n) && store().given(n) == nullptr;
    if (is_signal)
      signals_.last = n;
    else
      signals_.others_also = true;
    const Fault fault = system_value(b, n, value);
    out = {value, Kind::number};
    return fault;
  }
  static bool is_signal_of_machine(std::uint32_t n) { return within(n, 1000, 1199); }

  /// Axis 1 to 3 are X Y Z, then the rotary axes that the machine has; 0: a parameter for the whole control.
  Fault read_parameter(const ig::Block& b, std::uint32_t number, std::uint32_t axis, MacroValue& out) const {
    std::string name = std::to_string(number);
    if (axis != 0) {
      const std::size_t index = axis_of(b, axis - 1);
      if (index == no_axis) return Fault::not_known_here;
      name += '.';
      name += "XYZABC"[index];
    }
    const auto value = parameters_.number(name);
    if (!value) return Fault::not_known_here;
    out = {*value, Kind::number};
    return Fault::none;
  }

  static bool within(std::uint32_t n, std::uint32_t first, std::uint32_t last) { return n >= first && n <= last; }

  Fault system_value(ig::Block& b, std::uint32_t n, double& out) const {
    if (n == 3001 || n == 3002) return clock(n, out);
    if (const double* const given = store().given(n)) {
      out = *given;
      return Fault::none;
    }
    if (n == 3011 || n == 3012) return calendar(n, out);
    if (within(n, 4001, 4030) || within(n, 4101, 4130)) return modal(b, n, out);
    if (within(n, 4201, 4230) || within(n, 4301, 4330)) return modal(b, n - 200, out);
    if (within(n, 4401, 4430) || within(n, 4501, 4530)) return Fault::not_known_here;
    if (within(n, 5001, 5100)) return position(b, (n - 5001) / 20, (n - 5001) % 20, out);
    if (n == store().settings.tool_variable) return modal(b, 4120, out);
    if (n == store().settings.speed_variable) return modal(b, 4119, out);
    if (is_local_shift(n)) return local_shift(b, n - 5201, out);
    if (const OffsetCell cell = offset_cell(n); cell.exists) return read_offset(b, cell, out);
    if (const ToolCell cell = tool_cell(n); cell.row != 0) return read_tool(b, cell, out);
    if (store().is_assumed(n)) {
      say_assumed(b, n);
      return Fault::none;
    }
    return within(n, 1000, 99'999) && is_of_control(n) ? Fault::not_known_here : Fault::unknown_variable;
  }

  /// The ranges that controls use for what no program can know.
  static bool is_of_control(std::uint32_t n) {
    return within(n, 1000, 1199) || within(n, 3000, 3999) || within(n, 5101, 5200) || within(n, 5401, 6999);
  }

  Fault clock(std::uint32_t n, double& out) const {
    const double* const given = store().given(n);
    const double step_ms = store().settings.clock_step_ms;
    const double step = n == 3001 ? step_ms : step_ms / 3.6e6;
    out = (given != nullptr ? *given : 0) + step;
    store().give(n, out);
    return Fault::none;
  }

  static Fault calendar(std::uint32_t n, double& out) {
    const std::time_t now = std::time(nullptr);
    std::tm t{};
    if (localtime_r(&now, &t) == nullptr) return Fault::not_known_here;
    out = n == 3011 ? (t.tm_year + 1900) * 10000.0 + (t.tm_mon + 1) * 100.0 + t.tm_mday
                    : t.tm_hour * 10000.0 + t.tm_min * 100.0 + t.tm_sec;
    return Fault::none;
  }

  /// G54.1P12 is 54.1; `otherwise` where no code is in force.
  double code(const ig::Block& b, const ig::Field<ig::Symbol>& field, double otherwise) const {
    const auto symbol = b.get(field);
    if (!symbol) return otherwise;
    const std::string_view text = b.text(*symbol);
    if (text.size() < 2) return otherwise;
    const ig::Decimal d = ig::read_decimal(text, 1);
    return d.ok ? d.value : otherwise;
  }

  Fault modal(const ig::Block& b, std::uint32_t n, double& out) const {
    const auto of = [&](double value) {
      out = value;
      return Fault::none;
    };
    switch (n) {
      case 4001: return of(code(b, motion_, 0));
      case 4002: return of(code(b, plane_, 17));
      case 4003: return of(code(b, positioning_, 90));
      case 4004: return of(23);
      case 4005: return of(code(b, feed_mode_, 94));
      case 4006: return of(code(b, unit_, 21));
      case 4007: return of(code(b, radius_term_, 40));
      case 4008: return of(code(b, length_term_, 49));
      case 4009: return of(code(b, cycle_, 80));
      case 4010: return of(code(b, return_mode_, 98));
      case 4011: return of(code(b, scaling_, 50));
      case 4012: return of(store().settings.offset_in_12 ? code(b, work_offset_, 54) : modal_call());
      case 4013: return of(code(b, surface_speed_, 97));
      case 4014: return of(code(b, work_offset_, 54));
      case 4015: return of(code(b, path_mode_, 64));
      case 4016: return of(code(b, tilt_, 69));
      case 4017: return of(code(b, polar_, 15));
      case 4022: return of(code(b, mirror_, 50.1));
      case 4107: return of(static_cast<double>(b.get_or(radius_row_, std::int64_t{0})));
      case 4109: return of(in_program_unit(b, b.get_or(feed_, 0.0)));
      case 4111: return of(static_cast<double>(b.get_or(length_row_, std::int64_t{0})));
      case 4113: return passed(b, PassedCodes::m, out);
      case 4114: return passed(b, PassedCodes::n, out);
      case 4115: return program_in_force(b, out);
      case 4119: return of(b.get_or(speed_, 0.0));
      case 4120: return of(static_cast<double>(b.get_or(tool_, std::int64_t{0})));
      case 4130: return of(additional_set(b));
      default: return Fault::not_known_here;
    }
  }

  double modal_call() const {
    const std::vector<MacroStore::ModalCall>& calls = store().modal_calls();
    if (calls.empty()) return 67;
    return calls.back().each_block ? 66.1 : 66;
  }

  /// Of the block before; where it has none, the last one is not kept here.
  Fault passed(const ig::Block& b, PassedCodes::Which which, double& out) const {
    const auto number = passed_.of_blocks_before(b, store(), which);
    out = number.value_or(0);
    return number ? Fault::none : Fault::not_known_here;
  }

  /// The name by which the program was called; the main program has the number that it begins with.
  Fault program_in_force(const ig::Block& b, double& out) const {
    const ig_frame frame = flow.frame(b);
    const auto number = frame.depth == 0 ? store().main_program : program_number(ig::to_view(frame.program));
    out = number.value_or(0);
    return number ? Fault::none : Fault::not_known_here;
  }

  double additional_set(const ig::Block& b) const {
    const auto symbol = b.get(work_offset_);
    if (!symbol) return 0;
    const std::string_view text = b.text(*symbol);
    if (!text.starts_with("G54.1P")) return 0;
    return ig::read_decimal(text, 6).value;
  }

  bool is_inch(const ig::Block& b) const { return b.is(system_, inch_); }
  double in_program_unit(const ig::Block& b, double mm) const { return is_inch(b) ? mm / mm_per_inch : mm; }

  /// Axis 4 and on are the rotary axes that the machine has, in the order A, B, C.
  static constexpr std::size_t no_axis = 9;
  std::size_t axis_of(const ig::Block& b, std::uint32_t index) const {
    if (index < 3) return index;
    for (std::size_t axis = 3; axis < 6; ++axis) {
      double home = 0;
      const bool exists =
          b.has(rotary_[axis - 3]) || (machine_ && machine_->home(machine_->self, "XYZABC"[axis], &home) != 0);
      if (exists && index-- == 3) return axis;
    }
    return no_axis;
  }

  enum Group : std::uint32_t { block_end = 0, machine = 1, work = 2, skip = 3, tool_length = 4 };

  Fault position(const ig::Block& b, std::uint32_t group, std::uint32_t index, double& out) const {
    const std::size_t axis = axis_of(b, index);
    if (axis == no_axis) return index < 6 && axis_of(b, 3) == no_axis ? Fault::not_known_here : Fault::unknown_variable;
    if (axis > 2) {
      const double angle = b.get_or(rotary_[axis - 3], 0.0);
      out = group == tool_length ? 0 : group == machine ? angle : angle - b.get_or(rotary_offset_[axis - 3], 0.0);
      return Fault::none;
    }
    switch (group) {
      case machine: out = b.get(machine_xyz_).value[axis]; break;
      case work: out = work_position(b, axis); break;
      case tool_length: out = axis == 2 ? b.get_or(length_, 0.0) : 0; break;
      default: out = program_xyz(b)[axis];
    }
    out = in_program_unit(b, out);
    return Fault::none;
  }

  ig::Vec3 program_xyz(const ig::Block& b) const { return b.get(program_xyz_).or_else({}); }

  /// The gauge point in the work coordinate system: the machine position without the offsets of the workpiece.
  double work_position(const ig::Block& b, std::size_t axis) const {
    const ig::PartialVec3 position = b.get(machine_xyz_);
    if (!position.has(axis)) return program_xyz(b)[axis];
    return position.value[axis] - b.get_or(work_origin_[axis], 0.0) - b.get_or(local_origin_[axis], 0.0) -
           b.get_or(shift_[axis], 0.0);
  }

  // ---- offsets

  struct OffsetCell {
    bool exists = false;
    std::uint32_t axis = 0;
    WorkOffsetId id = WorkOffsetId::basic(0);
  };

  bool is_local_shift(std::uint32_t n) const { return store().settings.local_in_5201 && within(n, 5201, 5206); }
  Fault local_shift(const ig::Block& b, std::uint32_t index, double& out) const {
    const std::size_t axis = axis_of(b, index);
    if (axis > 2) return Fault::not_known_here;
    out = in_program_unit(b, b.get_or(local_origin_[axis], 0.0));
    return Fault::none;
  }

  /// #5201 the external offset, #5221 G54 …, twenty to a set; #7001 and #14001 G54.1 P1 …; #2501, #2601, #2701 by axes.
  OffsetCell offset_cell(std::uint32_t n) const {
    const auto basic = [](std::uint32_t set, std::uint32_t axis) {
      return OffsetCell{true, axis, WorkOffsetId::basic(set)};
    };
    const auto additional = [](std::uint32_t index) {
      const std::uint32_t set = index / 20 + 1;
      return OffsetCell{true, index % 20, WorkOffsetId::additional(set)};
    };
    if (within(n, 5201, 5340)) return basic((n - 5201) / 20, (n - 5201) % 20);
    if (within(n, 7001, 7960)) return additional(n - 7001);
    if (within(n, 14001, 20000)) return additional(n - 14001);
    const bool has_by_axes = !store().settings.radii_from_2401;
    if (has_by_axes && within(n, 2500, 2799) && n % 100 <= 6) return basic(n % 100, n / 100 - 25);
    return {};
  }

  Fault read_offset(const ig::Block& b, const OffsetCell& cell, double& out) const {
    const std::size_t axis = axis_of(b, cell.axis);
    double offset[3];
    if (axis == no_axis || !get_offset(cell, axis, offset)) return Fault::unknown_variable;
    out = axis > 2 ? offset[axis - 3] : in_program_unit(b, offset[axis]);
    return Fault::none;
  }

  /// X Y Z or A B C of the set: those of which `axis` is one.
  bool get_offset(const OffsetCell& cell, std::size_t axis, double (&offset)[3]) const {
    const ig_text id = ig::to_text(cell.id.text());
    if (!offsets_ || (axis > 2 && !has_rotary_offsets())) return false;
    return (axis > 2 ? offsets_->get_rotary : offsets_->get)(offsets_->self, id, offset) != 0;
  }
  bool has_rotary_offsets() const {
    const ig_work_offset_1& table = *offsets_.operator->();
    constexpr std::size_t with_rotary = offsetof(ig_work_offset_1, set_rotary) + sizeof table.set_rotary;
    return table.struct_size >= with_rotary && table.get_rotary != nullptr && table.set_rotary != nullptr;
  }

  struct ToolCell {
    std::uint32_t row = 0;  ///< 0: none
    std::uint32_t column = 0;
  };
  /// Columns of the tool offset service: 0 length, 1 its wear, 2 radius, 3 its wear.
  ToolCell tool_cell(std::uint32_t n) const {
    const MacroSettings& settings = store().settings;
    const std::uint32_t wear_first = settings.tools == ToolVariables::wear_first ? 1 : 0;
    if (settings.tools != ToolVariables::geometry_first && within(n, 10001, 13999) && n % 1000 != 0)
      return {n % 1000, (n / 1000 - 10) ^ wear_first};
    if (within(n, 2001, settings.radii_from_2401 ? 2800 : 2400))
      return {(n - 2001) % 200 + 1, ((n - 2001) / 200) ^ wear_first};
    return {};
  }

  Fault read_tool(const ig::Block& b, const ToolCell& cell, double& out) const {
    double mm = 0;
    if (!tools_ || tools_->get(tools_->self, cell.row, cell.column, &mm) == 0) return Fault::unknown_variable;
    out = in_program_unit(b, mm);
    return Fault::none;
  }

  void say_assumed(ig::Block& b, std::uint32_t n) const {
    const auto it = std::lower_bound(assumed_.begin(), assumed_.end(), n);
    if (it != assumed_.end() && *it == n) return;
    assumed_.insert(it, n);
    b.report(ig::diag("FAN-0118"), ig::Where::block(), static_cast<double>(n), 0.0);
  }

  // ---- variables of the control: writing

  Written write_system(ig::Block& b, std::uint32_t n, double value) {
    const double mm = is_inch(b) ? value * mm_per_inch : value;
    if (is_local_shift(n)) return Written::read_only;
    if (const OffsetCell cell = offset_cell(n); cell.exists) return write_offset(b, cell, value);
    if (const ToolCell cell = tool_cell(n); cell.row != 0) {
      if (!tools_ || !std::isfinite(mm) || tools_->set(tools_->self, cell.row, cell.column, mm) == 0)
        return Written::no_row;
      b.raise(tools_changed_);
      return Written::done;
    }
    if (within(n, 4001, 4530) || within(n, 5001, 5100) || n == 3011 || n == 3012) return Written::read_only;
    if (n == store().settings.tool_variable || n == store().settings.speed_variable) return Written::read_only;
    if (n != 3001 && n != 3002 && !store().is_assumed(n) && store().given(n) == nullptr) return Written::no_variable;
    store().give(n, value);
    return Written::done;
  }

  Written write_offset(ig::Block& b, const OffsetCell& cell, double value) {
    const std::size_t axis = axis_of(b, cell.axis);
    if (axis == no_axis) return Written::no_variable;
    const bool is_rotary = axis > 2;
    const double to = !is_rotary && is_inch(b) ? value * mm_per_inch : value;
    double offset[3];
    if (!std::isfinite(to) || !get_offset(cell, axis, offset)) return Written::no_row;
    offset[axis % 3] = to;
    const ig_text id = ig::to_text(cell.id.text());
    if ((is_rotary ? offsets_->set_rotary : offsets_->set)(offsets_->self, id, offset) == 0) return Written::no_row;
    b.raise(offsets_changed_);
    return Written::done;
  }

  mutable std::vector<std::uint32_t> assumed_;
  mutable Signals signals_;

  ig::In<ig::Symbol> motion_{"MotionState.Term"}, plane_{"PlaneSelect.Term"}, positioning_{"PositioningMode.Term"},
      feed_mode_{"Feedrate.Term"}, unit_{"Unit.Term"}, system_{"Unit.System"}, radius_term_{"RadiusCompensation.Term"},
      length_term_{"ToolHeightCompensation.Term"}, cycle_{"CannedCycle.Term"}, return_mode_{"CannedCycle.ReturnMode"},
      scaling_{"Scaling.Term"}, surface_speed_{"SpindleSpeed.Term"}, work_offset_{"CoordinateOffset.CoordinateId"},
      path_mode_{"PathMode.Term"}, tilt_{"TiltTransform.Term"}, polar_{"PolarCoordinate.Term"},
      mirror_{"MirrorImage.Term"};
  ig::In<double> feed_{"Feedrate.FeedrateValue"}, speed_{"SpindleSpeed.SpindleSpeed_rpm"},
      length_{"ToolHeightCompensation.Offset_mm"};
  ig::In<std::int64_t> tool_{"ToolChange.ToolId"}, length_row_{"ToolHeightCompensation.OffsetId"},
      radius_row_{"RadiusCompensation.OffsetId"};
  PassedCodeMark passed_;
  ig::Xyz program_xyz_{"ProgramXyz", ig::read}, machine_xyz_{"MachineCoordinate", ig::read};
  std::array<ig::In<double>, 3> rotary_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  static constexpr ig::About rotary_offset_about{ig::Life::modal, "deg",
                                                 "What is added to a programmed angle of the axis."};
  std::array<ig::In<double>, 3> rotary_offset_{ig::In<double>{"RotaryOffset.A", ig::read, rotary_offset_about},
                                               ig::In<double>{"RotaryOffset.B", ig::read, rotary_offset_about},
                                               ig::In<double>{"RotaryOffset.C", ig::read, rotary_offset_about}};
  std::array<ig::In<double>, 3> work_origin_{ig::In<double>{"CoordinateOffset.Offset_X"},
                                             ig::In<double>{"CoordinateOffset.Offset_Y"},
                                             ig::In<double>{"CoordinateOffset.Offset_Z"}};
  std::array<ig::In<double>, 3> local_origin_{ig::In<double>{"LocalCoordinateOffset.Offset_X"},
                                              ig::In<double>{"LocalCoordinateOffset.Offset_Y"},
                                              ig::In<double>{"LocalCoordinateOffset.Offset_Z"}};
  std::array<ig::In<double>, 3> shift_{ig::In<double>{"WorkCoordinateShift.Offset_X"},
                                       ig::In<double>{"WorkCoordinateShift.Offset_Y"},
                                       ig::In<double>{"WorkCoordinateShift.Offset_Z"}};
  std::array<ig_field, 2> read_{
      ig::detail::declare_field({{"Vars.Read[].Variable"},
                                 IG_NUMBER,
                                 ig::write,
                                 {ig::Life::block, "", "Number of a variable that the block read."}}),
      ig::detail::declare_field(
          {{"Vars.Read[].Value"}, IG_NUMBER, ig::write, {ig::Life::block, "", "Its value; absent: null."}})};
  ig::Signal offsets_changed_{"CoordinateOffset.~TableChanged", ig::write};
  ig::Signal tools_changed_{"ToolHeightCompensation.~TableChanged", ig::write};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::optional, "#5201 and on."};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "#2001 and on."};
  ig::Config parameters_{"isogloss.control-parameter/1", ig::Need::optional, "PRM[]: parameters of the control."};
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The rotary axes there are."};
  ig::Name inch_{"Inch"};
};

}  // namespace fanuc
