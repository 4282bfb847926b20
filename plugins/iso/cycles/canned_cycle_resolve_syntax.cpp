/// Turns what a block says of a canned cycle into a resolved call: every hole becomes Parsing.Gxx {X Y Z R …}, absolute
/// and complete, so that the cycle syntaxes know nothing of modality, of G91 or of missing words.
///
/// A cycle is modal: it stays on, with its R, Z, Q, P, I and J, until G80 or a motion code of group 01, and drills in
/// every block that names X, Y, Z, R or a rotary axis. Fanuc manual, "Canned cycle".
#include "cycles/cycle_mode.hpp"
#include "cycles/field_writes.hpp"
#include "cycles/hole_repeats.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

using Address = CycleWords::Address;

/// What Q is, for each cycle of the resolver: peck, tapping in pecks, shift, nothing.
constexpr char use_of_q(std::size_t row) {
  constexpr std::string_view known = "ptss--pt--s--";
  return row < known.size() ? known[row] : '?';
}

struct CannedCycleResolve {
  static constexpr auto spec =
      ig::syntax("CannedCycleResolveSyntax",
                 "Resolves canned cycle calls: modal words, G91, missing words, G98/G99, repeats.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax",
                 "FeedrateSyntax", "IsoCoordinateOffsetSyntax", "IsoLocalCoordinateOffsetSyntax",
                 "ToolHeightOffsetSyntax")
          .before("DrillingCycleSyntax", "IncrementalResolveSyntax", "MachineCoordSelectSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0310", "{0} and {1} are in the same block: {2}, the later one, is executed"),
      ig::diagnostic(IG_ERROR, "ISO-0311",
                     "{0} without {1}, and none was programmed since the cycle began: nothing is drilled"),
      ig::diagnostic(IG_WARNING, "ISO-0312",
                     "{0} without {1}, and none was programmed since the cycle began: the tool position is assumed"),
      ig::diagnostic(IG_ERROR, "ISO-0313",
                     "{0}{1} is not a whole number of holes, zero or greater: one hole is drilled"),
      ig::diagnostic(IG_ERROR, "ISO-0314", "{0}{1} is more holes than one block may drill: only {2} are drilled"),
      ig::diagnostic(IG_WARNING, "ISO-0315", "K and L are in the same block: K is the number of holes, so remove L"),
      ig::diagnostic(IG_WARNING, "ISO-0338",
                     "the plane changes while {0} is active: program R and the bottom of the hole again"),
      ig::diagnostic(IG_WARNING, "ISO-0514",
                     "{0}: the bottom lies {1} mm above R, so the tool is fed away from the part"),
  };

  CycleBlock block_;
  CycleMode mode_;
  CycleData data_;
  // The cycles share one store for Q: a depth of cut may become a shift.
  ig::Signal q_of_another_use_{"CannedCycle.~QOfAnotherUse", ig::write};
  PlaneInForce plane_;
  ig::In<ig::Symbol> plane_term_{"PlaneSelect.Term"};
  ig::Previous<ig::Symbol> plane_before_{"PlaneSelect.Term"};
  ig::Name g17_{"G17"};
  DistanceMode distance_;
  LastProgramXyz last_;
  ig::Name g77_{"G77"}, g87_{"G87"};

  enum class MissingAxis { last_position, error, error_without_depth };
  ig::Choice<MissingAxis> missing_{"missing-axis", "last-position|error|error-without-depth", "last-position",
                                   "What a first block without Z or R does: use the tool position; drill nothing; or "
                                   "use the tool position for R and drill nothing without Z."};
  HoleRepeats repeats_;
  enum class BareP { as_written, milliseconds };
  ig::Choice<BareP> bare_p_{
      "p-without-point", "as-written|ms", "as-written",
      "P without a decimal point: kept as written, or read as milliseconds and converted to seconds."};
  enum class ZeroRepeats { keep_data, position };
  ig::Choice<ZeroRepeats> zero_repeats_{"zero-repeats", "keep-data|position", "keep-data",
                                        "What a cycle block with K0 or L0 does: nothing, or a rapid to X and Y."};
  ig::CompoundMotion motion_;
  ig::Xyz program_{"ProgramXyz", ig::write};

  ig::Status build(ig::Block& b) {
    const bool has_mode = data_.take_return_mode(b);
    ActiveCycle now = mode_.enter_or_cancel(b, block_, data_);
    if (now.cycle && !now.is_entry && plane_changes(b)) forget_levels(b, now);
    bool drills = false;
    if (now.cycle) {
      CycleWords in = block_.given(b, now);
      drills = block_.is_hole(b, now, in);
      if (drills)
        drill(b, now, in);
      else if (now.is_called)
        enter_without_hole(b, now);
    }
    return drills || now.is_called || now.changed || has_mode ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool plane_changes(const ig::Block& b) const {
    return b.is_fresh(plane_term_) && !b.is(plane_term_, b.get_or(plane_before_, static_cast<ig::Symbol>(g17_)));
  }

  double level_of_tool(ig::Block& b) const { return last_(b)[plane_(b).tool]; }

  void forget_levels(ig::Block& b, ActiveCycle& now) const {
    b.report(ig::diag("ISO-0338"), ig::Where::block(), b.text(block_.name(now)));
    data_.forget_levels(b, level_of_tool(b));
    now.changed = true;
  }

  /// The cycle is on from here, but nothing is drilled and none of Q, P, I, J is kept: they stay, to be reported.
  void enter_without_hole(ig::Block& b, const ActiveCycle& now) const {
    block_.erase_codes(b);
    repeats_.drop_count(b, block_.words(now));
    block_.take_feed(b, *now.cycle);
    data_.enter(b, now, block_.name(now), level_of_tool(b));
  }

  void drill(ig::Block& b, const ActiveCycle& now, CycleWords& in) const {
    if (bare_p_ == BareP::milliseconds && in.has(Address::P)) read_bare_p(b, block_.words(now)[Address::P], in);
    const PlaneAxes plane = plane_(b);
    const bool incremental = distance_.is_incremental(b);
    const ig::Vec3 start = last_(b);
    if (repeats_.k_is_length()) data_.end_other_way_to_peck(b, in);
    const double level = data_.initial_level(b, now, start[plane.tool]);
    const CycleLevels kept = data_.levels(b, plane.tool);
    CycleLevels levels = resolve_levels({in[Address::R], in[plane.tool]}, kept, level, incremental);
    const bool complete = levels.r && levels.bottom;
    const bool fills = takes_position(levels.bottom || (incremental && in.has(plane.tool)));
    const int count = repeats_.count(b, block_.words(now), in);
    if (count > 1 && incremental) repeats_.keep_turns(b, block_, count);
    if (!complete && count > 0) {
      const std::optional<double> depth = incremental ? in[plane.tool] : std::nullopt;
      levels = fill(b, now, "XYZ"[plane.tool], levels, start[plane.tool], depth, fills);
    }

    ig::Vec3 hole = start, step;
    for (const std::size_t axis : {plane.first, plane.second}) {
      const double word = in.get_or(axis, incremental ? 0 : start[axis]);
      hole[axis] = incremental ? start[axis] + word : word;
      step[axis] = incremental ? word : 0;
    }
    if (count > 1) step = repeats_.step(b, step);

    if (count > 0 && complete && (now.is_called || in.has(Address::R) || in.has(plane.tool)))
      report_upward(b, block_.name(now), levels);
    const bool drills = count > 0 && (complete || fills);
    const ResolvedHole resolved{block_.name(now), plane, hole, levels, level, count, step, drills};
    data_.store(b, now, in, resolved, repeats_.kept_words());
    if (drills)
      call(b, now, in, resolved);
    else
      block_.swallow(b, now);
    const bool passes_by = count == 0 && zero_repeats_ == ZeroRepeats::position;
    if (passes_by && (in.has(plane.first) || in.has(plane.second))) position(b, block_.name(now), hole);
  }

  /// "P500" is half a second, and "P5." five of them.
  static void read_bare_p(ig::Block& b, ig_field field, CycleWords& words) {
    ig_word word{};
    b.word(field, word);
    if ((word.flags & IG_WORD_WITHOUT_POINT) == 0) return;
    words.values[Address::P].number /= 1000;
    b.rewrite(field, words.values[Address::P]);
  }

  /// Whether the tool's position stands for what the first block leaves out.
  bool takes_position(bool has_depth) const {
    return missing_ == MissingAxis::last_position || (missing_ == MissingAxis::error_without_depth && has_depth);
  }

  /// A first block without Z or R; `depth` is the bottom from R, under G91.
  CycleLevels fill(ig::Block& b, const ActiveCycle& now, char tool_axis, CycleLevels levels, double position,
                   std::optional<double> depth, bool fills) const {
    const bool lacks_depth = missing_ == MissingAxis::error_without_depth && !fills;
    const char missing = levels.r || lacks_depth ? tool_axis : 'R';
    const ig::DiagnosticCode what = fills ? ig::diag("ISO-0312") : ig::diag("ISO-0311");
    b.report(what, ig::Where::word(block_.calls().code(*now.cycle)), b.text(block_.name(now)),
             std::string_view(&missing, 1));
    if (!fills) return levels;
    if (!levels.r) levels.r = position;
    if (!levels.bottom) levels.bottom = depth ? *levels.r + *depth : position;
    return levels;
  }

  /// Back boring is meant to go up: G87, and G77 where it has that number.
  void report_upward(ig::Block& b, ig::Symbol cycle, const CycleLevels& levels) const {
    const double height = *levels.bottom - *levels.r;
    if (height > 0 && cycle != g77_ && cycle != g87_)
      b.report(ig::diag("ISO-0514"), ig::Where::block(), b.text(cycle), height);
  }

  /// Round an obstacle: to the place of a hole, at the level where the tool is, without drilling.
  void position(ig::Block& b, ig::Symbol cycle, const ig::Vec3& hole) const {
    motion_.begin(b, cycle);
    motion_.rapid_to(b, hole);
    b.set(program_, hole);
  }

  /// The resolved call, for the syntax of the cycle.
  void call(ig::Block& b, const ActiveCycle& now, const CycleWords& in, const ResolvedHole& hole) const {
    const std::size_t row = *now.cycle;
    const ig_field* const words = block_.calls().row(row);
    if (!now.is_called) {
      block_.swallow(b, now);
      b.set_call(block_.calls(), row);
    }
    const auto is_in_place = [&](std::size_t address) { return now.is_called && in.has(address); };
    FieldWrites writes;
    const auto put = [&](std::size_t address, double value) {
      is_in_place(address) ? b.rewrite(words[address], value) : writes.add(words[address], value);
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
      put(axis, axis == hole.plane.tool ? *hole.levels.bottom : hole.position[axis]);
    put(Address::R, *hole.levels.r);
    const auto kept = repeats_.kept_words();
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (const auto value = data_.value(b, i); value && !is_in_place(kept[i])) put(kept[i], *value);
    writes.set(b);
    if (now.before && !in.has(Address::Q) && data_.has_q(b) && use_of_q(*now.before) != use_of_q(row))
      b.raise(q_of_another_use_);
    repeats_.put_count(b, words, in, hole.count, [&](std::size_t address, double value) {
      is_in_place(address) ? b.rewrite(words[address], value) : b.set(words[address], value);
    });
    if (hole.count != 1) repeats_.put_step(b, hole.step);
  }
};

const ig::Register<CannedCycleResolve> canned_cycle_resolve_syntax;

}  // namespace
}  // namespace iso
