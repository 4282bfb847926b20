/// The variables of custom macro B that programs write: local ones for each macro call, common and permanent ones. The
/// dependency MacroVariables owns one store; the syntaxes of this plugin reach it through its service.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "macro/expression.hpp"

namespace fanuc {

inline constexpr const char* macro_store_service = "fanuc.macro-variables/1";
inline constexpr std::uint32_t last_local = 33;

/// A bit of a frame's tag: a code that parameters assign to the program has called it; it has no local variables of its
/// own.
inline constexpr std::uint64_t called_by_code = std::uint64_t{1} << 63;
inline constexpr std::uint64_t shares_locals = std::uint64_t{1} << 62;

/// A list such as "100-199 500", in any order, as the dialect writes it.
class NumberRanges {
 public:
  struct Range {
    std::uint32_t first, last;
  };
  /// Nothing where the text is not a list of ranges.
  static std::optional<NumberRanges> read(std::string_view text) {
    NumberRanges out;
    while (true) {
      while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
      if (text.empty()) return out;
      Range range{};
      if (!read_number(text, range.first)) return std::nullopt;
      range.last = range.first;
      if (!text.empty() && text.front() == '-') {
        text.remove_prefix(1);
        if (!read_number(text, range.last)) return std::nullopt;
      }
      if (range.last < range.first || range.last > 999'999 || (!text.empty() && text.front() != ' '))
        return std::nullopt;
      out.ranges_.push_back(range);
    }
  }
  bool holds(std::uint32_t number) const {
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const Range& r) { return number >= r.first && number <= r.last; });
  }
  const std::vector<Range>& all() const { return ranges_; }

 private:
  static bool read_number(std::string_view& text, std::uint32_t& out) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc{}) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  }
  std::vector<Range> ranges_;
};

/// The meaning of #2001 and #10001 and above: wear of lengths, then their geometry; the other way round (Series 15); or
/// the geometry first, while #10001 and above are not tools (Haas).
enum class ToolVariables { wear_first, series_15, geometry_first };

/// What differs between controls.
struct MacroSettings {
  ExpressionRules rules;
  std::uint32_t nesting = 5;       ///< levels of brackets that the control permits
  std::uint32_t call_nesting = 5;  ///< levels of macro calls that the control permits
  ToolVariables tools = ToolVariables::wear_first;
  bool radii_from_2401 = false;  ///< #2401 to #2800 are tool radii; else #2500 and above are work offsets
  bool local_in_5201 = false;    ///< #5201 and above are the shift of G52; else the external offset
  std::uint32_t tool_variable = 0, speed_variable = 0;  ///< the tool in the spindle, and its speed; 0: no variable
  bool offset_in_12 = false;                            ///< #4012 is the work offset; else the modal macro call
  bool repeats_keep_locals = false;                     ///< G65 L: only the first pass begins with the arguments
  double clock_step_ms = 100;                           ///< by how much the clocks advance each time they are read
};

/// The last M code and the last sequence number of earlier blocks, and those of the present block.
class PassedCodes {
 public:
  enum Which : std::size_t { m, n };
  void begin_block() { before_ = last_; }
  void note(Which which, double number) { last_[which] = number; }
  std::optional<double> before(Which which) const { return before_[which]; }
  std::optional<double> last(Which which) const { return last_[which]; }

 private:
  std::array<std::optional<double>, 2> before_, last_;
};

/// O9010, or <PART> as written.
struct CalledProgram {
  std::int64_t number = 0;
  std::string name{};  ///< empty: it is called by its number
};

class MacroStore {
 public:
  MacroSettings settings;
  PassedCodes passed;
  std::optional<double> main_program;  ///< its number, where it has one

  static constexpr double null = std::numeric_limits<double>::quiet_NaN();
  using Locals = std::array<double, last_local + 1>;
  /// The modal call of G66: a macro that is called after each block that moves; of G66.1: with the words of each block.
  struct ModalCall {
    CalledProgram program;
    std::int64_t repeats;
    Locals arguments;
    bool each_block = false;
  };
  static Locals no_locals() {
    Locals out;
    out.fill(null);
    return out;
  }

  /// Receives each write to a permanent variable, so that the table keeps it.
  struct Keeper {
    virtual void keep(std::uint32_t number, double value) = 0;

   protected:
    ~Keeper() = default;
  };

  void define(const NumberRanges& common, const NumberRanges& permanent) {
    for (const auto& r : common.all()) add(r, false);
    for (const auto& r : permanent.all()) add(r, true);
  }
  /// With a distance of 10000, #10100 is another name of #100; 0: there are no such names.
  void alias(std::uint32_t distance) { alias_ = distance; }
  void assume(NumberRanges assumed) { assumed_ = std::move(assumed); }
  void keep_in(Keeper* keeper) { keeper_ = keeper; }

