/// Turns what a block says of a canned cycle into a resolved call: every hole becomes Parsing.Gxx {X Y Z R …}, absolute
/// and complete, so that the cycle syntaxes know nothing of modality, of G91 or of missing words.
///
/// A cycle is modal: it stays on, with its R, Z, Q, P, I and J, until G80 or a motion code of group 01, and drills in
/// every block that names X, Y, Z, R or a rotary axis. Fanuc manual, "Canned cycle".
#include <cmath>

#include <isogloss/cnc/canned_cycle.hpp>
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

using Address = CycleWords::Address;
constexpr std::array stored{Address::Q, Address::P, Address::I, Address::J, Address::K};  // kept besides the levels

/// What Q is, for each cycle of the resolver: peck, tapping in pecks, shift, nothing.
constexpr char use_of_q(std::size_t row) {
  constexpr std::string_view known = "ptss--pt--s--";
  return row < known.size() ? known[row] : '?';
}

/// The cycle words of a block that names no cycle code, in the order of cycle_words; F is FeedrateSyntax's.
class RootWords {
 public:
  static constexpr std::string_view letters = "XYZRQPIJKL";
  RootWords() {
    std::string path = "Parsing.?";
    for (std::size_t i = 0; i < letters.size(); ++i) {
      path.back() = letters[i];
      ids_[i] = ig::Word(path, ig::write).id();
    }
  }
  const ig_field* ids() const { return ids_.data(); }

 private:
  std::array<ig_field, letters.size()> ids_{};
};

