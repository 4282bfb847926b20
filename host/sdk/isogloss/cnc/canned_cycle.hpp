/// What all canned cycles share: the words of their call, their levels, their holes.
///
/// CannedCycleResolveSyntax leaves a *resolved call* in Parsing.Gxx: X Y Z R absolute; Q P I J F as given; K only where
/// the block repeats the cycle, the number of holes. Where the call holds L, that is the number of holes, and K a
/// length. Under G91 the holes of a repeat lie CannedCycle.Increment apart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/cycle_codes.hpp"
#include "isogloss/cnc/feed.hpp"
#include "isogloss/cnc/peck_strokes.hpp"
#include "isogloss/cnc/plane.hpp"
#include "isogloss/cnc/program_xyz.hpp"
#include "isogloss/cnc/scale_and_mirror.hpp"

namespace ig::cnc {

inline const Diagnostics canned_cycle_diagnostics{
    diagnostic(
        IG_ERROR, "ISO-0337", "{0} with P{1}: a dwell cannot be negative, so the cycle does not dwell",
        "P is the time that the tool dwells at the bottom of the hole: seconds, or milliseconds on a Fanuc control.",
        "G82 X10. Y10. Z-20. R2. P-500 F100"),
    diagnostic(IG_WARNING, "ISO-0354", "{0}: {1}{2} has no effect in this cycle",
               "The control accepts the word without an alarm and keeps it for a later cycle of the same run of "
               "holes. In this cycle the word does nothing: a Fanuc control does not dwell in G73, G81, G83, G85 "
               "and G86, whatever P is. It does dwell in G82 and G89.",
               "G83 X10. Y10. Z-20. R2. Q5. P500 F100"),
};

/// The words that every cycle code owns. P is as programmed (p-unit), K and L are counts.
inline constexpr std::string_view cycle_words = "X Y Z R Q P[] I J K[1] L[1] F";

/// The words of one call, by address.
struct CycleWords {
  enum Address : std::size_t { X, Y, Z, R, Q, P, I, J, K, L, F, address_count };  // the order of cycle_words
  std::uint32_t mask = 0;
  std::array<ig_value, address_count> values;

  bool has(std::size_t address) const { return (mask >> address & 1u) != 0; }
  std::optional<double> operator[](std::size_t address) const {
    return has(address) ? std::optional(values[address].number) : std::nullopt;
  }
  double get_or(std::size_t address, double fallback) const { return has(address) ? values[address].number : fallback; }
};

/// No block repeats a cycle more often.
inline constexpr int most_repeats = 10'000;

/// Most steps that one block may write; the engine takes no more.
inline constexpr std::int64_t most_steps = 100'000;

/// R and Z of a cycle, given or kept from before, on their way to positions of the tool axis.
struct CycleLevels {
  std::optional<double> r, bottom;
};

/// G90: positions. G91: R counts from the initial level, the bottom from R; a new R moves a bottom that was kept.
constexpr CycleLevels resolve_levels(const CycleLevels& given, const CycleLevels& kept, double initial_level,
                                     bool is_incremental) {
  if (!is_incremental) return {given.r ? given.r : kept.r, given.bottom ? given.bottom : kept.bottom};
  CycleLevels out = kept;
  if (given.r) out.r = initial_level + *given.r;
  if (given.bottom) {
    if (out.r) out.bottom = *out.r + *given.bottom;
  } else if (given.r && kept.r && kept.bottom) {
    out.bottom = *out.r + (*kept.bottom - *kept.r);
  }
  return out;
}

/// One hole of a cycle, or one of several.
struct CycleHole {
  PlaneAxes plane;
  Vec3 position;          ///< the tool axis of it says nothing
  double approach_level;  ///< where the tool travels to it
  Vec3 at(double level) const { return plane.at_level(position, level); }
};

/// A resolved call while its cycle is carried out.
struct CycleRun {
  Symbol code;
  std::size_t row = 0;  ///< of the code among those of the syntax
  CycleWords words;
  PlaneAxes plane;
  Vec3 start;                          ///< where the block begins
  Vec3 first;                          ///< the first hole
  Vec3 increment;                      ///< from hole to hole
  int count = 1;                       ///< holes
  std::optional<PolarRepeats> turned;  ///< instead of `increment`, where G16 turns the holes
  double r_level = 0;
  double bottom = 0;
  double return_level = 0;         ///< G98: the initial level; G99: R
  bool returns_to_initial = true;  ///< G98

  CycleHole hole(int i) const {
    const Vec3 position = turned ? turned->hole(first, i, plane) : first + static_cast<double>(i) * increment;
    return {plane, position, i == 0 ? start[plane.tool] : return_level};
  }
};

/// A member of each cycle syntax: its codes, taken with their words.
class CannedCycle {
 public:
  explicit CannedCycle(std::initializer_list<std::string_view> codes)
      : call_(codes, cycle_words, ig::take | wake, cycle_kind) {}

