// PLANE SPATIAL, EULER, VECTOR, POINTS, AXIAL, RELATIV and RESET: the tilted working plane. The plane becomes a G68.2
// with three spatial angles, its positioning a G53.1 (TURN) or a G53.6 (MOVE) with the angles that are found here.
// These angles also go to Q120 to Q122, for the block that positions the axes after STAY.
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_offset.hpp>

#include "five_axis/plane_definition.hpp"
#include "five_axis/plane_positioning.hpp"
#include "motion/feed_words.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPlane {
  static constexpr auto spec = ig::syntax("KlartextPlaneSyntax", "PLANE and CYCL DEF 19: tilted planes.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("KlartextCycleSyntax", "IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax",
                                           "ToolCenterPointSyntax", "KlartextMotionSyntax", "McAbcSyntax")
                                   .scans("CPcp");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0170",
                     "{0}: {1} is missing or is not a number, so the previous plane stays in force"),
      ig::diagnostic(IG_ERROR, "HEI-0172", "{0}: the machine's rotary axes are not known, so that {1}"),
      ig::diagnostic(IG_ERROR, "HEI-0176",
                     "no position of the rotary axes within their travel gives this plane{0}: the axes do not move"),
  };

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  ig::Signal statement_{"Parsing.~KlartextPlane", ig::read | ig::write | ig::wake};
  ig::Call plane_{{"G68.2"}, "X Y Z I[deg] J[deg] K[deg] P[] Q[]", ig::write};
  ig::Codes end_{{"G69"}, ig::write};
  ig::Call turn_{{"G53.1", "G53.6"}, "P[] H[] R", ig::write};
  ig::Codes motions_{{"G00", "G01"}, ig::write};
  ig::Call length_{{"G43"}, "", ig::write};
  std::array<ig_field, 3> rotary_{rotary("Parsing.A"), rotary("Parsing.B"), rotary("Parsing.C")};
  ig::Out<ig::Symbol> term_{"TiltTransform.Term"};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"TiltTransform.I"}, ig::In<double>{"TiltTransform.J"},
                                        ig::In<double>{"TiltTransform.K"}};
  ig::Out<bool> stay_{"KlartextPlane.IsStaying",
                      {ig::Life::block, "", "PLANE ... STAY: the program positions the axes itself."}};
  ig::Out<ig::Symbol> length_term_{"ToolHeightCompensation.Term"};
  ig::Name g69_{"G69"}, g68_2_{"G68.2"}, g43_4_{"G43.4"}, g43_{"G43"};
  ig::Out<double> retract_{"KlartextPlane.Retract_mm",
                           {ig::Life::block, "mm", "MB: how far the tool goes out before the axes turn."}};
  ig::Out<bool> to_limit_{"KlartextPlane.RetractsToLimit",
                          {ig::Life::block, "", "MB MAX: the tool goes out to the end of the travel."}};
  RotaryOffsetSection rotary_offset_{"CoordinateOffset", ig::read};
  PlanePositioning axes_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    const std::size_t i = keyword(text, position, "PLANE"), cycle = behind_cycle_19(text, position);
    if (i == position && cycle == position) return position;
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    command_ = {};
    command_.begin = position;
    const std::string_view whole = trim(piece(text, position, end));
    command_.end = position + whole.size();
    if (i != position ? read(b, text.substr(0, end), i) : read_cycle(b, text.substr(0, end), cycle))
      b.raise(statement_);
    return end;
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(statement_)) return ig::Status::unchanged;
    if (command_.plane.kind == PlaneDefinition::reset)
      end_plane(b);
    else
      tilt(b);
    return ig::Status::changed;
  }

 private:
  enum class Move { none, stay, turn, move };
  struct Retract {
    std::optional<double> distance;  ///< nothing: MB MAX
    std::size_t begin, end;
  };
  struct Command {
    PlaneDefinition plane{};
    std::size_t begin = 0, end = 0;
    Move move = Move::none;
    int sequence = 0;
    double distance = 0;
    std::optional<Retract> retract{};
    bool is_rapid = false;
    bool turns_table = false;  ///< TABLE ROT; else COORD ROT
  };
  ig::Where where() const { return ig::Where::columns(command_.begin, command_.end); }

  static ig_field rotary(const char* path) {
    return ig::Field<double>(path, ig::read | ig::write, {ig::Life::standard, "deg", ""}).id();
  }

  std::string_view shown() const { return command_.plane.shown(); }

  // ---- text

  /// The position where the words of CYCL DEF 19.1 begin; 19.0 only names the cycle and is left to KlartextCycleSyntax.
  static std::size_t behind_cycle_19(std::string_view text, std::size_t position) {
    const std::size_t definition = keyword(text, position, "CYCL DEF");
    if (definition == position) return position;
    std::size_t i = skip(text, definition);
    if (text.substr(std::min(i, text.size())).substr(0, 2) != "19") return position;
    i = skip_blanks(text, i + 2);
    if (at(text, i) != '.') return position;
    i = skip_blanks(text, i + 1);
    return at(text, i) == '1' && !is_digit(at(text, i + 1)) ? i + 1 : position;
  }

  /// Reads spatial angles; those that are not named keep their values. If all are 0, or none is given, there is no
  /// plane.
  bool read_cycle(ig::Block& b, std::string_view text, std::size_t i) {
    bool any = false, is_tilted = false;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t axis = std::string_view("ABC").find(to_upper(text[i]));
      const Value v = axis < 3 ? values_.read(b, text, i + 1) : Value{};
      if (axis < 3 && v.ok) {
        command_.plane.words[axis] = v.number;
        any = true;
        i = v.end;
      } else if (to_upper(text[i]) == 'F') {
        i = feed_.scan(b, values_, text, i, command_.is_rapid);
      } else {
        report_not_a_word(b, text, i, "CYCL DEF 19");
        break;
      }
    }
    for (std::size_t axis = 0; axis < 3 && any; ++axis) {
      if (!command_.plane.words[axis])
        command_.plane.words[axis] = b.is(term_, g68_2_) ? b.get_or(angles_[axis], 0.0) : 0;
      is_tilted = is_tilted || *command_.plane.words[axis] != 0;
    }
    command_.plane.kind = is_tilted ? PlaneDefinition::spatial : PlaneDefinition::reset;
    command_.move = Move::stay;
    return true;
  }

  bool read(ig::Block& b, std::string_view text, std::size_t i) {
    i = skip(text, i);
    const std::size_t letters = letters_end(text, i);
    command_.plane.kind = PlaneDefinition::kind_of(piece(text, i, letters));
    if (command_.plane.kind == PlaneDefinition::kind_count) {
      const std::string_view whole = rest_of_line(text, command_.begin);
      b.report(ig::diag("HEI-0171"), where(), whole.substr(0, line_end(whole, 0)),
               std::string_view("the plane does not change"));
      return false;
    }
    i = letters;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t next = word_at(b, text, i);
      if (next == i) {
        report_not_a_word(b, text, i, "PLANE");
        break;
      }
      i = next;
    }
    return is_complete(b);
  }

  /// A digit belongs to the keyword in P1X, but a Q after the letters begins the value: SPAQ1.
  static std::size_t keyword_prefix(std::string_view text, std::size_t i, std::string_view upper) {
    const std::size_t end = i + upper.size();
    const bool is_word = equals_ignoring_case(text.substr(i).substr(0, upper.size()), upper);
    return is_word && (!is_letter(at(text, end)) || to_upper(at(text, end)) == 'Q') ? end : i;
  }

  std::size_t word_at(ig::Block& b, std::string_view text, std::size_t i) {
    const std::size_t letters = letters_end(text, i);
    const std::string_view word = piece(text, i, letters);
    const auto is = [&](std::string_view name) { return equals_ignoring_case(word, name); };
    const auto names = command_.plane.names();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::size_t value = keyword_prefix(text, i, names[k]);
      const Value v = value != i ? values_.read(b, text, value) : Value{};
      if (!v.ok) continue;
      command_.plane.words[k] = v.number;
      return v.end;
    }
    // The manuals of the iTNC write the angle of nutation in this way.
    if (command_.plane.kind == PlaneDefinition::euler)
      if (const std::size_t value = keyword_prefix(text, i, "EULNU"); value != i)
        if (const Value v = values_.read(b, text, value); v.ok) {
          command_.plane.words[1] = v.number;
          return v.end;
        }
    if (is("STAY")) return set(Move::stay, letters);
    if (is("TURN")) return set(Move::turn, letters);
    if (is("MOVE")) return set(Move::move, letters);
    if (is("SEQ") || is("SYM")) {
      const std::size_t sign = skip_blanks(text, letters);
      if (at(text, sign) != '+' && at(text, sign) != '-') return i;
      command_.sequence = at(text, sign) == '+' ? 1 : -1;
      return sign + 1;
    }
    if (is("TABLE") || is("COORD")) {
      const std::size_t rot = keyword(text, skip(text, letters), "ROT");
      if (rot == skip(text, letters)) return i;
      command_.turns_table = is("TABLE");
      return rot;
    }
    if (is("DIST") || is("ABST") || is("MB")) {
      const Value v = values_.read(b, text, letters);
      const std::size_t behind = skip(text, letters), limit = is("MB") ? keyword(text, behind, "MAX") : behind;
      if (!v.ok && limit == behind) return i;
      const std::size_t end = v.ok ? v.end : limit;
      if (!is("MB"))
        command_.distance = v.number;
      else if (!v.ok || v.number != 0)
        command_.retract = Retract{v.ok ? std::optional(v.number) : std::nullopt, i, end};
      return end;
    }
    if (to_upper(text[i]) == 'F') return feed_.scan(b, values_, text, i, command_.is_rapid);
    if (to_upper(text[i]) == 'M') return m_.scan(b, values_, text, i);
    return i;
  }
  std::size_t set(Move move, std::size_t next) {
    command_.move = move;
    return next;
  }

  bool is_complete(ig::Block& b) const {
    const PlaneDefinition& plane = command_.plane;
    if (plane.kind == PlaneDefinition::reset) return true;
    bool any = false;
    for (std::size_t k = 0; k < plane.names().size(); ++k) {
      any = any || plane.words[k];
      if (plane.words[k] || plane.takes_some()) continue;
      b.report(ig::diag("HEI-0170"), where(), shown(), plane.names()[k]);
      return false;
    }
    if (!any)
      b.report(ig::diag("HEI-0170"), where(), shown(),
               std::string_view(plane.kind == PlaneDefinition::axial ? "A, B or C" : "SPA, SPB or SPC"));
    return any;
  }

  // ---- the plane

  Mat4 present_plane(const ig::Block& b) const {
    if (!b.is(term_, g68_2_)) return identity_frame;
    return PlaneDefinition::spatial_plane(
        {b.get_or(angles_[0], 0.0), b.get_or(angles_[1], 0.0), b.get_or(angles_[2], 0.0)});
  }

  void tilt(ig::Block& b) {
    const Angles now = axes_.present(b);
    Angles axial = now;
    for (std::size_t axis = 0; axis < 3 && command_.plane.kind == PlaneDefinition::axial; ++axis)
      if (const auto word = command_.plane.words[axis]) axial[axis] = *word + rotary_offset_.get(b).value[axis];
    if (command_.plane.kind == PlaneDefinition::axial && !axes_) {
      b.report(ig::diag("HEI-0172"), where(), shown(), std::string_view("the plane stays"));
      return;
    }
    for (std::size_t axis = 0; axis < 3 && command_.plane.kind == PlaneDefinition::axial; ++axis)
      if (command_.plane.words[axis] && !axes_.machine().has(axis))
        b.report(ig::diag("HEI-0171"), where(), std::string_view("ABC").substr(axis, 1),
                 std::string_view("the machine has no such axis"));
    const auto m = command_.plane.frame(present_plane(b), axial, axes_.machine());
    if (!m && command_.plane.kind == PlaneDefinition::axial) {
      b.report(
          ig::diag("HEI-0171"), where(), shown(),
          std::string_view("the head has two axes, one of them inclined, turned round or shifted: the plane stays"));
      return;
    }
    if (!m || !is_finite(*m)) {
      b.report(ig::diag("HEI-0170"), where(), shown(), std::string_view("a direction"));
      return;
    }
    const ig::Vec3 angles = command_.plane.kind == PlaneDefinition::spatial ? command_.plane.words_from(0)
                                                                            : PlaneDefinition::spatial_angles(*m);
    // PLANE ends tool centre point control.
    if (b.is(length_term_, g43_4_)) {
      b.set(length_term_, g43_);
      b.set_call(length_, 0);
    }
    // One plane may follow another: each is defined in the workpiece.
    if (b.is(term_, g68_2_)) b.set(term_, g69_);
    b.set_call(plane_, 0);
    for (const char axis : {'X', 'Y', 'Z'}) b.set_word(plane_, 0, axis, 0);
    for (std::size_t i = 0; i < 3; ++i) b.set_word(plane_, 0, "IJK"[i], angles[i]);
    b.set_word(plane_, 0, 'P', 1);
    b.set_word(plane_, 0, 'Q', 123);
    if (command_.plane.kind == PlaneDefinition::axial)
      return position(b, axes_.are_inside(axial) ? std::optional(axial) : std::nullopt);
    auto upright = axes_ ? axes_.choose({(*m)[8], (*m)[9], (*m)[10]}, now, command_.sequence) : std::nullopt;
    if (upright) upright = axes_.with_free_axis(*upright, *m, now, command_.turns_table);
    position(b, upright);
  }

  /// `angles` are those of the plane; nothing where no solution is inside the travel.
  void position(ig::Block& b, const std::optional<Angles>& angles) {
    if (!axes_) {
      // They are 0 from here on, so that syntaxes that read them report nothing for the same cause.
      QStore* const store = values_.store();
      for (std::uint32_t q = 120; q <= 122 && store != nullptr; ++q)
        if (std::isnan(store->get({QKind::q, q}, 0))) store->set({QKind::q, q}, 0, 0);
      b.report(ig::diag("HEI-0172"), where(), shown(),
               std::string_view(command_.move == Move::stay || command_.move == Move::none
                                    ? "Q120 to Q122 are not known: those without a value are assumed to be 0"
                                    : "they do not turn, and Q120 to Q122 are not known"));
      retract(b);
      return;
    }
    if (!angles) {
      b.report(ig::diag("HEI-0176"), where(),
               std::string_view(command_.sequence > 0   ? " with SEQ+"
                                : command_.sequence < 0 ? " with SEQ-"
                                                        : ""));
      b.alarm();
      b.set(stay_, true);
      return;
    }
    if (QStore* const store = values_.store())
      for (std::size_t axis = 0; axis < 3; ++axis)
        store->set({QKind::q, static_cast<std::uint32_t>(120 + axis)}, 0,
                   axes_.machine().has(axis) ? rounded((*angles)[axis] - rotary_offset_.get(b).value[axis]) : 0);
    if (command_.move != Move::turn && command_.move != Move::move) {
      b.set(stay_, true);
      return;
    }
    const std::size_t row = command_.move == Move::turn ? 0 : 1;
    retract(b);
    b.set_call(turn_, row);
    if (row == 1 && command_.distance != 0) b.set_word(turn_, row, 'R', command_.distance);
    turn_axes(b, *angles);
  }

  void turn_axes(ig::Block& b, const Angles& angles) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axes_.machine().has(axis)) b.set(rotary_[axis], rounded(angles[axis]));
    b.raise(motions_.id(command_.is_rapid ? 0 : 1));
  }

  void end_plane(ig::Block& b) {
    if (b.is(term_, g68_2_)) b.raise(end_.id(0));
    if (command_.move != Move::turn && command_.move != Move::move) return;
    if (!axes_) {
      b.report(ig::diag("HEI-0172"), where(), shown(), std::string_view("they do not turn"));
      retract(b);
      return;
    }
    if (command_.move == Move::move)
      b.report(ig::diag("HEI-0171"), where(), std::string_view("MOVE of PLANE RESET"),
               std::string_view("the axes turn as with TURN, and the tool tip leaves its place"));
    retract(b);
    turn_axes(b, {});
  }

  /// MB: KlartextPlaneRetractSyntax retracts before the axes turn. Only along Z of the machine, where no head is
  /// tilted.
  void retract(ig::Block& b) const {
    if (!command_.retract || (command_.move != Move::turn && command_.move != Move::move)) return;
    const Angles now = axes_.present(b);
    bool is_upright = command_.move == Move::turn && bool(axes_);
    for (std::size_t k = 0; is_upright && k < axes_.machine().count(); ++k)
      is_upright = axes_.machine().is_table(k) || std::fabs(now[axes_.machine().axis(k)]) < 1e-9;
    const Retract& way = *command_.retract;
    if (!is_upright)
      b.report(ig::diag("HEI-0171"), ig::Where::columns(way.begin, way.end),
               trim(piece(b.source(), way.begin, std::min(way.end, b.source().size()))),
               std::string_view("the tool does not retract before it turns"));
    else if (way.distance)
      b.set(retract_, *way.distance);
    else
      b.set(to_limit_, true);
  }

  Command command_;
};

const ig::Register<KlartextPlane> klartext_plane_syntax;

}  // namespace
}  // namespace heidenhain