enum class InitialLevel { previous, cycle_entry };
enum class MissingAxis { last_position, error, error_without_depth };
enum class RepeatWord { k_or_l, l };
enum class BareP { as_written, milliseconds };
enum class ZeroRepeats { keep_data, position };

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

  CycleCalls call_{cycle_words, ig::take | ig::wake | ig::write};
  ig::Codes g80_{"G80"};
  ig::Codes group01_{{"G00", "G01", "G02", "G03", "G33"}, ig::read};
  // Codes that have the axis words of their block for themselves.
  ig::Codes one_shot_{{"G31", "G53", "G60"}, ig::read};
  ig::Codes return_codes_{"G98", "G99"};
  RootWords root_;
  // Axes that are positioned before the hole; not the resolver's to take.
  std::array<ig_field, 3> rotary_{rotary_word("Parsing.A"), rotary_word("Parsing.B"), rotary_word("Parsing.C")};

  ig::InWhile<ig::Symbol> term_{"CannedCycle.Term", nullptr, ig::write};
  ig::Out<ig::Symbol> return_mode_{"CannedCycle.ReturnMode"};
  ig::Out<double> initial_level_{"CannedCycle.InitialLevel"};
  ig::Xyz hole_{"CannedCycle.Params", ig::read | ig::write};
  ig::Out<double> r_{"CannedCycle.Params.R"};
  std::array<ig::Out<double>, stored.size()> kept_{
      ig::Out<double>{"CannedCycle.Params.Q"}, ig::Out<double>{"CannedCycle.Params.P"},
      ig::Out<double>{"CannedCycle.Params.I"}, ig::Out<double>{"CannedCycle.Params.J"},
      ig::Out<double>{"CannedCycle.Params.K"}};
  ig::Xyz increment_{"CannedCycle.Increment", ig::write, {ig::Life::block, "mm", "From hole to hole of a repeat."}};
  std::array<ig::Out<double>, 3> turn_{ig::Out<double>{"CannedCycle.Increment.A", turn},
                                       ig::Out<double>{"CannedCycle.Increment.B", turn},
                                       ig::Out<double>{"CannedCycle.Increment.C", turn}};
  ig::Out<std::int64_t> repeats_{"CannedCycle.Repeats",
                                 {ig::Life::block, "", "Holes of a repeat that turns rotary axes."}};
  // The cycles share one store for Q: a depth of cut may become a shift.
  ig::Signal q_of_another_use_{"CannedCycle.~QOfAnotherUse", ig::write};
  // Group 10 outlives the cycles, CannedCycle.ReturnMode does not.
  ig::Signal return_to_r_{"CannedCycle.~ReturnToR", ig::read | ig::write, ig::Life::modal};

  ig::Xyz pattern_{"HolePattern.Step", ig::read};
  FeedInForce feed_{ig::read | ig::write};
  PlaneInForce plane_;
  ig::In<ig::Symbol> plane_term_{"PlaneSelect.Term"};
  ig::Previous<ig::Symbol> plane_before_{"PlaneSelect.Term"};
  ig::Name g17_{"G17"};
  DistanceMode distance_;
  LastProgramXyz last_;
  ig::Name g98_{"G98"}, g99_{"G99"}, cancelled_{"G80"}, g77_{"G77"}, g87_{"G87"};

  ig::Choice<InitialLevel> level_rule_{"initial-level", "previous|cycle-entry", "previous",
                                       "The initial level, to which G98 returns and from which R counts under G91: the "
                                       "tool position before the block, or the one before the cycle began."};
  ig::Choice<MissingAxis> missing_{"missing-axis", "last-position|error|error-without-depth", "last-position",
                                   "What a first block without Z or R does: use the tool position; drill nothing; or "
                                   "use the tool position for R and drill nothing without Z."};
  ig::IntegerOption max_repeats_{
      "max-repeats", "10000", {1, most_repeats}, "Holes that one block may drill by K or L."};
  ig::Choice<RepeatWord> repeat_word_{"repeat-word", "k-or-l|l", "k-or-l",
                                      "The word that counts the holes of a block: K, or L where K is missing; or L "
                                      "alone, if K is a length of the cycle."};
  ig::Choice<BareP> bare_p_{
      "p-without-point", "as-written|ms", "as-written",
      "P without a decimal point: kept as written, or read as milliseconds and converted to seconds."};
  ig::Choice<ZeroRepeats> zero_repeats_{"zero-repeats", "keep-data|position", "keep-data",
                                        "What a cycle block with K0 or L0 does: nothing, or a rapid to X and Y."};
  ig::CompoundMotion motion_;
  ig::Xyz program_{"ProgramXyz", ig::write};
  /// K is kept where it is a word of the cycle.
  std::size_t stored_count_ = repeat_word_ == RepeatWord::l ? stored.size() : stored.size() - 1;

  ig::Status build(ig::Block& b) {
    const bool has_mode = take_return_mode(b);
    Group09 now = enter_or_cancel(b);
    if (now.cycle && !now.is_entry && plane_changes(b)) forget_levels(b, now);
    const bool drills = now.cycle && is_hole(b, now);
    if (drills)
      drill(b, now);
    else if (now.is_called)
      enter_without_hole(b, now);
    return drills || now.is_called || now.changed || has_mode ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static constexpr ig::About turn{ig::Life::block, "deg", "From hole to hole of a repeat."};

  /// The cycle that is on in this block, if any.
  struct Group09 {
    std::optional<std::size_t> cycle;  // row of call_
    bool is_called = false;            // by its code in this block, whose words are in Parsing.Gxx
    bool is_entry = false;             // the mode was off before
    bool changed = false;
    std::optional<std::size_t> before;  // the cycle that was on, if it is called in this block
  };

  bool take_return_mode(ig::Block& b) const {
    const auto mode = take_modal(b, return_codes_);
    if (!mode) return false;
    if (return_codes_.name(*mode) == g99_)
      b.raise(return_to_r_);
    else
      b.erase(return_to_r_);
    if (b.has(return_mode_)) b.amend(return_mode_, return_codes_.name(*mode));
    return true;
  }

  ig::Symbol return_mode(ig::Block& b) const {
    const ig::Symbol unsaid = b.is_raised(return_to_r_) ? g99_ : g98_;
    return b.get_or(return_mode_, unsaid);
  }

  static std::int64_t ordinal(const ig::Block& b, ig_field code) {
    ig_value v;
    return b.get(code, v) ? v.integer : 0;
  }

  /// The last code of the block wins, be it a cycle, G80 or a motion.
  Group09 enter_or_cancel(ig::Block& b) const {
    Group09 out;
    const ig::Symbol before = b.get_or(term_, ig::Symbol{});
    if (before == cancelled_) {  // shown in the cancelling block alone
      b.erase(term_);
      out.changed = true;
    }
    const bool was_on = before != ig::Symbol{} && before != cancelled_;
    const auto called = b.find(call_);
    if (was_on && called) out.before = row_of(before);
    const auto motion = b.find(group01_);
    const bool has_g80 = b.take(g80_).has_value();
    const std::int64_t at_motion = motion ? ordinal(b, group01_.id(*motion)) : 0;
    const std::int64_t at_end = std::max(at_motion, has_g80 ? ordinal(b, g80_.id(0)) : 0);
    const std::int64_t at_call = called ? ordinal(b, call_.code(*called)) : 0;

    if (called && motion)
      b.report(ig::diag("ISO-0310"), ig::Where::word(call_.code(*called)), b.text(call_.name(*called)),
               b.text(group01_.name(*motion)), b.text(at_call > at_end ? call_.name(*called) : group01_.name(*motion)));
    if (has_g80 || (motion && was_on)) {
      forget(b);
      b.set(term_, cancelled_);
      out.changed = true;
    }
    if (called && at_call > at_end) {
      out.cycle = called;
      out.is_called = true;
      out.is_entry = !was_on || at_end > 0;
    } else if (called) {
      give_back(b, *called);
      out.changed = true;
    } else if (was_on && at_end == 0) {
      out.cycle = row_of(before);
    }
    return out;
  }

  void forget(ig::Block& b) const {
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(hole_.id(axis));
    b.erase(r_);
    for (const auto& field : kept_) b.erase(field);
    b.erase(return_mode_);
    b.erase(initial_level_);
  }

  bool plane_changes(const ig::Block& b) const {
    return b.is_fresh(plane_term_) && !b.is(plane_term_, b.get_or(plane_before_, static_cast<ig::Symbol>(g17_)));
  }

  /// R, the bottom and the initial level lie on the axis of before; on another one they are not positions of the tool.
  void forget_levels(ig::Block& b, Group09& now) const {
    b.report(ig::diag("ISO-0338"), ig::Where::block(), b.text(call_.name(*now.cycle)));
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(hole_.id(axis));
    b.erase(r_);
    if (level_rule_ == InitialLevel::cycle_entry) b.amend(initial_level_, last_(b)[plane_(b).tool]);
    now.changed = true;
  }

  std::optional<std::size_t> row_of(ig::Symbol cycle) const {
    for (std::size_t row = 0; row < call_.code_count(); ++row)
      if (call_.name(row) == cycle) return row;
    return std::nullopt;
  }

  /// A motion code after the cycle code: it moves the axes and F is its feed; the rest is nobody's.
  void give_back(ig::Block& b, std::size_t row) const {
    erase_call(b);
    for (std::size_t axis = 0; axis < 3; ++axis) b.move(call_.row(row)[axis], root_.ids()[axis]);
    feed_.resolve(b, take_word(b, call_.row(row)[Address::F]));
  }

  /// No cycle syntax may find the code: to it a call without words is a hole where the tool stands.
  void erase_call(ig::Block& b) const {
    for (std::size_t row = 0; row < call_.code_count(); ++row) b.erase(call_.code(row));
  }
  static std::optional<double> take_word(ig::Block& b, ig_field word) {
    ig_value v;
    if (!b.take(word, v)) return std::nullopt;
    return v.number;
  }

  /// Where this block's cycle words stand: with the code, or by themselves.
  const ig_field* words(const Group09& now) const { return now.is_called ? call_.row(*now.cycle) : root_.ids(); }

  CycleWords given(ig::Block& b, const Group09& now) const {
    CycleWords out;
    out.mask = b.get_many(words(now), RootWords::letters.size(), out.values.data());
    if (bare_p_ == BareP::milliseconds && out.has(Address::P)) read_bare_p(b, words(now)[Address::P], out);
    return out;
  }

  /// A block drills when it names a position; M, S, T and F alone do not, nor do the words of G31, G53 and G60.
  bool is_hole(ig::Block& b, const Group09& now) const {
    if (!now.is_called && b.find(one_shot_)) return false;
    ig_value v[4];
    return b.get_many(words(now), 4, v) != 0 ||  // X Y Z R
           b.get_many(rotary_.data(), 3, v) != 0;
  }

  static ig_field rotary_word(const char* path) {
    return ig::Field<double>(path, ig::read, {ig::Life::standard, "deg", ""}).id();
  }

  /// Rotary words under G91 turn their axis before each hole; McAbcSyntax does.
  void keep_turns(ig::Block& b, int count) const {
    ig_value v[3];
    const std::uint32_t named = b.get_many(rotary_.data(), 3, v);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named >> axis & 1u) != 0) b.set(turn_[axis], v[axis].number);
    if (named != 0) b.set(repeats_, std::int64_t{count});
  }

  /// The cycle is on from here, but nothing is drilled and none of Q, P, I, J is kept: they stay, to be reported.
  void enter_without_hole(ig::Block& b, const Group09& now) const {
    erase_call(b);
    if (repeat_word_ == RepeatWord::k_or_l) take_word(b, words(now)[Address::K]);
    take_word(b, words(now)[Address::L]);
    feed_.resolve(b, take_word(b, words(now)[Address::F]));
    b.amend(term_, call_.name(*now.cycle));
    b.amend(return_mode_, return_mode(b));
    if (level_rule_ == InitialLevel::cycle_entry && now.is_entry) b.amend(initial_level_, last_(b)[plane_(b).tool]);
  }

  double initial_level(ig::Block& b, const Group09& now, double before) const {
    return level_rule_ == InitialLevel::cycle_entry && !now.is_entry ? b.get_or(initial_level_, before) : before;
  }

  void drill(ig::Block& b, const Group09& now) const {
    const std::size_t row = *now.cycle;
    const PlaneAxes plane = plane_(b);
    const bool incremental = distance_.is_incremental(b);
    const ig::Vec3 start = last_(b);
    const CycleWords in = given(b, now);
    end_other_way_to_peck(b, in);
    const double level = initial_level(b, now, start[plane.tool]);
    const ig::PartialVec3 old = b.get(hole_);
    const CycleLevels kept{b.get(r_), old.has(plane.tool) ? std::optional(old.value[plane.tool]) : std::nullopt};
    CycleLevels levels = resolve_levels({in[Address::R], in[plane.tool]}, kept, level, incremental);
    const bool complete = levels.r && levels.bottom;
    const bool fills = takes_position(levels.bottom || (incremental && in.has(plane.tool)));
    const int count = repeats(b, now, in);
    if (count > 1 && incremental) keep_turns(b, count);
    if (!complete && count > 0)
      levels = fill(b, row, "XYZ"[plane.tool], levels, start[plane.tool], in[plane.tool], incremental, fills);

    ig::Vec3 hole = start, step;
    for (const std::size_t axis : {plane.first, plane.second}) {
      const double word = in.get_or(axis, incremental ? 0 : start[axis]);
      hole[axis] = incremental ? start[axis] + word : word;
      step[axis] = incremental ? word : 0;
    }
    if (count > 1) step = b.get(pattern_).or_else(step);
    const bool drills = count > 0 && (complete || fills);

    if (count > 0 && complete && (now.is_called || in.has(Address::R) || in.has(plane.tool)))
      say_upward(b, row, levels);
    store(b, now, in, plane, hole, levels, level, drills);
    if (drills)
      call(b, now, in, plane, hole, levels, step, count);
    else
      swallow(b, now);
    const bool passes_by = count == 0 && zero_repeats_ == ZeroRepeats::position;
    if (passes_by && (in.has(plane.first) || in.has(plane.second))) position(b, call_.name(row), hole);
  }

  /// Back boring is meant to go up: G87, and G77 where it has that number.
  void say_upward(ig::Block& b, std::size_t row, const CycleLevels& levels) const {
    const double height = *levels.bottom - *levels.r;
    const ig::Symbol cycle = call_.name(row);
    if (height > 0 && cycle != g77_ && cycle != g87_)
      b.report(ig::diag("ISO-0514"), ig::Where::block(), b.text(cycle), height);
  }

  /// Round an obstacle: to the place of a hole, at the level where the tool is, without drilling.
  void position(ig::Block& b, ig::Symbol cycle, const ig::Vec3& hole) const {
    motion_.begin(b, cycle);
    motion_.rapid_to(b, hole);
    b.set(program_, hole);
  }

  /// Whether the tool's position stands for what the first block leaves out.
  bool takes_position(bool has_depth) const {
    return missing_ == MissingAxis::last_position || (missing_ == MissingAxis::error_without_depth && has_depth);
  }

  /// A first block without Z or R.
  CycleLevels fill(ig::Block& b, std::size_t row, char tool_axis, CycleLevels levels, double position,
                   std::optional<double> depth, bool incremental, bool fills) const {
    const bool lacks_depth = missing_ == MissingAxis::error_without_depth && !fills;
    const char missing = levels.r || lacks_depth ? tool_axis : 'R';
    const ig::DiagnosticCode what = fills ? ig::diag("ISO-0312") : ig::diag("ISO-0311");
    b.report(what, ig::Where::word(call_.code(row)), b.text(call_.name(row)), std::string_view(&missing, 1));
    if (!fills) return levels;
    if (!levels.r) levels.r = position;
    if (!levels.bottom) levels.bottom = incremental && depth ? *levels.r + *depth : position;
    return levels;
  }

  /// "P500" is half a second, and "P5." five of them.
  static void read_bare_p(ig::Block& b, ig_field field, CycleWords& words) {
    ig_word word{};
    b.word(field, word);
    if ((word.flags & IG_WORD_WITHOUT_POINT) == 0) return;
    words.values[Address::P].number /= 1000;
    b.rewrite(field, words.values[Address::P]);
  }

  /// Pecks are said by Q, or by I, J and K: where a block names one of them, what is kept of the other counts no more.
  void end_other_way_to_peck(ig::Block& b, const CycleWords& in) const {
    if (repeat_word_ == RepeatWord::k_or_l) return;
    if (in.has(Address::I) && !in.has(Address::Q)) b.erase(kept_[0]);
    if (in.has(Address::Q) && !in.has(Address::I))
      for (const std::size_t i : {2, 3, 4}) b.erase(kept_[i]);
  }

  /// K, or L where there is no K; 0: keep the data, drill nothing.
  int repeats(ig::Block& b, const Group09& now, const CycleWords& in) const {
    const bool by_k = repeat_word_ == RepeatWord::k_or_l && in.has(Address::K);
    const Address address = by_k ? Address::K : Address::L;
    if (!in.has(address)) return 1;
    const std::string_view letter = RootWords::letters.substr(address, 1);
    const ig_field field = words(now)[address];
    if (by_k && in.has(Address::L)) b.report(ig::diag("ISO-0315"), ig::Where::word(words(now)[Address::L]));
    const double k = in.get_or(address, 1);  // a count: RepeatCount keeps units and increments away from it
    if (!(k >= 0) || k != std::floor(k)) {
      b.report(ig::diag("ISO-0313"), ig::Where::word(field), letter, k);
      return 1;
    }
    const auto most = static_cast<double>(static_cast<std::int64_t>(max_repeats_));
    if (k > most) b.report(ig::diag("ISO-0314"), ig::Where::word(field), letter, k, most);
    return static_cast<int>(std::min(k, most));
  }

  /// CannedCycle is fresh where a hole is drilled, and corrected where data is kept only.
  void store(ig::Block& b, const Group09& now, const CycleWords& in, const PlaneAxes& plane, const ig::Vec3& hole,
             const CycleLevels& levels, double level, bool drills) const {
    const auto put = [&](const auto& field, auto value) { drills ? b.set(field, value) : b.amend(field, value); };
    put(term_, call_.name(*now.cycle));
    put(return_mode_, return_mode(b));
    if (level_rule_ == InitialLevel::cycle_entry && now.is_entry) put(initial_level_, level);
    if (levels.r) put(r_, *levels.r);
    for (std::size_t i = 0; i < stored_count_; ++i)
      if (const auto value = in[stored[i]]) put(kept_[i], *value);
    const auto keep = [&](std::size_t axis, double value) {
      const ig_value v{.number = value};
      const ig_field id = hole_.id(axis);
      drills ? b.set(id, v) : b.amend_many(&id, 1, &v);
    };
    if (levels.bottom) keep(plane.tool, *levels.bottom);
    if (!drills) return;
    keep(plane.first, hole[plane.first]);
    keep(plane.second, hole[plane.second]);
  }

  /// The resolved call, for the syntax of the cycle.
  void call(ig::Block& b, const Group09& now, const CycleWords& in, const PlaneAxes& plane, const ig::Vec3& hole,
            const CycleLevels& levels, const ig::Vec3& step, int count) const {
    const std::size_t row = *now.cycle;
    if (!now.is_called) {
      swallow(b, now);
      b.set_call(call_, row);
    }
    const auto put = [&](std::size_t address, double value) {
      const bool in_place = now.is_called && in.has(address);
      const ig_field field = call_.row(row)[address];
      in_place ? b.rewrite(field, value) : b.set(field, value);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) put(axis, axis == plane.tool ? *levels.bottom : hole[axis]);
    put(Address::R, *levels.r);
    for (std::size_t i = 0; i < stored_count_; ++i)
      if (const auto value = b.get(kept_[i]); value && !(now.is_called && in.has(stored[i]))) put(stored[i], *value);
    if (now.before && !in.has(Address::Q) && b.has(kept_[0]) && use_of_q(*now.before) != use_of_q(row))
      b.raise(q_of_another_use_);
    put_count(b, row, count, put);
    if (count == 1) return;
    if (step != ig::Vec3{}) b.set(increment_, step);
  }

  /// K is the number of holes; where it is a length of the cycle, L is.
  template <class Put>
  void put_count(ig::Block& b, std::size_t row, int count, const Put& put) const {
    ig_value unused;
    const bool k_is_length = repeat_word_ == RepeatWord::l && b.get(call_.row(row)[Address::K], unused);
    const Address counter = repeat_word_ == RepeatWord::l ? Address::L : Address::K;
    const Address other = counter == Address::L ? Address::K : Address::L;
    if (!k_is_length) take_word(b, call_.row(row)[other]);
    if (count == 1 && !k_is_length)
      take_word(b, call_.row(row)[counter]);
    else
      put(counter, count);
  }

  /// The words are used, but no hole comes of them here.
  void swallow(ig::Block& b, const Group09& now) const {
    std::array<ig_value, RootWords::letters.size()> values;
    b.take_many(words(now), RootWords::letters.size(), values.data());
    if (!now.is_called) return;
    erase_call(b);
    feed_.resolve(b, take_word(b, words(now)[Address::F]));
  }
};

const ig::Register<CannedCycleResolve> canned_cycle_resolve_syntax;

}  // namespace
}  // namespace iso
