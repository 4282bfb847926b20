/// What all canned cycles share: the words of a call, the levels, the holes, the feed (Fanuc manual, "Canned cycle").
///
/// CannedCycleResolveSyntax leaves a *resolved call* in Parsing.Gxx, which the cycle syntaxes carry out: X, Y, Z and R
/// are absolute positions in mm; Q, P, I and J are as programmed; K is the number of holes and is there only where the
/// block repeats the cycle. Where the call holds L, L is the number of holes and K a length. Under G91 the holes of a
/// repeat lie CannedCycle.Increment apart.
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
/// The words that every cycle code owns. P is as programmed (option `p-unit`); K and L are counts, so their unit is 1.
inline constexpr std::string_view cycle_words = "X Y Z R Q P[] I J K[1] L[1] F";

/// The words of one call, indexed by address. operator[] gives nothing for a word that the call does not hold.
struct CycleWords {
  enum Address : std::size_t { X, Y, Z, R, Q, P, I, J, K, L, F, address_count };  // the order of cycle_words
  std::uint32_t mask = 0;
  std::array<ig_value, address_count> values;  ///< those that the mask names

  CycleWords() {}  // NOLINT(modernize-use-equals-default): it would set all values to 0 in each call

  bool has(std::size_t address) const { return (mask >> address & 1u) != 0; }
  std::optional<double> operator[](std::size_t address) const {
    return has(address) ? std::optional(values[address].number) : std::nullopt;
  }
  double get_or(std::size_t address, double fallback) const { return has(address) ? values[address].number : fallback; }
};

/// The largest number of repeats of one block; a larger K or L is limited to it.
inline constexpr int most_repeats = 10'000;

/// The largest number of steps that one block may append: a limit of the host.
inline constexpr std::int64_t most_steps = 100'000;

/// R level and bottom of a cycle as positions on the tool axis, in mm; empty where neither this block nor an earlier
/// one gave it.
struct CycleLevels {
  std::optional<double> r, bottom;
};

/// Positions of R and bottom. G90: the words are positions. G91: R is a distance from the initial level and the bottom
/// a distance from R; a new R alone moves the kept bottom along with it.
constexpr CycleLevels resolve_levels(const CycleLevels& given, const CycleLevels& kept, double initial_level,
                                     bool is_incremental) {
  CycleLevels out = kept;
  if (!is_incremental) {
    if (given.r) out.r = *given.r;
    if (given.bottom) out.bottom = *given.bottom;
    return out;
  }
  if (given.r) out.r = initial_level + *given.r;
  if (given.bottom) {
    if (out.r) out.bottom = *out.r + *given.bottom;
  } else if (given.r && kept.r && kept.bottom) {
    out.bottom = *out.r + (*kept.bottom - *kept.r);
  }
  return out;
}

/// One hole, in mm of program coordinates.
struct CycleHole {
  PlaneAxes plane;
  Vec3 position;          ///< of the hole; its component along the tool axis is not used
  double approach_level;  ///< level at which the tool travels to the hole, mm
  Vec3 at(double level) const { return plane.at_level(position, level); }
};

/// The level to which a cycle under G98 returns. A member of the syntaxes that need it.
class CycleReturnLevel {
 public:
  /// In mm, along the tool axis `axis` (0 X, 1 Y, 2 Z) on which the tool is at `tool`: along Z the level that the
  /// program names for all cycles (Okuma: G71 with M53), else the initial level, where a cycle has one, else `tool`.
  double operator()(const Block& b, std::size_t axis, double tool) const {
    if (axis == 2 && b.is_raised(is_named_) && b.has(named_)) return b.get_or(named_, tool);
    return b.get_or(initial_, tool);
  }

 private:
  In<double> initial_{"CannedCycle.InitialLevel"};
  Field<double> named_{"CannedCycle.ReturnLevel",
                       read,
                       {Life::modal, "mm", "Level to which the cycles return where the program names it."}};
  Signal is_named_{"CannedCycle.~ReturnToNamedLevel", read, Life::modal};
};

/// A resolved call, ready to be carried out. Lengths and levels in mm of program coordinates.
struct CycleRun {
  CycleRun() {}  // NOLINT(modernize-use-equals-default): it would set all of it to 0 first

  Symbol code;
  std::size_t row = 0;  ///< index of the code in the list that the syntax gave
  CycleWords words;
  PlaneAxes plane;
  Vec3 start;                          ///< where the tool is at the start of the block
  Vec3 first;                          ///< the first hole
  Vec3 increment;                      ///< from hole to hole
  int count = 1;                       ///< number of holes, 1 to most_repeats
  std::optional<PolarRepeats> turned;  ///< replaces `increment` where G16 rotates the holes
  double r_level = 0;
  double bottom = 0;
  double return_level = 0;         ///< G98: the initial level; G99: R
  bool returns_to_initial = true;  ///< G98

  CycleHole hole(int i) const {
    const Vec3 position = turned ? turned->hole(first, i, plane) : first + static_cast<double>(i) * increment;
    return {plane, position, i == 0 ? start[plane.tool] : return_level};
  }
};

