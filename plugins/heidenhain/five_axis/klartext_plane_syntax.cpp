// PLANE SPATIAL, EULER, VECTOR, POINTS, AXIAL, RELATIV and RESET: the tilted working plane. The plane becomes a G68.2
// with three spatial angles, its positioning a G53.1 (TURN) or a G53.6 (MOVE) with the angles that are found here.
// These angles also go to Q120 to Q122, for the block that positions the axes after STAY.
#include <isogloss/cnc/program_xyz.hpp>

#include "five_axis/plane_definition.hpp"
#include "five_axis/plane_positioning.hpp"
#include "five_axis/plane_statement.hpp"
#include "frames/basic_rotation.hpp"
#include "frames/rotary_datum.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPlane {
  static constexpr auto spec = ig::syntax("KlartextPlaneSyntax", "PLANE and CYCL DEF 19: tilted planes.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("KlartextCycleSyntax", "IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax",
                                           "ToolCenterPointSyntax", "KlartextMotionSyntax", "McAbcSyntax")
                                   .scans("CPcp")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0170",
                     "{0}: {1} is missing or is not a number, so the previous plane stays in force"),
      ig::diagnostic(IG_ERROR, "HEI-0172", "{0}: the machine's rotary axes are not known, so that {1}"),
      ig::diagnostic(IG_ERROR, "HEI-0176",
                     "no position of the rotary axes within their travel gives this plane{0}: the axes do not move"),
  };

  PlaneStatement text_;
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
  ToolCenterMode mode_;
  ig::Name g69_{"G69"}, g68_2_{"G68.2"}, g43_{"G43"};
  ig::Out<double> retract_{"KlartextPlane.Retract_mm",
                           {ig::Life::block, "mm", "MB: how far the tool goes out before the axes turn."}};
  ig::Out<bool> to_limit_{"KlartextPlane.RetractsToLimit",
                          {ig::Life::block, "", "MB MAX: the tool goes out to the end of the travel."}};
  RotaryDatum rotary_offset_{ig::read};
  std::array<ig::In<double>, 3> rotation_{rotation("BasicRotation.SPA"), rotation("BasicRotation.SPB"),
                                          rotation("BasicRotation.SPC")};
  PlanePositioning axes_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position)) return position;
    const std::size_t plane = keyword(text, position, "PLANE");
    const std::size_t cycle = PlaneStatement::behind_cycle_19(text, position);
    if ((plane == position && cycle == position) || !b.is_in_turn()) return position;
    const std::size_t end = statement_end(text, position);
    if (text_.values().is_indexing()) return end;
    command_ = {};
    command_.begin = position;
    command_.end = position + trim(piece(text, position, end)).size();
    const std::string_view statement = text.substr(0, end);
    if (cycle != position) text_.read_cycle(b, statement, cycle, angles_in_force(b), command_);
    if (cycle != position || text_.read(b, statement, plane, command_)) b.raise(statement_);
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
  static ig_field rotary(const char* path) {
    return ig::Field<double>(path, ig::read | ig::write, {ig::Life::standard, "deg", ""}).id();
  }

  static ig::In<double> rotation(const char* path) {
    return ig::In<double>{path, ig::read, {ig::Life::modal, "deg", ""}};
  }

  /// The spatial angles of the plane in force.
  std::optional<ig::Vec3> angles_in_force(const ig::Block& b) const {
    if (!b.is(term_, g68_2_)) return std::nullopt;
    return ig::Vec3{b.get_or(angles_[0], 0.0), b.get_or(angles_[1], 0.0), b.get_or(angles_[2], 0.0)};
  }
  Mat4 plane_in_force(const ig::Block& b) const {
    const auto angles = angles_in_force(b);
    return angles ? PlaneDefinition::spatial_plane(*angles) : identity_frame;
  }

  /// The basic rotation of the preset. The entry of the frame is not read here: a syntax of this stage would decide
  /// its place among the entries.
  std::optional<Mat4> basic_rotation(const ig::Block& b) const {
    const ig::Vec3 angles{b.get_or(rotation_[0], 0.0), b.get_or(rotation_[1], 0.0), b.get_or(rotation_[2], 0.0)};
    return angles != ig::Vec3{} ? std::optional(BasicRotations::matrix(angles)) : std::nullopt;
  }

  void tilt(ig::Block& b) {
    const Angles now = axes_.present(b);
    Angles axial = now;
    for (std::size_t axis = 0; axis < 3 && command_.plane.kind == PlaneDefinition::axial; ++axis)
      if (const auto word = command_.plane.words[axis]) axial[axis] = *word + rotary_offset_.get(b)[axis];
    if (command_.plane.kind == PlaneDefinition::axial && !axes_) {
      b.report(ig::diag("HEI-0172"), command_.where(), command_.shown(), std::string_view("the plane stays"));
      return;
    }
    for (std::size_t axis = 0; axis < 3 && command_.plane.kind == PlaneDefinition::axial; ++axis)
      if (command_.plane.words[axis] && !axes_.machine().has(axis))
        b.report(ig::diag("HEI-0171"), command_.where(), std::string_view("ABC").substr(axis, 1),
                 std::string_view("the machine has no such axis"));
    auto m = command_.plane.frame(plane_in_force(b), axial, axes_.machine());
    const auto rotation = basic_rotation(b);
    // Angles of axes give the plane in the machine; the other words give it in the rotated workpiece.
    if (m && rotation && command_.plane.kind == PlaneDefinition::axial) m = product(*m, inverse(*rotation));
    if (!m && command_.plane.kind == PlaneDefinition::axial) {
      b.report(
          ig::diag("HEI-0171"), command_.where(), command_.shown(),
          std::string_view("the head has two axes, one of them inclined, turned round or shifted: the plane stays"));
      return;
    }
    if (!m || !is_finite(*m)) {
      b.report(ig::diag("HEI-0170"), command_.where(), command_.shown(), std::string_view("a direction"));
      return;
    }
    const ig::Vec3 angles = command_.plane.kind == PlaneDefinition::spatial ? command_.plane.words_from(0)
                                                                            : PlaneDefinition::spatial_angles(*m);
    // PLANE ends tool centre point control.
    if (mode_.is_on(b)) {
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
    const Mat4 lies = rotation ? product(*m, *rotation) : *m;  // in the machine
    auto upright = axes_ ? axes_.choose({lies[8], lies[9], lies[10]}, now, command_.sequence) : std::nullopt;
    if (upright) upright = axes_.with_free_axis(*upright, lies, now, command_.turns_table);
    position(b, upright);
  }

  /// `angles` are those of the plane; nothing where no solution is inside the travel.
  void position(ig::Block& b, const std::optional<Angles>& angles) {
    if (!axes_) {
      // They are 0 from here on, so that syntaxes that read them report nothing for the same cause.
      QStore* const store = text_.values().store();
      for (std::uint32_t q = 120; q <= 122 && store != nullptr; ++q)
        if (std::isnan(store->get({QKind::q, q}, 0))) {
          store->set({QKind::q, q}, 0, 0);
          text_.values().note(b, q, 0);
        }
      b.report(ig::diag("HEI-0172"), command_.where(), command_.shown(),
               std::string_view(command_.turns_axes()
                                    ? "they do not turn, and Q120 to Q122 are not known"
                                    : "Q120 to Q122 are not known: those without a value are assumed to be 0"));
      retract(b);
      return;
    }
    if (!angles) {
      b.report(ig::diag("HEI-0176"), command_.where(),
               std::string_view(command_.sequence > 0   ? " with SEQ+"
                                : command_.sequence < 0 ? " with SEQ-"
                                                        : ""));
      b.alarm();
      b.set(stay_, true);
      return;
    }
    if (QStore* const store = text_.values().store())
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const double angle = axes_.machine().has(axis) ? rounded((*angles)[axis] - rotary_offset_.get(b)[axis]) : 0;
        store->set({QKind::q, 120 + axis}, 0, angle);
        text_.values().note(b, 120 + axis, angle);
      }
    if (!command_.turns_axes()) {
      b.set(stay_, true);
      return;
    }
    const std::size_t row = command_.move == PlaneCommand::Move::turn ? 0 : 1;
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
    if (!command_.turns_axes()) return;
    if (!axes_) {
      b.report(ig::diag("HEI-0172"), command_.where(), command_.shown(), std::string_view("they do not turn"));
      retract(b);
      return;
    }
    if (command_.move == PlaneCommand::Move::move)
      b.report(ig::diag("HEI-0171"), command_.where(),
               std::string_view(command_.is_cycle ? "DIST of CYCL DEF 19" : "MOVE of PLANE RESET"),
               std::string_view("the axes turn as with TURN, and the tool tip leaves its place"));
    retract(b);
    turn_axes(b, {});
  }

  /// MB: KlartextPlaneRetractSyntax retracts before the axes turn. Only along Z of the machine, where no head is
  /// tilted.
  void retract(ig::Block& b) const {
    if (!command_.retract || !command_.turns_axes()) return;
    const Angles now = axes_.present(b);
    bool is_upright = command_.move == PlaneCommand::Move::turn && bool(axes_);
    for (std::size_t k = 0; is_upright && k < axes_.machine().count(); ++k)
      is_upright = axes_.machine().is_table(k) || std::fabs(now[axes_.machine().axis(k)]) < 1e-9;
    const PlaneCommand::Retract& way = *command_.retract;
    if (!is_upright)
      b.report(ig::diag("HEI-0171"), ig::Where::columns(way.begin, way.end),
               trim(piece(b.source(), way.begin, std::min(way.end, b.source().size()))),
               std::string_view("the tool does not retract before it turns"));
    else if (way.distance)
      b.set(retract_, *way.distance);
    else
      b.set(to_limit_, true);
  }

  PlaneCommand command_;
};

const ig::Register<KlartextPlane> klartext_plane_syntax;

}  // namespace
}  // namespace heidenhain
