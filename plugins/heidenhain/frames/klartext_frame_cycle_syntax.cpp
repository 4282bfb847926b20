// Cycles that act where they are defined: datum shift, mirror image, dwell, rotation, preset, patterns of holes. Each
// is executed here or passed to the syntax that executes it; TRANS DATUM, MIRROR and ROTATION act like cycles 7, 8 and
// 10.
#include <algorithm>

#include "cycles/cycle_text.hpp"
#include "cycles/hole_pattern.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextFrameCycle {
  static constexpr auto spec = ig::syntax("KlartextFrameCycleSyntax", "Cycles that act where they are defined.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax", "KlartextCycleSyntax")
                                   .before("HeidenhainCoordinateOffsetSyntax", "KlartextDrillingCycleSyntax")
                                   .scans("CFTcft");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0173",
                     "datum {0} is not set, because the datum table is not known: the previous shift stays in force"),
      ig::diagnostic(IG_WARNING, "HEI-0180",
                     "cycle 220 with Q365=1 goes from hole to hole in straight lines, not along the pitch circle"),
  };

  CycleText text_{CycleText::Feeds::none};
  HolePattern pattern_{ig::write};
  CycleDefinition definition_{ig::write};
  ig::Field<std::int64_t> in_force_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::Field<double> preset_number_{"Parsing.DATUM_PRESET", ig::write, {ig::Life::word, "", ""}};
  ig::Call datum_{{"DATUM", "IDATUM"}, "X Y Z A B C", ig::write};
  ig::Call rotation_{{"G68"}, "X Y Z R[deg]", ig::write};
  ig::Codes rotation_end_{{"G69"}, ig::write};
  ig::Field<bool> mirrored_rotation_{"KlartextRotation.IsMirrored",
                                     ig::read | ig::write,
                                     {ig::Life::modal, "", "The rotation was defined in a mirror image."}};
  ig::Call mirror_{{"G50.1", "G51.1"}, "X Y Z", ig::write};
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  ig::Xyz mirror_image_{"MirrorImage", ig::read};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::In<double> turned_{"TiltTransform.R"};
  ig::Field<double> turned_in_plane_{"PlaneFrame.R", ig::previous, {ig::Life::modal, "deg", ""}};
  ig::Field<double> plane_rotation_{"Parsing.PLANE_ROTATION", ig::write, {ig::Life::word, "deg", ""}};
  ig::In<ig::Symbol> plane_{"PlaneSelect.Term"};
  ig::Out<double> dwell_{"Dwell.Time"};
  ig::Name g68_{"G68"}, g68_2_{"G68.2"}, g18_{"G18"}, g19_{"G19"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    if (const std::size_t end = trans(b, text, position); end != position) return end;
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
    const std::string_view whole = rest_of_line(text, position);
    act(b, text, *number, ig::Where::columns(position, position + whole.size()));
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
    // The manual: a preset resets shift, mirror image and rotation; a tilted plane stays in force.
    if (b.is(tilt_, g68_)) put_code(b, rotation_end_.id(0), where.begin, where.end);
    if (b.has(mirror_term_)) put_code(b, mirror_.code(0), where.begin, where.end);
  }

  /// The last defined cycle runs at the points of the pattern at once.
  void pattern(ig::Block& b, std::string_view text, const CycleNumber& number, ig::Where where) const {
    const std::int64_t cycle = number.cycle;
    text_.parameters(b, text, number.end, cycle, [&](std::uint32_t q, double value) {
      const std::size_t i = HolePattern::index_of(q);
      if (i >= pattern_parameters.size()) return;
      const double metric = text_.metric(b, pattern_parameters[i].unit, value);
      if (!std::isfinite(metric)) return;
      pattern_.set(b, q, metric);
      // Clearances and surface are parameters of the cycle as well: they stay for the calls after the pattern.
      if (index_of_parameter(q) < cycle_parameters.size() && b.get_or(in_force_, std::int64_t{0}) >= 200)
        definition_.set(b, q, metric);
    });
    static constexpr std::array<std::uint32_t, 4> of_circle{216, 217, 244, 241};
    static constexpr std::array<std::uint32_t, 6> of_rows{225, 226, 237, 238, 242, 243};
    const std::span<const std::uint32_t> needed =
        cycle == 220 ? std::span<const std::uint32_t>(of_circle) : std::span<const std::uint32_t>(of_rows);
    for (const std::uint32_t q : needed)
      if (!pattern_.get(b, q)) {
        b.report(ig::diag("HEI-0163"), where, static_cast<double>(cycle),
                 std::string_view(pattern_parameters[HolePattern::index_of(q)].name));
        return;
      }
    if (pattern_.get(b, 365).value_or(0) != 0) b.report(ig::diag("HEI-0180"), where);
    pattern_.set_number(b, cycle);
    b.set(call_, true);
  }

  // ---- which one

  void act(ig::Block& b, std::string_view text, const CycleNumber& number, ig::Where where) const {
    const auto part = number.part.value_or(1);
    const auto say = [&](const char* effect) {
      b.report(ig::diag("HEI-0161"), where, static_cast<double>(number.cycle), std::string_view(effect));
    };
    switch (number.cycle) {
      case 7:
        if (part > 0) datum(b, text, number.end);
        return;
      case 8:
        if (part > 0) mirror(b, text, number.end, where, part == 1);
        return;
      case 9:
        if (part > 0) dwell(b, text_.number_behind(b, text, number.end), number.end, text.size(), "CYCL DEF 9");
        return;
      case 10:
        if (part > 0) rotate(b, text, number.end, where, "CYCL DEF 10");
        return;
      case 11:
      case 26:
        if (part > 0 && scales(b, text, number.end)) say("positions are not scaled");
        return;
      case 13:
        if (part > 0) say("the spindle is not oriented");
        return;
      case 30:
        if (part > 0) say("the points of the file are not run");
        return;
      case 220:
      case 221: return pattern(b, text, number, where);
      case 224: return say("the pattern of holes is missing");
      case 238: return say("the state of the machine is not measured");
      case 239: return say("the load is not learned");
      case 291: return say("the spindle does not follow the axes");
      case 800: return say("coordinates are not those of turning");
      case 892: return say("the unbalance is not measured");
      case 247: return preset(b, text, number, where);
      // 14, 20, 270, 271, 285: contours and gears, which are reported where they are machined; 32, 332, 392: accuracy
      // and speed of the path; 801: the end of 800
      default: return;
    }
  }

  /// CYCL DEF 7.1 X+60, IX+5, #5
  void datum(ig::Block& b, std::string_view text, std::size_t i) const {
    while ((i = skip(text, i)) < text.size()) {
      const bool is_step = to_upper(text[i]) == 'I';
      const std::size_t letter = is_step ? i + 1 : i;
      const std::size_t axis = std::string_view("XYZABC").find(to_upper(at(text, letter)));
      if (text[i] == '#') {
        const Value n = text_.values().read(b, text, i + 1);
        b.report(ig::diag("HEI-0173"), ig::Where::columns(i, std::max(n.end, i + 1)), n.number);
        return;
      }
      const Value v = axis < 6 ? text_.values().read(b, text, letter + 1) : Value{};
      if (!v.ok) {
        report_not_a_word(b, text, i, "CYCL DEF 7");
        return;
      }
      const std::size_t row = is_step ? 1 : 0;
      put_code(b, datum_.code(row), i, v.end);
      put_word(b, datum_.row(row)[axis], i, v.end, v.number);
      i = v.end;
    }
  }

  /// CYCL DEF 8.1 X Y: the axes that are mirrored about the datum; without axes the mirror image ends.
  void mirror(ig::Block& b, std::string_view text, std::size_t i, ig::Where where, bool is_anew) const {
    if (is_anew && b.has(mirror_term_)) put_code(b, mirror_.code(0), where.begin, where.end);
    // A rotation that was defined in a mirror image has been turned in the opposite sense.
    if (b.is(tilt_, g68_) && b.has(mirrored_rotation_))
      b.report(ig::diag("HEI-0161"), where, 8.0, std::string_view("the rotation in force keeps its sense"));
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t axis = std::string_view("XYZ").find(to_upper(text[i]));
      const std::size_t tool = b.is(plane_, g18_) ? 1 : b.is(plane_, g19_) ? 0 : 2;
      if (axis > 2 || axis == tool) {
        b.report(ig::diag("HEI-0161"), ig::Where::columns(i, i + 1), 8.0,
                 std::string_view(axis > 2 ? "only X, Y and Z can be mirrored here" : "the tool axis is not mirrored"));
      } else {
        put_code(b, mirror_.code(1), i, i + 1);
        put_word(b, mirror_.row(1)[axis], i, i + 1, 0);
      }
      ++i;
    }
  }

  void dwell(ig::Block& b, const Value& seconds, std::size_t begin, std::size_t end, std::string_view of) const {
    if (!seconds.ok || seconds.number < 0)
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, std::max(begin + 1, end)), of,
               std::string_view("the time"));
    else
      b.set(dwell_, seconds.number);
  }

  int mirrored_axes_in_plane(const ig::Block& b) const {
    const std::size_t tool = b.is(plane_, g18_) ? 1 : b.is(plane_, g19_) ? 0 : 2;
    const ig::PartialVec3 mirror = b.get(mirror_image_);
    int count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) count += axis != tool && mirror.has(axis) ? 1 : 0;
    return count;
  }

  bool is_mirrored_in_plane(const ig::Block& b) const { return b.has(mirror_term_) && mirrored_axes_in_plane(b) == 1; }

  bool scales(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value v = text_.number_behind(b, text, i);
    return !v.ok || v.number != 1;
  }

  /// CYCL DEF 10.1 ROT+35, IROT+10: a rotation about the datum, in the plane.
  void rotate(ig::Block& b, std::string_view text, std::size_t i, ig::Where where, std::string_view of) const {
    const std::size_t first = skip(text, i);
    const bool is_step = to_upper(at(text, first)) == 'I';
    const Value v = text_.number_behind(b, text, first);
    if (!v.ok) {
      b.report(ig::diag("HEI-0104"), where, of, std::string_view("ROT"));
      return;
    }
    const bool is_rotated = b.is(tilt_, g68_);
    // IsoG68RotationSyntax turns in the opposite sense in a mirrored system, and keeps the angle that it turns.
    const bool is_mirrored = is_mirrored_in_plane(b);
    const double in_force = b.is(tilt_, g68_2_) ? b.get_or(turned_in_plane_, 0.0)
                            : is_rotated        ? b.get_or(turned_, 0.0)
                                                : 0;
    turn(b, where, v.number + (is_step ? (is_mirrored ? -in_force : in_force) : 0));
  }

  void turn(ig::Block& b, ig::Where where, double angle) const {
    if (b.is(tilt_, g68_2_)) {
      put_word(b, plane_rotation_.id(), where.begin, where.end, is_mirrored_in_plane(b) ? -angle : angle);
      return;
    }
    if (b.has(turned_in_plane_))
      put_word(b, plane_rotation_.id(), where.begin, where.end, 0);  // of a plane that has ended
    if (angle == 0) {
      if (b.is(tilt_, g68_)) put_code(b, rotation_end_.id(0), where.begin, where.end);
      return;
    }
    if (is_mirrored_in_plane(b))
      b.set(mirrored_rotation_, true);
    else if (b.has(mirrored_rotation_))
      b.erase(mirrored_rotation_);
    put_code(b, rotation_.code(0), where.begin, where.end);
    const bool is_zx = b.is(plane_, g18_), is_yz = b.is(plane_, g19_);
    put_word(b, rotation_.word(0, is_zx ? 'Z' : is_yz ? 'Y' : 'X'), where.begin, where.end, 0);
    put_word(b, rotation_.word(0, is_zx ? 'X' : is_yz ? 'Z' : 'Y'), where.begin, where.end, 0);
    put_word(b, rotation_.word(0, 'R'), where.begin, where.end, angle);
  }

  /// TRANS MIRROR AXIS X, TRANS ROTATION ROT+90, TRANS SCALE SCL1 and their RESET: like cycles 8, 10 and 11.
  std::size_t trans(ig::Block& b, std::string_view text, std::size_t begin) const {
    const std::size_t mirrored = keyword(text, begin, "TRANS MIRROR"), turned = keyword(text, begin, "TRANS ROTATION");
    const std::size_t scaled = keyword(text, begin, "TRANS SCALE");
    if (mirrored == begin && turned == begin && scaled == begin) return begin;
    const std::size_t end = statement_end(text, begin);
    if (text_.values().is_indexing()) return end;
    text = text.substr(0, end);
    const std::string_view whole = rest_of_line(text, begin);
    const auto where = ig::Where::columns(begin, begin + whole.size());
    const std::size_t first = skip(text, std::max({mirrored, turned, scaled}));
    const std::size_t reset = keyword(text, first, "RESET"), axis = keyword(text, first, "AXIS");
    if (scaled != begin) {
      if (reset == first && scales(b, text, first))
        b.report(ig::diag("HEI-0122"), where, whole, std::string_view("positions are not scaled"));
    } else if (mirrored != begin) {
      mirror(b, text, reset != first ? end : axis, where, true);
    } else if (reset != first) {
      turn(b, where, 0);
    } else {
      rotate(b, text, first, where, "TRANS ROTATION");
    }
    return end;
  }

  /// TRANS DATUM AXIS X+10, TABLE TABLINE 5, RESET: like cycle 7.
  void trans_datum(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const std::size_t axis = keyword(text, i, "AXIS"), reset = keyword(text, i, "RESET");
    if (axis != i) {
      datum(b, text, axis);
    } else if (reset != i) {
      put_code(b, datum_.code(0), begin, reset);
      for (std::size_t k = 0; k < 3; ++k) put_word(b, datum_.row(0)[k], begin, reset, 0);
    } else {
      report_not_executed(b, text, begin, "the datum table is not known, the shift stays");
    }
  }
};

const ig::Register<KlartextFrameCycle> klartext_frame_cycle_syntax;

}  // namespace
}  // namespace heidenhain