/// A member of each cycle syntax. It declares the codes with their words, and it takes them from the block.
class CannedCycle {
 public:
  explicit CannedCycle(std::initializer_list<std::string_view> codes)
      : call_(codes, cycle_words, ig::take | wake, cycle_kind) {}

  /// Takes the call of this block; nothing where the block holds none of the codes. Puts the F of the call in force and
  /// begins the compound motion. Reports a negative P (ISO-0337) and drops it, and an F that is not positive.
  std::optional<CycleRun> take(Block& b) const {
    // The one that is returned: it would be copied otherwise. Without a value it would be set to 0 first, byte by byte.
    std::optional<CycleRun> result(std::in_place);
    std::uint32_t found = 0;
    const std::int32_t row = b.take_code(call_.codes(), call_.code_count(), &found);
    if (row < 0) {
      result.reset();
      return result;
    }
    const auto code = static_cast<std::size_t>(row);
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
    run.count = static_cast<int>(std::fmin(std::fmax(words.get_or(counter, 1), 1), most_repeats));
    words.mask &= ~(1u << counter);  // a K that remains here is the Z component of a vector
    if (run.count > 1) {
      run.increment = b.get(increment_).or_else({});
      run.turned = polar_repeats_(b, run.plane);
    }
    const double level = run.start[run.plane.tool];
    run.bottom = run.first[run.plane.tool];
    run.r_level = words.get_or(CycleWords::R, level);
    run.returns_to_initial = !b.is(return_mode_, g99_);
    run.return_level = run.returns_to_initial ? level_(b, run.plane.tool, level) : run.r_level;
    feed_.resolve(b, words[CycleWords::F], where(run, CycleWords::F));
    if (words.get_or(CycleWords::P, 0) < 0) {
      b.report(diag("ISO-0337"), where(run, CycleWords::P), b.text(run.code), words.get_or(CycleWords::P, 0));
      words.mask &= ~(1u << CycleWords::P);
    }
    motion.begin(b, run.code);
    return result;
  }

  /// The feed for a stroke of `length_mm`, in mm/s; 0, with a diagnostic, where no feed is in force. Under G93 a stroke
  /// without length has feed 0 without a diagnostic.
  double stroke_feed(Block& b, double length_mm) const {
    const double mmds = feed_.mmds(b, [length_mm] { return length_mm; });
    if (mmds > 0) return mmds;
    if (!feed_.value(b) || !feed_.is_inverse_time(b)) feed_.report_missing(b);
    return mmds;
  }

  /// Reports (ISO-0354) each of P, Q, I, J and K that this block programs, that is not 0 and that is not one of the
  /// letters in `used`.
  void report_unused(Block& b, const CycleRun& run, std::string_view used) const {
    constexpr std::string_view letters = "PQIJK";
    constexpr std::array addresses{CycleWords::P, CycleWords::Q, CycleWords::I, CycleWords::J, CycleWords::K};
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const double value = run.words.get_or(addresses[i], 0);
      if (value == 0 || used.find(letters[i]) != std::string_view::npos || !b.is_fresh(stored_[i])) continue;
      b.report(diag("ISO-0354"), where(run, addresses[i]), b.text(run.code), letters.substr(i, 1), value);
    }
  }

  /// The place for a diagnostic: the cycle code of the call, or its word with that address.
  Where where(const CycleRun& run) const { return Where::word(call_.code(run.row)); }
  Where where(const CycleRun& run, CycleWords::Address address) const {
    return Where::word(call_.row(run.row)[address]);
  }

  /// Leaves the tool at the return level of the last hole.
  void end(Block& b, const CycleRun& run) const { b.set(program_, run.hole(run.count - 1).at(run.return_level)); }

  CompoundMotion motion;

 private:
  Call call_;
  Xyz increment_{"CannedCycle.Increment", read, {Life::block, "mm", "From hole to hole of a repeat."}};
  std::array<In<double>, 5> stored_{In<double>{"CannedCycle.Params.P"}, In<double>{"CannedCycle.Params.Q"},
                                    In<double>{"CannedCycle.Params.I"}, In<double>{"CannedCycle.Params.J"},
                                    In<double>{"CannedCycle.Params.K"}};
  In<Symbol> return_mode_{"CannedCycle.ReturnMode"};
  CycleReturnLevel level_;
  Xyz program_{"ProgramXyz", write};
  Name g99_{"G99"};
  FeedInForce feed_{read | write};
  PlaneInForce plane_;
  PolarRepeatsInForce polar_repeats_;
  LastProgramXyz last_;
};

/// P of a cycle as a time. The option `p-unit` tells whether the control reads P in seconds or in milliseconds.
class CycleDwell {
 public:
  /// The dwell in seconds; 0 without P.
  double seconds(const CycleRun& run) const {
    const double p = run.words.get_or(CycleWords::P, 0);
    return unit_ == Unit::milliseconds ? p / 1000 : p;
  }

 private:
  enum class Unit { seconds, milliseconds };
  Choice<Unit> unit_{"p-unit", "s|ms", "s", "What P counts."};
};

}  // namespace ig::cnc
