// LN … TX TY TZ: under M128 or FUNCTION TCPM the rotary axes turn the tool into the direction of the vector. The block
// becomes one of G43.5, which ToolCenterPointSyntax executes; the next block without a vector is one of G43.4 again.
#include <isogloss_tool.h>

#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextToolVector {
  static constexpr auto spec = ig::syntax("KlartextToolVectorSyntax", "LN with TX TY TZ: the direction of the tool.")
                                   .after("KlartextPathSyntax", "KlartextRotaryStepSyntax", "G53p1RotaryPositionSyntax")
                                   .before("ToolCenterPointSyntax", "KlartextMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0376", "TX TY TZ of LN is not executed, so the rotary axes stay: {0}"),
      ig::diagnostic(IG_ERROR, "HEI-0378",
                     "NX NY NZ of LN is not executed, so the path lacks the delta {0} mm of the tool's radius"),
      ig::diagnostic(IG_ERROR, "HEI-0377",
                     "{0} is ignored, because TX TY TZ of the same block turns the rotary axes: leave one of them out"),
  };

  std::array<ig::Word, 3> vector_{ig::Word{"Parsing.TX", ig::wake, ""}, ig::Word{"Parsing.TY", ig::wake, ""},
                                  ig::Word{"Parsing.TZ", ig::wake, ""}};
  std::array<ig::Word, 3> normal_{ig::Word{"Parsing.NX", ig::wake, ""}, ig::Word{"Parsing.NY", ig::wake, ""},
                                  ig::Word{"Parsing.NZ", ig::wake, ""}};
  std::array<ig::Word, 3> direction_{ig::Word{"Parsing.I", ig::write}, ig::Word{"Parsing.J", ig::write},
                                     ig::Word{"Parsing.K", ig::write}};
  std::array<ig::Word, 3> rotary_{ig::Word{"Parsing.A", ig::take, "deg"}, ig::Word{"Parsing.B", ig::take, "deg"},
                                  ig::Word{"Parsing.C", ig::take, "deg"}};
  ig::Call tip_{{"G43.4", "G43.5"}, "H[]", ig::read | ig::write};
  ig::Codes ends_{{"G43", "G49"}, ig::read};
  ig::InWhile<ig::Symbol> by_direction_{"ToolHeightCompensation.Term", "G43.5"};
  ig::In<double> delta_{"RadiusCompensation.Delta_mm",
                        ig::read,
                        {ig::Life::modal, "mm", "What the tool call adds to the radius of the table."}};
  ig::In<std::int64_t> row_{"ToolHeightCompensation.OffsetId"};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "The delta of the radius."};
  ig::Signal normal_said_{"KlartextToolVector.~NormalSaid", ig::read | ig::write, ig::Life::modal};
  ig::Signal said_{"KlartextToolVector.~Said", ig::read | ig::write, ig::Life::modal};
  ToolCenterMode mode_;
  ToolKinematics machine_;
  ig::Name g43_5_{"G43.5"};

  ig::Status build(ig::Block& b) const {
    const bool has_vector = b.has(vector_[0]) || b.has(vector_[1]) || b.has(vector_[2]);
    const bool is_by_vector = b.is(by_direction_, g43_5_), names_mode = b.find(tip_) || b.find(ends_);
    const bool has_normal = take_normal(b);
    if (!has_vector) {
      if (!is_by_vector || names_mode) return has_normal ? ig::Status::changed : ig::Status::unchanged;
      b.set_call(tip_, 0);
      return ig::Status::changed;
    }
    ig::Vec3 v;
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis] = b.take(vector_[axis]).value_or(0);
    if (v == ig::Vec3{}) return refuse(b, "TX0 TY0 TZ0 is no direction");
    if (!mode_.is_on(b) || names_mode) return refuse(b, "program M128 or FUNCTION TCPM in a block before it");
    if (!machine_) return refuse(b, "the rotary axes of the machine are not described");
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (machine_.has(axis) && b.take(rotary_[axis]))
        b.report(ig::diag("HEI-0377"), ig::Where::block(), std::string_view("ABC").substr(axis, 1));
    for (std::size_t axis = 0; axis < 3; ++axis) b.set(direction_[axis], v[axis]);
    if (!is_by_vector) b.set_call(tip_, 1);
    return ig::Status::changed;
  }

 private:
  /// The control shifts the path along NX NY NZ by the deltas of the tool's radius; without them it is as here.
  bool take_normal(ig::Block& b) const {
    bool any = false;
    for (const ig::Word& word : normal_) any |= b.take(word).has_value();
    if (!any || b.is_raised(normal_said_)) return any;
    double delta = b.get_or(delta_, 0.0), wear = 0;
    if (const auto row = b.get(row_); row && tools_ && tools_->get(tools_->self, *row, IG_TOOL_RADIUS_WEAR, &wear) != 0)
      delta += wear;
    if (delta == 0) return any;
    b.report(ig::diag("HEI-0378"), ig::Where::block(), delta);
    b.raise(normal_said_);
    return any;
  }

  /// Once in a run, since whole programs are full of vectors.
  ig::Status refuse(ig::Block& b, std::string_view reason) const {
    if (!b.is_raised(said_)) b.report(ig::diag("HEI-0376"), ig::Where::block(), reason);
    b.raise(said_);
    return ig::Status::changed;
  }
};

const ig::Register<KlartextToolVector> klartext_tool_vector_syntax;

}  // namespace
}  // namespace heidenhain
