/// The variables of custom macro B that programs write: local ones for each macro call, common and permanent ones. The
/// dependency MacroVariables owns one store; the syntaxes of this plugin reach it through its service.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <isogloss/provenance.hpp>

#include "macro/macro_settings.hpp"
#include "macro/number_ranges.hpp"

namespace fanuc {

inline constexpr const char* macro_store_service = "fanuc.macro-variables/1";
inline constexpr std::uint32_t last_local = 33;

/// A bit of a frame's tag: a code that parameters assign to the program has called it; it has no local variables of its
/// own.
inline constexpr std::uint64_t called_by_code = std::uint64_t{1} << 63;
inline constexpr std::uint64_t shares_locals = std::uint64_t{1} << 62;

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

  void define(const NumberRanges& common, const NumberRanges& permanent);
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
    rows_.overwrite(number);
    if (area->is_permanent && keeper_ != nullptr) keeper_->keep(number, value);
    return true;
  }

  /// Variables of the control to which the user or the program has given a value: signals, switches.
  const double* given(std::uint32_t number) const;
  void give(std::uint32_t number, double value);
  /// The row of the table from which the variable has its value; nullptr where the program has set it.
  const std::string* row_of(std::uint32_t number) const {
    if (number > last_local) area_of(number);
    return rows_.of(number);
  }
  void came_from(std::uint32_t number, std::string_view row) {
    if (area_of(number) != nullptr || given(number) != nullptr) rows_.give(number, row);
  }
  /// The call whose local variable it is; 0 for all others.
  std::uint64_t scope_of(std::uint32_t number) const { return number <= last_local ? levels_[present_].tag : 0; }
  bool is_assumed(std::uint32_t number) const { return assumed_.holds(number); }
  /// The number of writes to variables so far.
  std::uint64_t writes() const { return writes_; }

  /// Begins a macro call with its local variables, identified by the tag that its frame will show. They wait for that
  /// frame, since the calling block goes on with the caller's variables. Modal calls stay active inside it; a macro
  /// that a modal call runs does not call itself.
  std::uint64_t enter(const Locals& arguments, bool is_modal = false);
  std::vector<ModalCall>& modal_calls() { return levels_[present_].modal_calls; }
  /// Undoes enter() where the call was not made.
  void leave_last();
  /// True once for each frame and pass: its level must be looked up.
  bool is_new_frame(std::uint64_t frame, std::uint32_t pass) {
    if (frame == frame_ && pass == pass_) return false;
    frame_ = frame;
    pass_ = pass;
    return true;
  }
  /// Makes the level of the macro call with this tag the present one; a new pass begins with its arguments.
  void select(std::uint64_t tag, std::uint32_t pass);
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
  void add(const NumberRanges::Range& range, bool is_permanent);

  std::vector<Level> levels_{{0, 1, no_locals(), no_locals(), {}}};
  std::size_t present_ = 0;  // the level in force; a requested call may wait above it
  std::vector<Area> areas_;
  std::vector<std::pair<std::uint32_t, double>> given_;
  ig::RowOrigins<std::uint32_t> rows_;
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
