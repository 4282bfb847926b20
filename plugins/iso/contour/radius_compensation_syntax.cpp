/// G40, G41, G42 and D: whether the tool runs beside the contour, on which side, and at what distance.
/// RadiusCompensationPathSyntax makes the tool's path from this state. Fanuc manual, "Cutter compensation".
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "contour/contour_motion.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class OffsetIs { radius, diameter };
enum class OffsetWord { d, d_or_h };
enum class TableChange { next_block, next_d };
enum class CornerCode { none, g39 };

struct RadiusCompensation {
  static constexpr auto spec =
      ig::syntax("RadiusCompensationSyntax", "G40/G41/G42 and D: side and radius of cutter compensation.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "ToolHeightOffsetSyntax", "ProgrammableMirrorSyntax",
                 "ProgramXyzSyntax", "CircularMotionSyntax", "LinearMotionSyntax", "ReferenceReturnSyntax",
                 "ReturnFromReferenceSyntax", "ReferenceCheckSyntax")
          .before("RadiusCompensationPathSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0477",
                     "the radius of D{0} is too large: radius 0 is assumed, so check the tool table"),
  };

  ig::Codes codes_{"G40", "G41", "G42"};
  ig::Word d_{"Parsing.D", ig::wake, ""};
  std::array<ig::Word, 3> direction_words_{ig::Word{"Parsing.I", ig::take}, ig::Word{"Parsing.J", ig::take},
                                           ig::Word{"Parsing.K", ig::take}};
  ig::Out<ig::Symbol> term_{"RadiusCompensation.Term"};
  ig::Out<ig::Symbol> side_{"RadiusCompensation.Side"};
  ig::Out<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  ig::Out<double> radius_{"RadiusCompensation.Radius_mm"};
  ig::In<double> delta_{"RadiusCompensation.Delta_mm",
                        ig::read,
                        {ig::Life::modal, "mm", "What the tool call adds to the radius of the table."}};
  ig::Xyz direction_{"RadiusCompensation.CancelDirection",
                     ig::write,
                     {ig::Life::block, "mm", "Direction of the wall that the contour ends at, as programmed."}};
  /// Raised while compensation is in force, and after its cancelling up to the straight move that brings the tool back
  /// to the programmed point. It is a signal, because G40 stands at the start of most programs and must not wake a
  /// syntax in every later block.
  ig::Signal active_{"RadiusCompensation.~Active", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal path_{"RadiusCompensation.~Path", ig::write};
  ig::Call corner_arc_code_{{"G39"}, "I J K"};
  ig::Out<ig::Symbol> corner_arc_{"RadiusCompensation.CornerArc",
                                  {ig::Life::block, "", "The code that turns the corner where the tool is on an arc."}};
  ig::Xyz corner_direction_{"RadiusCompensation.CornerDirection",
                            ig::write,
                            {ig::Life::block, "mm", "Direction square to which the arc of G39 ends, as programmed."}};
  ig::In<std::int64_t> length_id_{"ToolHeightCompensation.OffsetId"};
  ig::Signal table_changed_{"ToolHeightCompensation.~TableChanged", ig::read | ig::wake};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::required, "Radius geometry and wear."};
  ContourMotionOf motion_;
  ScaleAndMirror scale_and_mirror_;
  ig::Name g40_{"G40"}, g41_{"G41"}, g42_{"G42"}, left_{"Left"}, right_{"Right"}, none_{"None"};

  ig::Choice<OffsetIs> offset_is_{"offset-is", "radius|diameter", "radius", "What the tool table holds in D."};
  ig::Choice<OffsetWord> offset_word_{"offset-word", "d|d-or-h", "d",
                                      "Whether H in the block of G41 or G42 selects the radius if D is missing."};
  ig::Choice<TableChange> table_change_{"table-change", "next-block|next-d", "next-block",
                                        "When a radius that the program changes under compensation takes effect."};

  ig::Choice<CornerCode> corner_code_{"corner-arc", "none|G39", "G39",
                                      "The code that makes the tool turn a corner on an arc."};

  bool is_zero_reported_ = false;

  ig::Status restart(ig::Block& b) {
    is_zero_reported_ = false;
    if (!is_on(b)) return ig::Status::unchanged;
    find_radius(b, ig::Where::block());
    b.raise(active_);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const bool was_on = is_on(b);
    const auto code = take_modal(b, codes_);
    const auto d = b.take(d_);
    const auto where = d ? ig::Where::word(d_.id()) : code ? ig::Where::word(codes_.id(*code)) : ig::Where::block();
    if (d) set_offset_id(b, *d, where);
    if (code) b.set(term_, codes_.name(*code));
    const bool has_g39 = corner_code_ == CornerCode::g39 && find_corner_arc(b);
    if (!is_on(b))
      return leave(b, code.has_value(), was_on) || d || has_g39 ? ig::Status::changed : ig::Status::unchanged;

    if (code && !d) name_offset_without_d(b, *code, where);
    const bool asks_again = b.is_raised(table_changed_) && table_change_ == TableChange::next_block;
    if (code || d || asks_again || !b.has(radius_)) find_radius(b, where);
    const bool is_left = b.is(term_, g41_) != scale_and_mirror_.swaps_sense(b, motion_(b).plane);
    if (const ig::Name& side = is_left ? left_ : right_; !b.is(side_, side)) b.set(side_, side);
    if (!b.is_raised(active_)) b.raise(active_);
    b.raise(path_);
    return ig::Status::changed;
  }

 private:
  bool is_on(const ig::Block& b) const { return b.is(term_, g41_) || b.is(term_, g42_); }

  bool find_corner_arc(ig::Block& b) const {
    if (!b.find(corner_arc_code_)) return false;
    const ig_field code = corner_arc_code_.code(0);
    const auto words = *b.take(corner_arc_code_);
    const ContourMotion motion = motion_(b);
    const bool moves = motion.kind != ContourMotion::Kind::rest || motion.has_event;
    if (!is_on(b) || moves) {
      b.report(ig::diag("ISO-0478"), ig::Where::word(code),
               std::string_view(moves ? "its block moves" : "neither G41 nor G42 is in force"));
      return true;
    }
    b.set(corner_arc_, words.code);
    ig::Vec3 way;
    for (const std::size_t axis : {motion.plane.first, motion.plane.second})
      way[axis] = scale_and_mirror_.axis(b, axis).factor * words["IJK"[axis]].value_or(0);
    if (way != ig::Vec3{}) b.set(corner_direction_, way);
    return true;
  }

  /// Compensation ends at once, or with the first straight move in the plane, which brings the tool back to the
  /// contour.
  bool leave(ig::Block& b, bool has_code, bool was_on) const {
    if (has_code) {
      b.set(side_, none_);
      b.erase(radius_);
      if (was_on) b.raise(active_);
    }
    if (!b.is_raised(active_)) return has_code;
    b.raise(path_);
    const ContourMotion motion = motion_(b);
    if (has_code && !motion.move.is_arc) take_direction(b, motion.plane);
    const bool is_straight = motion.kind == ContourMotion::Kind::move && !motion.move.is_arc;
    if (is_straight || motion.kind == ContourMotion::Kind::by_steps) b.erase(active_);
    return true;
  }

  void take_direction(ig::Block& b, const PlaneAxes& plane) const {
    const auto first = b.take(direction_words_[plane.first]), second = b.take(direction_words_[plane.second]);
    if (!first && !second) return;
    ig::Vec3 way;
    way[plane.first] = scale_and_mirror_.axis(b, plane.first).factor * first.value_or(0);
    way[plane.second] = scale_and_mirror_.axis(b, plane.second).factor * second.value_or(0);
    b.set(direction_, way);
  }

  void set_offset_id(ig::Block& b, double d, ig::Where where) const {
    if (const auto id = whole_number(d)) {
      b.set(offset_id_, *id);
    } else {
      b.report(ig::diag("ISO-0463"), where, d);
    }
  }

  void name_offset_without_d(ig::Block& b, std::size_t code, ig::Where where) const {
    if (offset_word_ == OffsetWord::d_or_h && b.is_fresh(length_id_)) {
      b.set(offset_id_, b.get_or(length_id_, std::int64_t{0}));
    } else if (!b.has(offset_id_)) {
      b.report(ig::diag("ISO-0461"), where, b.text(codes_.name(code)));
      b.set(offset_id_, std::int64_t{0});
    }
  }

  static constexpr double largest_radius = 1e9;  ///< mm; no position is larger

  void find_radius(ig::Block& b, ig::Where where) {
    const std::int64_t id = b.get_or(offset_id_, std::int64_t{0});
    double geometry = 0, wear = 0;
    if (id != 0) {
      const bool has_geometry = table_->get(table_->self, id, 2, &geometry) != 0;
      const bool has_wear = table_->get(table_->self, id, 3, &wear) != 0;
      if (!has_geometry && !has_wear) b.report(ig::diag("ISO-0462"), where, static_cast<double>(id));
      if (!has_geometry) geometry = 0;
      if (!has_wear) wear = 0;
      if ((has_geometry || has_wear) && geometry + wear == 0 && !is_zero_reported_) {
        is_zero_reported_ = true;
        b.report(ig::diag("ISO-0464"), where, static_cast<double>(id));
      }
    }
    double radius = (geometry + wear) / (offset_is_ == OffsetIs::diameter ? 2 : 1) + b.get_or(delta_, 0.0);
    if (!(std::fabs(radius) < largest_radius)) {
      b.report(ig::diag("ISO-0477"), where, static_cast<double>(id));
      radius = 0;
    }
    b.set(radius_, radius);
  }
};

const ig::Register<RadiusCompensation> radius_compensation_syntax;

}  // namespace
}  // namespace iso