  /// The call of this block; its F is the feed from here on.
  std::optional<CycleRun> take(Block& b) const {
    std::uint32_t found = 0;
    const std::int32_t row = b.take_code(call_.codes(), call_.code_count(), &found);
    if (row < 0) return std::nullopt;
    const auto code = static_cast<std::size_t>(row);
    std::optional<CycleRun> result(std::in_place);
    CycleRun& run = *result;
    CycleWords& words = run.words;
    words.mask = b.take_many(call_.row(code), CycleWords::address_count, words.values.data());
    run.code = call_.name(code);
    run.row = code;
    run.plane = plane_(b);
    run.start = last_(b);
    run.first = {words.get_or(CycleWords::X, run.start.x), words.get_or(CycleWords::Y, run.start.y),
                 words.get_or(CycleWords::Z, run.start.z)};
    const auto counter = words.has(CycleWords::L) ? CycleWords::L : CycleWords::K;
    run.count = static_cast<int>(std::clamp(words.get_or(counter, 1), 1.0, double{most_repeats}));
    words.mask &= ~(1u << counter);  // what is left of K is a length
    if (run.count > 1) {
      run.increment = b.get(increment_).or_else({});
      run.turned = polar_repeats_(b, run.plane);
    }
    const double level = run.start[run.plane.tool];
    run.bottom = run.first[run.plane.tool];
    run.r_level = words.get_or(CycleWords::R, level);
    run.returns_to_initial = !b.is(return_mode_, g99_);
    run.return_level = run.returns_to_initial ? b.get_or(initial_level_, level) : run.r_level;
    feed_.resolve(b, words[CycleWords::F], where(run, CycleWords::F));
    if (words.get_or(CycleWords::P, 0) < 0) {
      b.report(diag("ISO-0337"), where(run, CycleWords::P), b.text(run.code), words.get_or(CycleWords::P, 0));
      words.mask &= ~(1u << CycleWords::P);
    }
    motion.begin(b, run.code);
    return result;
  }

  /// mm/s for a stroke of that length; says so where no feed is in force. 0 under G93 where the stroke has no length.
  double stroke_feed(Block& b, double length_mm) const {
    const double mmds = feed_.mmds(b, [length_mm] { return length_mm; });
    if (mmds > 0) return mmds;
    if (!feed_.value(b) || !feed_.is_inverse_time(b)) feed_.say_missing(b);
    return mmds;
  }

  /// Of P, Q, I, J and K those that this block names and the cycle does not use.
  void say_unused(Block& b, const CycleRun& run, std::string_view used) const {
    constexpr std::string_view letters = "PQIJK";
    constexpr std::array addresses{CycleWords::P, CycleWords::Q, CycleWords::I, CycleWords::J, CycleWords::K};
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const double value = run.words.get_or(addresses[i], 0);
      if (value == 0 || used.find(letters[i]) != std::string_view::npos || !b.is_fresh(stored_[i])) continue;
      b.report(diag("ISO-0354"), where(run, addresses[i]), b.text(run.code), letters.substr(i, 1), value);
    }
  }

  /// The cycle code of the call, or its word with that address, for a diagnostic.
  Where where(const CycleRun& run) const { return Where::word(call_.code(run.row)); }
  Where where(const CycleRun& run, CycleWords::Address address) const {
    return Where::word(call_.row(run.row)[address]);
  }

  /// The tool stands at the return level of the last hole.
  void end(Block& b, const CycleRun& run) const { b.set(program_, run.hole(run.count - 1).at(run.return_level)); }

  CompoundMotion motion;

 private:
  Call call_;
  Xyz increment_{"CannedCycle.Increment", read, {Life::block, "mm", "From hole to hole of a repeat."}};
  std::array<In<double>, 5> stored_{In<double>{"CannedCycle.Params.P"}, In<double>{"CannedCycle.Params.Q"},
                                    In<double>{"CannedCycle.Params.I"}, In<double>{"CannedCycle.Params.J"},
                                    In<double>{"CannedCycle.Params.K"}};
  In<Symbol> return_mode_{"CannedCycle.ReturnMode"};
  In<double> initial_level_{"CannedCycle.InitialLevel"};
  Xyz program_{"ProgramXyz", write};
  Name g99_{"G99"};
  FeedInForce feed_{read | write};
  PlaneInForce plane_;
  PolarRepeatsInForce polar_repeats_;
  LastProgramXyz last_;
};

/// P of a cycle: seconds or milliseconds, as the control has it.
class CycleDwell {
 public:
  /// Seconds; 0 without P.
  double seconds(const CycleRun& run) const {
    const double p = run.words.get_or(CycleWords::P, 0);
    return unit_ == Unit::milliseconds ? p / 1000 : p;
  }

 private:
  enum class Unit { seconds, milliseconds };
  Choice<Unit> unit_{"p-unit", "s|ms", "s", "What P counts."};
};

}  // namespace ig::cnc