  /// The variable's value; null where it is not one of these. Valid until the next call.
  const double* find(std::uint32_t number) const {
    if (number <= last_local) return &levels_[present_].values[number];
    const Area* const area = area_of(number);
    return area != nullptr ? &area->values[number - area->first] : nullptr;
  }
  /// False where the variable is not one of these.
  bool set(std::uint32_t number, double value) {
    ++writes_;
    if (number <= last_local) {
      levels_[present_].values[number] = value;
      return true;
    }
    const Area* const area = area_of(number);
    if (area == nullptr) return false;
    areas_[static_cast<std::size_t>(area - areas_.data())].values[number - area->first] = value;
    if (area->is_permanent && keeper_ != nullptr) keeper_->keep(number, value);
    return true;
  }

  /// Variables of the control to which the user or the program has given a value: signals, switches.
  const double* given(std::uint32_t number) const {
    const auto it = std::lower_bound(given_.begin(), given_.end(), number, before);
    return it != given_.end() && it->first == number ? &it->second : nullptr;
  }
  void give(std::uint32_t number, double value) {
    ++writes_;
    const auto it = std::lower_bound(given_.begin(), given_.end(), number, before);
    if (it != given_.end() && it->first == number)
      it->second = value;
    else
      given_.insert(it, {number, value});
  }
  bool is_assumed(std::uint32_t number) const { return assumed_.holds(number); }
  /// The number of writes to variables so far.
  std::uint64_t writes() const { return writes_; }

  /// Begins a macro call with its local variables, identified by the tag that its frame will show. They wait for that
  /// frame, since the calling block goes on with the caller's variables. Modal calls stay active inside it; a macro
  /// that a modal call runs does not call itself.
  std::uint64_t enter(const Locals& arguments, bool is_modal = false) {
    frame_ = no_frame;
    leave_last();
    std::vector<ModalCall> inside = modal_calls();
    if (is_modal && !inside.empty()) inside.pop_back();
    levels_.push_back({++last_tag_, 1, arguments, arguments, std::move(inside)});
    return last_tag_;
  }
  std::vector<ModalCall>& modal_calls() { return levels_[present_].modal_calls; }
  /// Undoes enter() where the call was not made.
  void leave_last() { levels_.erase(levels_.begin() + static_cast<std::ptrdiff_t>(present_) + 1, levels_.end()); }
  /// True once for each frame and pass: its level must be looked up.
  bool is_new_frame(std::uint64_t frame, std::uint32_t pass) {
    if (frame == frame_ && pass == pass_) return false;
    frame_ = frame;
    pass_ = pass;
    return true;
  }
  /// Makes the level of the macro call with this tag the present one; a new pass begins with its arguments.
  void select(std::uint64_t tag, std::uint32_t pass) {
    if (levels_[present_].tag != tag) {
      if (present_ + 1 < levels_.size() && levels_[present_ + 1].tag == tag)
        ++present_;
      else
        while (present_ > 0 && levels_[present_].tag != tag) --present_;
      leave_last();
    }
    Level& level = levels_[present_];
    if (level.tag != tag || level.pass == pass) return;
    level.pass = pass;
    if (!settings.repeats_keep_locals) level.values = level.arguments;
  }
  std::size_t depth() const { return present_; }

 private:
  struct Area {
    std::uint32_t first;
    bool is_permanent;
    std::vector<double> values;
  };
  struct Level {
    std::uint64_t tag;
    std::uint32_t pass;
    Locals values, arguments;
    std::vector<ModalCall> modal_calls;
  };
  static bool before(const std::pair<std::uint32_t, double>& given, std::uint32_t number) {
    return given.first < number;
  }
  const Area* holding(std::uint32_t number) const {
    for (const Area& a : areas_)
      if (number - a.first < a.values.size()) return &a;
    return nullptr;
  }
  /// `number` becomes the number of the variable within its area.
  const Area* area_of(std::uint32_t& number) const {
    const Area* const area = holding(number);
    if (area != nullptr || alias_ == 0 || number <= alias_ + last_local) return area;
    number -= alias_;
    return holding(number);
  }
  void add(const NumberRanges::Range& range, bool is_permanent) {
    areas_.push_back({range.first, is_permanent, std::vector<double>(range.last - range.first + 1, null)});
  }

  std::vector<Level> levels_{{0, 1, no_locals(), no_locals(), {}}};
  std::size_t present_ = 0;  // the level in force; a requested call may wait above it
  std::vector<Area> areas_;
  std::vector<std::pair<std::uint32_t, double>> given_;
  NumberRanges assumed_;
  std::uint32_t alias_ = 0;
  Keeper* keeper_ = nullptr;
  std::uint64_t last_tag_ = 0;
  std::uint64_t writes_ = 0;
  static constexpr std::uint64_t no_frame = ~std::uint64_t{0};
  std::uint64_t frame_ = no_frame;  // the frame whose level is the present one
  std::uint32_t pass_ = 0;
};

}  // namespace fanuc
