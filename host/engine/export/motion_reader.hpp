/// Turns finished blocks into events, in the order in which the machine performs them.
#pragma once

#include <optional>
#include <string_view>

#include "isogloss/engine/document.hpp"

namespace isogloss {

/// A point of which some axes may be unknown: X Y Z A B C, a bit for each that is known.
struct AxisPoint {
  /// X, Y and Z and nothing else: what a machine with three axes moves to.
  static constexpr std::uint32_t xyz = 7;
  double at[6] = {};
  std::uint32_t known = 0;
  bool has(unsigned axis) const { return (known >> axis & 1u) != 0; }
  bool has_xyz() const { return (known & xyz) == xyz; }
};

/// Where an arc lies. With N the normal, it runs `sweep_deg()` about N: counter-clockwise when positive, whole turns
/// included.
struct Arc {
  std::string_view plane = "XY";
  bool has_center = false;  ///< without one nothing below it is known
  bool is_ccw = false;
  std::uint8_t first_axis = 0, second_axis = 1;  ///< of the plane; counter-clockwise turns the first to the second
  std::int64_t additional_circles = 0;
  double center[3] = {};  ///< program coordinates, at the level of the start
  double start[3] = {};   ///< program coordinates, in the frame of this block
  double machine_center[3] = {};
  double normal[3] = {};          ///< unit vector, machine coordinates
  std::optional<double> sweep{};  ///< where it is not computed from `start`: the arc was read from a stream
};

struct Move {
  enum class Kind : std::uint8_t { rapid, feed, arc };
  Kind kind = Kind::rapid;
  bool is_manual = false;
  bool is_led = false;  ///< ClLinear: the rotary axes turn, and the tip goes straight in the workpiece
  bool has_feed = false;
  double feed_mmds = 0;
  AxisPoint program;  ///< X Y Z
  AxisPoint machine;
  AxisPoint from;   ///< machine coordinates before the move
  AxisPoint start;  ///< program coordinates where the tip begins, in the frame of this block; set where is_led only
  Arc arc;          ///< set for arcs only
};

/// Of an arc whose centre is known. Computed where it is written, which may be another thread than the reader's.
double sweep_deg(const Move& move);

/// One name compared often: by its id once the id is known.
class KnownName {
 public:
  explicit KnownName(std::string_view text) : text_(text) {}
  void forget() { id_ = 0; }
  bool is(ig_symbol symbol, const SymbolTable& symbols) {
    if (id_ != 0) return symbol == id_;
    if (symbols.text(symbol) != text_) return false;
    id_ = symbol;
    return true;
  }

 private:
  std::string_view text_;
  ig_symbol id_ = 0;
};

/// Keeps the state that earlier events left: position, spindle, coolant.
class MotionReader {
 public:
  explicit MotionReader(bool zero_moves) : keep_zero_moves_(zero_moves) {}

  void begin(const Document& initial, const SymbolTable& symbols);

  /// Calls, in order: tool(number), spindle(direction, has_speed, rpm), coolant(mode), dwell(seconds), orient(degrees),
  /// move(Move), stop(term), end(term).
  template <class Events>
  void read(Document& d, const SymbolTable& symbols, Events& events) {
    if (d.frame_moved) is_in_frame_ = false;
    const bool has_others = any_fresh(d);
    if (has_others) before_motion(d, symbols, events);
    if (d.fresh(root_.form)) {
      if (const Move* move = root_move(d, symbols)) events.move(*move);
    } else if (list_ < d.lists.size() && d.lists[list_].count != 0) {
      read_items(d, symbols, events);
      if (d.frame_moved) is_in_frame_ = false;  // G28 of a control ends the tool length behind its steps
    }
    if (has_others) after_motion(d, symbols, events);
  }

 private:
  /// The fields of a point. Where they lie side by side one test tells which are present.
  struct AxisFields {
    ig_field ids[6] = {IG_NO_FIELD, IG_NO_FIELD, IG_NO_FIELD, IG_NO_FIELD, IG_NO_FIELD, IG_NO_FIELD};
    std::uint32_t run = 0;  ///< a bit for each axis; 0: they do not
    void find_run();
  };
  /// The fields of a motion, in the block itself or in a list's record.
  struct Fields {
    AxisFields program, machine;
    ig_field form, is_rapid, is_manual, feed, center[3], is_ccw, circles;
  };
  struct FreshMask {
    std::uint32_t word;
    std::uint64_t bits;
  };
  /// The block's own values, asked like a record's.
  struct Root {
    const Document& d;
    bool present(ig_field f) const { return d.present(f); }
    std::uint64_t bits_from(ig_field f) const { return d.bits(f >> 6).present >> (f & 63); }
    ig_value value(ig_field f) const { return d.value(f); }
    double number(ig_field f) const { return d.number(f); }
  };
  struct Record {
    const ig_value* values;
    std::uint64_t mask;
    bool present(ig_field f) const { return f < 64 && (mask >> f & 1) != 0; }
    std::uint64_t bits_from(ig_field f) const { return mask >> f; }
    ig_value value(ig_field f) const { return values[f]; }
    double number(ig_field f) const { return values[f].number; }
  };

  bool any_fresh(const Document& d) const {
    std::uint64_t found = 0;
    for (const FreshMask& m : others_) found |= d.bits(m.word).fresh & m.bits;
    return found != 0;
  }

