// Cycles that act where they are defined: datum shift, mirror image, dwell, rotation, scaling, preset, patterns of
// holes. Each is executed here or passed to the syntax that executes it. TRANS DATUM, MIRROR, ROTATION and SCALE act
// like cycles 7, 8, 10 and 11.
#include <algorithm>

#include <isogloss/cnc/further_axes.hpp>

#include "cycles/cycle_text.hpp"
#include "cycles/pattern_cycle.hpp"
#include "frames/datum_selection.hpp"
#include "frames/mirror_and_rotation.hpp"
#include "frames/scaling.hpp"
#include "language/block_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

enum class ScaledAxes { all, plane };

struct KlartextFrameCycle {
  static constexpr auto spec = ig::syntax("KlartextFrameCycleSyntax", "Cycles that act where they are defined.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax", "KlartextCycleSyntax")
                                   .before("HeidenhainCoordinateOffsetSyntax", "KlartextDrillingCycleSyntax")
                                   .scans("CFPSTcfpst")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0180",
                     "cycle 220 with Q365=1 goes from hole to hole in straight lines, not along the pitch circle"),
      ig::diagnostic(IG_WARNING, "HEI-0192", "the scaling does not act on {0}: only X, Y and Z are scaled"),
  };

  CycleText text_{CycleText::Feeds::none};
  PatternCycle pattern_;
  ig::Field<double> preset_number_{"Parsing.DATUM_PRESET", ig::write, {ig::Life::word, "", ""}};
  ig::Call datum_{{"DATUM", "IDATUM"}, "X Y Z A B C", ig::write};
  ig::Out<double> dwell_{"Dwell.Time"};
  MirrorAndRotation frame_;
  Scaling scaling_;
  ig::Choice<ScaledAxes> scaled_axes_{"scaled-axes", "all|plane", "all",
                                      "What cycle 11 scales: X, Y and Z, or the axes of the plane (MP7410 = 1)."};
  PlaneInForce plane_;
  AxisNames axes_;
  DatumSelection tables_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    // C and CC begin many blocks of contours; CYCL DEF alone is meant.
    const bool is_circle = to_upper(text[position]) == 'C' && to_upper(at(text, position + 1)) != 'Y';
    if (is_circle || !stands_first(text, position) || !b.is_in_turn()) return position;
    if (const std::size_t end = trans(b, text, position); end != position) return end;
    if (const std::size_t end = tables_.select_table(b, text_.values(), text, position); end != position) return end;
    if (const std::size_t end = select_preset(b, text, position); end != position) return end;
    const std::size_t definition = keyword(text, position, "CYCL DEF"), datum = keyword(text, position, "TRANS DATUM");
    const std::size_t pause = keyword(text, position, "FUNCTION DWELL TIME");
    if (definition == position && datum == position && pause == position) return position;
    const std::size_t end = statement_end(text, position);
    text = text.substr(0, end);
    if (pause != position) {
      if (text_.values().is_indexing()) return end;
      const Value seconds = text_.values().read(b, text, skip(text, pause));
      dwell(b, seconds, position, end, "FUNCTION DWELL");
      const std::size_t rest = seconds.ok ? skip(text, seconds.end) : end;
      if (rest < end)
        b.report(ig::diag("HEI-0105"), ig::Where::columns(rest, end), trim(text.substr(rest)),
                 std::string_view("FUNCTION DWELL TIME"));
      return end;
    }
    if (datum != position) {
      if (!text_.values().is_indexing()) trans_datum(b, text, position, datum);
      return end;
    }
    const auto number = CycleNumber::at(text, skip(text, definition));
    if (!number || !acts_where_defined(number->cycle)) return position;
    if (text_.values().is_indexing()) return end;
    act(b, text, *number, where_of_line(text, position));
    return end;
  }

 private:
  // ---- definitions with parameters

  void preset(ig::Block& b, std::string_view text, const CycleNumber& number, ig::Where where) const {
    std::optional<double> preset;
    text_.parameters(b, text, number.end, 247, [&](std::uint32_t q, double value) {
      if (q == 339) preset = value;
    });
    if (!preset) {
      b.report(ig::diag("HEI-0163"), where, 247.0, std::string_view("Q339"));
      return;
    }
    put_word(b, preset_number_.id(), where.begin, where.end, *preset);
    reset(b, where);
  }

  /// The manual: a preset resets shift, mirror image, rotation and scaling; a tilted plane stays in force.
  void reset(ig::Block& b, ig::Where where) const {
    frame_.end(b, where);
    scaling_.end(b);
  }

  /// PRESET SELECT #3 is cycle 247; further words and presets by name are not executed.
  std::size_t select_preset(ig::Block& b, std::string_view text, std::size_t begin) const {
    const std::size_t number = skip(text, keyword(text, begin, "PRESET SELECT")), end = statement_end(text, begin);
    if (number <= begin || at(text, number) != '#') return begin;
    if (text_.values().is_indexing()) return end;
    const Value preset = text_.values().read(b, text, number + 1);
    if (!preset.ok || skip(text, preset.end) < end) return begin;
    put_word(b, preset_number_.id(), begin, preset.end, preset.number);
    reset(b, where_of_line(text, begin));
    return end;
  }

  // ---- which one

  void act(ig::Block& b, std::string_view text, const CycleNumber& number, ig::Where where) const {
    const auto part = number.part.value_or(1);
    const auto report = [&](const char* effect) {
      b.report(ig::diag("HEI-0161"), where, static_cast<double>(number.cycle), std::string_view(effect));
    };
    const auto machine = [&](const char* effect) {
      b.report(ig::diag("HEI-0374"), where, piece(text, where.begin, where.end), std::string_view(effect));
    };
    switch (number.cycle) {
      case 7:
        if (part > 0) datum(b, text, number.end);
        return;
      case 8:
        if (part > 0) frame_.mirror(b, text, number.end, where, part == 1 ? Mirroring::anew : Mirroring::further);
        return;
      case 9:
        if (part > 0) dwell_cycle(b, text, number.end);
        return;
      case 10:
        if (part > 0) rotate(b, text, number.end, where, "CYCL DEF 10");
        return;
      case 11:
        if (part > 0 && !scale(b, text, number.end, "CYCL DEF 11")) report(no_scale);
        return;
      case 26:
        if (part > 0 && scales_axes(b, text, number.end)) report("positions are not scaled");
        return;
      case 13:
        if (part > 0) machine("the spindle is not oriented");
        return;
      case 30:
        if (part > 0) report("the points of the file are not run");
        return;
      case 220:
      case 221: return pattern_.define(b, text_, text, number, where);
      case 224: return report("the pattern of holes is missing");
      case 238: return machine("the state of the machine is not measured");
      case 239: return machine("the load is not learned");
      case 291: return report("the spindle does not follow the axes");
      case 800: return report("coordinates are not those of turning");
      case 892: return machine("the unbalance is not measured");
      case 247: return preset(b, text, number, where);
      // 14, 20, 270, 271, 285: contours and gears, which are reported where they are machined; 32, 332, 392: accuracy
      // and speed of the path; 801: the end of 800. Their parameters are assigned, as those of all cycles.
      default: text_.parameters(b, text, number.end, number.cycle, [](std::uint32_t, double) {}); return;
    }
  }

  /// CYCL DEF 7.1 X+60, IX+5, #5
  void datum(ig::Block& b, std::string_view text, std::size_t i) const {
    unsigned named = 0;
    while ((i = skip(text, i)) < text.size()) {
      const bool is_step = to_upper(text[i]) == 'I';
      const std::size_t letter = is_step ? i + 1 : i;
      const std::size_t axis = std::string_view("XYZABC").find(to_upper(at(text, letter)));
      if (text[i] == '#') {
        i = tables_.put_row(b, text_.values(), text, i, i + 1, {}, datum_);
        continue;
      }
      const Value v = axis < 6 ? text_.values().read(b, text, letter + 1) : Value{};
      if (!v.ok) {
        report_not_a_word(b, text, i, "CYCL DEF 7");
        return;
      }
      const std::size_t row = is_step ? 1 : 0;
      if ((named >> axis & 1u) != 0) {
        report_repeated(b, text, i, v.end);
        b.erase(datum_.row(1 - row)[axis]);
      }
      named |= 1u << axis;
      put_code(b, datum_.code(row), i, v.end);
      put_word(b, datum_.row(row)[axis], i, v.end, v.number);
      i = v.end;
    }
  }

  void dwell(ig::Block& b, const Value& seconds, std::size_t begin, std::size_t end, std::string_view of) const {
    if (!seconds.ok || seconds.number < 0)
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, std::max(begin + 1, end)), of,
               std::string_view("the time"));
    else
      b.set(dwell_, seconds.number);
  }

  /// CYCL DEF 10.1 ROT+35, IROT+10
  void rotate(ig::Block& b, std::string_view text, std::size_t i, ig::Where where, std::string_view of) const {
    const std::size_t first = skip(text, i);
    const Value v = text_.number_behind(b, text, first);
    if (!v.ok)
      b.report(ig::diag("HEI-0104"), where, of, std::string_view("ROT"));
    else if (to_upper(at(text, first)) == 'I')
      frame_.turn_further(b, where, v.number);
    else
      frame_.turn(b, where, v.number + 0.0);
    if (v.ok) report_rest(b, text, v.end, of);
  }

  void dwell_cycle(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value seconds = text_.number_behind(b, text, i);
    dwell(b, seconds, i, text.size(), "CYCL DEF 9");
    if (seconds.ok) report_rest(b, text, seconds.end, "CYCL DEF 9");
  }

  static constexpr const char* no_scale =
      "it needs a factor from 0.000001 to 99.999999, and the scaling stays as it is";

  /// CYCL DEF 11.1 SCL 0.99; false where there is no factor.
  bool scale(ig::Block& b, std::string_view text, std::size_t i, std::string_view of) const {
    const Value factor = text_.number_behind(b, text, i);
    if (!factor.ok || !(factor.number >= Scaling::least && factor.number <= Scaling::most)) return false;
    const bool is_in_plane = scaled_axes_ == ScaledAxes::plane;
    scaling_.set(b, factor.number, is_in_plane ? std::optional(plane_(b).tool) : std::nullopt);
    if (factor.number != 1) report_further_axes(b, ig::Where::columns(skip(text, i), factor.end));
    report_rest(b, text, factor.end, of);
    return true;
  }
  /// The control scales U, V and W as well.
  void report_further_axes(ig::Block& b, ig::Where where) const {
    for (std::uint32_t axis = first_further_axis; is_further_axis(axis); ++axis)
      if (!axes_.name(axis).empty() && !axes_.is_rotary(axis)) b.report(ig::diag("HEI-0192"), where, axes_.name(axis));
  }

  /// CYCL DEF 26.1 X1 YQ2 CCX+15 CCY+20: a factor for each axis, and the centre.
  bool scales_axes(ig::Block& b, std::string_view text, std::size_t i) const {
    bool any = false;
    while ((i = skip(text, i)) < text.size()) {
      const bool is_centre = equals_ignoring_case(piece(text, i, std::min(i + 2, text.size())), "CC");
      const std::size_t axis = is_centre ? i + 2 : i;
      const bool is_axis = std::string_view("XYZABCUVW").find(to_upper(at(text, axis))) != std::string_view::npos;
      const Value v = is_axis ? text_.values().read(b, text, axis + 1) : Value{};
      if (!v.ok) {
        report_not_a_word(b, text, i, "CYCL DEF 26");
        return true;
      }
      any = any || (!is_centre && v.number != 1);
      i = v.end;
    }
    return any;
  }

  /// TRANS MIRROR AXIS X, TRANS ROTATION ROT+90, TRANS SCALE SCL1 and their RESET: like cycles 8, 10 and 11.
  std::size_t trans(ig::Block& b, std::string_view text, std::size_t begin) const {
    const std::size_t mirrored = keyword(text, begin, "TRANS MIRROR"), turned = keyword(text, begin, "TRANS ROTATION");
    const std::size_t scaled = keyword(text, begin, "TRANS SCALE");
    if (mirrored == begin && turned == begin && scaled == begin) return begin;
    const std::size_t end = statement_end(text, begin);
    if (text_.values().is_indexing()) return end;
    text = text.substr(0, end);
    const auto where = where_of_line(text, begin);
    const std::size_t first = skip(text, std::max({mirrored, turned, scaled}));
    const std::size_t reset = keyword(text, first, "RESET"), axis = keyword(text, first, "AXIS");
    if (scaled != begin) {
      if (reset != first) {
        scaling_.end(b);
        report_rest(b, text, reset, "TRANS SCALE RESET");
      } else if (!scale(b, text, first, "TRANS SCALE")) {
        report_not_executed(b, text, begin, no_scale);
      }
    } else if (mirrored != begin) {
      frame_.mirror(b, text, reset != first ? end : axis, where, Mirroring::anew);
      if (reset != first) report_rest(b, text, reset, "TRANS MIRROR RESET");
    } else if (reset != first) {
      frame_.turn(b, where, 0);
      report_rest(b, text, reset, "TRANS ROTATION RESET");
    } else {
      rotate(b, text, first, where, "TRANS ROTATION");
    }
    return end;
  }

  /// TRANS DATUM AXIS X+10, TABLE TABLINE 5, TABLE "ZERO.D" TABLINE 5, RESET: like cycle 7.
  void trans_datum(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const std::size_t axis = keyword(text, i, "AXIS"), reset = keyword(text, i, "RESET");
    const std::size_t table = keyword(text, i, "TABLE");
    if (axis != i) {
      datum(b, text, axis);
    } else if (table != i) {
      tables_.put_named_row(b, text_.values(), text, begin, skip(text, table), datum_);
    } else if (reset != i) {
      put_code(b, datum_.code(0), begin, reset);
      for (std::size_t k = 0; k < 6; ++k) put_word(b, datum_.row(0)[k], begin, reset, 0);
      report_rest(b, text, reset, "TRANS DATUM RESET");
    } else {
      report_not_executed(b, text, begin, "AXIS, TABLE or RESET is missing, the shift stays");
    }
  }
};

const ig::Register<KlartextFrameCycle> klartext_frame_cycle_syntax;

}  // namespace
}  // namespace heidenhain