  const Move* root_move(Document& d, const SymbolTable& symbols);
  const Move* item_move(const Record& item, Document& d, const SymbolTable& symbols);
  template <class Values>
  static void read_point(const Values& values, const AxisFields& fields, AxisPoint& point);
  template <class Values>
  const Move* make_move(const Values& values, const Fields& fields, Document& d, const SymbolTable& symbols);
  /// A machine that has nothing but X, Y and Z goes straight to a point of which all three are known.
  template <class Values>
  bool is_plain(const Values& values, const Fields& fields) const;
  /// The kind of the move, and how fast it is.
  template <class Values>
  void read_speed(const Values& values, const Fields& fields, bool is_arc);
  template <class Values>
  const Move* make_plain_move(const Values& values, const Fields& fields);
  template <class Values>
  void make_arc(const Values& values, const Fields& fields, Document& d, const SymbolTable& symbols);
  bool goes_nowhere() const;
  bool changes_spindle(ig_symbol direction, const Document& d, const SymbolTable& symbols);

  template <class Events>
  void before_motion(Document& d, const SymbolTable& symbols, Events& events) {
    if (d.fresh(is_change_) && d.value(is_change_).integer != 0) {
      const ig_field tool = d.present(spindle_tool_) ? spindle_tool_ : tool_;
      if (d.present(tool)) events.tool(d.value(tool).integer);
    }
    if (d.fresh(direction_) || (d.fresh(speed_) && spindle_turns_)) {
      // A new speed alone: the spindle goes on turning as it does, whatever the steps of this block leave in force.
      const ig_symbol direction = d.fresh(direction_) ? symbol(d, direction_) : spindle_direction_;
      if (direction != 0 && !stop_.is(direction, symbols)) tell_spindle(direction, d, symbols, events);
    }
    if (d.fresh(coolant_) && !off_.is(symbol(d, coolant_), symbols)) tell_coolant(symbol(d, coolant_), symbols, events);
    if (d.fresh(dwell_)) events.dwell(d.number(dwell_));
  }

  template <class Events>
  void after_motion(Document& d, const SymbolTable& symbols, Events& events) {
    if (d.fresh(orient_)) tell_orient(d.number(orient_), events);
    if (d.fresh(direction_)) {
      const ig_symbol direction = symbol(d, direction_);
      if (stop_.is(direction, symbols)) tell_spindle(direction, d, symbols, events);
    }
    if (d.fresh(coolant_) && off_.is(symbol(d, coolant_), symbols)) tell_coolant(symbol(d, coolant_), symbols, events);
    if (d.fresh(program_stop_)) events.stop(symbols.text(symbol(d, program_stop_)));
    if (d.fresh(program_end_)) events.end(symbols.text(symbol(d, program_end_)));
  }

  template <class Events>
  void read_items(Document& d, const SymbolTable& symbols, Events& events) {
    const ListData& list = d.lists[list_];
    for (std::uint32_t i = 0; i < list.count; ++i) {
      const Record item{list.values.data() + std::size_t{i} * list.stride, list.present[i]};
      if (item.present(item_.form))
        if (const Move* move = item_move(item, d, symbols)) events.move(*move);
      if ((item.mask & step_events_) == 0) continue;
      if (item.present(item_dwell_)) events.dwell(item.number(item_dwell_));
      if (item.present(item_orient_)) tell_orient(item.number(item_orient_), events);
      if (item.present(item_direction_))
        tell_spindle(static_cast<ig_symbol>(item.value(item_direction_).symbol), d, symbols, events);
    }
  }

  template <class Events>
  void tell_spindle(ig_symbol direction, const Document& d, const SymbolTable& symbols, Events& events) {
    if (!changes_spindle(direction, d, symbols)) return;
    const bool has_speed = d.present(speed_);
    events.spindle(symbols.text(direction), has_speed, has_speed ? d.number(speed_) : 0);
  }
  /// After an oriented stop the spindle stands still: any start is a change.
  template <class Events>
  void tell_orient(double degrees, Events& events) {
    spindle_turns_ = false;
    events.orient(degrees);
  }
  template <class Events>
  void tell_coolant(ig_symbol mode, const SymbolTable& symbols, Events& events) {
    const ig_symbol flows = off_.is(mode, symbols) ? 0 : mode;
    if (flows == coolant_mode_) return;
    coolant_mode_ = flows;
    events.coolant(symbols.text(mode));
  }

  static ig_symbol symbol(const Document& d, ig_field f) {
    return d.present(f) ? static_cast<ig_symbol>(d.value(f).symbol) : 0;
  }

  bool keep_zero_moves_;
  Fields root_{}, item_{};
  AxisFields led_start_;       // where a block begins that changes its frame and leads the tip
  AxisFields program_before_;  // ProgramXyz as it was carried into the block
  std::size_t list_ = 0;
  std::uint64_t step_events_ = 0;  // the fields of a step that make events beside its move
  std::vector<FreshMask> others_;  // the fields that make events without a motion
  ig_field is_change_{}, tool_{}, spindle_tool_{}, direction_{}, speed_{}, coolant_{}, dwell_{}, orient_{}, plane_{},
      program_stop_{}, program_end_{}, item_dwell_{}, item_direction_{}, item_orient_{};
  KnownName linear_{"McLinear"}, led_{"ClLinear"}, arc_{"McArc"}, stop_{"STOP"}, off_{"OFF"}, xy_{"XY"}, zx_{"ZX"},
      yz_{"YZ"};

  Move move_;
  AxisPoint position_;          // machine coordinates of the last event
  AxisPoint program_position_;  // the same in the program's
  bool is_in_frame_ = false;    // ... of this block's frame, too
  bool spindle_turns_ = false;
  ig_symbol spindle_direction_ = 0;
  double spindle_speed_ = 0;
  ig_symbol coolant_mode_ = 0;  // 0: off
};

}  // namespace isogloss
