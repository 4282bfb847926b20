// CC sets the pole of arcs and polar coordinates. The two axes that it names also select the plane: after CC Y Z with
// the tool along Z, arcs stand upright.
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPole {
  static constexpr auto spec = ig::syntax("KlartextPoleSyntax", "CC, the pole, and the plane of the arcs about it.")
                                   .after("KlartextPathSyntax", "UnitModeSyntax", "PlaneSelectSyntax")
                                   .before("KlartextMotionSyntax", "CircularMotionSyntax");

  ig::Signal wakes_{"KlartextPath.~Pole", ig::read | ig::wake};
  ig::In<ig::Symbol> function_{"KlartextPath.Function"};
  ig::Xyz words_{"Parsing", ig::read | ig::take};
  std::array<ig::Word, 3> steps_{ig::Word{"Parsing.IX", ig::take}, ig::Word{"Parsing.IY", ig::take},
                                 ig::Word{"Parsing.IZ", ig::take}};
  std::array<ig::Word, 6> rotary_{ig::Word{"Parsing.A", ig::take, "deg"},  ig::Word{"Parsing.B", ig::take, "deg"},
                                  ig::Word{"Parsing.C", ig::take, "deg"},  ig::Word{"Parsing.IA", ig::take, "deg"},
                                  ig::Word{"Parsing.IB", ig::take, "deg"}, ig::Word{"Parsing.IC", ig::take, "deg"}};
  ig::Xyz pole_{"KlartextPath.Pole", ig::read | ig::write, {ig::Life::modal, "mm", "The pole CC, in its plane."}};
  ig::Out<ig::Symbol> pole_plane_{
      "KlartextPath.PolePlane",
      {ig::Life::modal, "", "G17, G18 or G19: the plane that CC named, where it is not the one across the tool."}};
  /// The plane that is in force again after a block in the plane of the pole.
  ig::Out<ig::Symbol> working_plane_{"KlartextPath.WorkingPlane",
                                     {ig::Life::modal, "", "The plane across the tool, behind an arc in another."}};
  ig::Signal turned_{"KlartextPath.~PlaneTurned", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Out<ig::Symbol> term_{"PlaneSelect.Term"};
  ig::Out<ig::Symbol> plane_name_{"PlaneSelect.Plane"};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ScaleAndMirror mirror_;
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  std::array<ig::Name, 3> planes_{ig::Name{"G17"}, ig::Name{"G18"}, ig::Name{"G19"}};
  std::array<ig::Name, 3> names_{ig::Name{"XY"}, ig::Name{"ZX"}, ig::Name{"YZ"}};
  ig::Name lp_{"LP"}, c_{"C"}, cc_{"CC"}, cp_{"CP"}, ctp_{"CTP"};

  ig::Status build(ig::Block& b) const {
    const bool was_turned = b.is_raised(turned_);
    if (was_turned) {
      b.erase(turned_);
      if (!b.is_fresh(term_)) select(b, b.get_or(working_plane_, ig::Symbol(planes_[0])));
      b.erase(working_plane_);
    }
    const ig::Symbol function = b.get_or(function_, ig::Symbol{});
    if (function == cc_) {
      set_pole(b);
      return ig::Status::changed;
    }
    const bool is_about_pole = function == c_ || function == cp_ || function == lp_ || function == ctp_;
    const auto plane = b.get(pole_plane_);
    if (!is_about_pole || !plane) return was_turned ? ig::Status::changed : ig::Status::unchanged;
    b.set(working_plane_, b.get(term_).value_or(ig::Symbol(planes_[0])));
    b.raise(turned_);
    select(b, *plane);
    return ig::Status::changed;
  }

 private:
  void select(ig::Block& b, ig::Symbol plane) const {
    b.set(term_, plane);
    b.set(plane_name_, plane == planes_[1] ? names_[1] : plane == planes_[2] ? names_[2] : names_[0]);
  }
  /// The plane of two axes, given as a mask.
  std::size_t plane_of(std::uint32_t axes) const { return axes == 3 ? 0 : axes == 5 ? 1 : 2; }

  void set_pole(ig::Block& b) const {
    const ig::PartialVec3 positions = b.get(words_);
    for (const ig::Word& word : rotary_) {
      const auto where = ig::Where::word(word.id());
      if (b.take(word))
        b.report(ig::diag("HEI-0105"), where, std::string_view("a rotary axis"), std::string_view("CC"));
    }
    ig::Vec3 last = last_(b);
    if (b.has(mirror_term_)) last = rounded(mirror_.programmed(b, last));
    std::uint32_t named = positions.mask;
    ig::Vec3 steps;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto step = b.take(steps_[axis])) {
        named |= 1u << axis;
        steps[axis] = *step;
        if (!positions.has(axis)) steps[axis] += last[axis];
      }
    choose_plane(b, named);
    // CC alone is the position of the tool; an axis that is not named keeps its pole.
    ig::Vec3 pole = named == 0 ? last : b.get(pole_).or_else(last);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named >> axis & 1u) != 0) pole[axis] = positions.has(axis) ? positions.value[axis] : steps[axis];
    b.set(pole_, pole);
    b.take(words_);
  }

  void choose_plane(ig::Block& b, std::uint32_t named) const {
    const std::uint32_t tool = 1u << plane_(b).tool, across = 7u & ~tool;
    const auto before = b.get(pole_plane_);
    const std::uint32_t kept = before == planes_[0] ? 3u : before == planes_[1] ? 5u : before ? 6u : across;
    const bool is_pair = named == 3 || named == 5 || named == 6;
    if (is_pair && named != across) {
      b.set(pole_plane_, planes_[plane_of(named)]);
    } else if (!is_pair && named != 0 && named != 7 && (named & ~kept) == 0) {
      return;  // one axis of the plane that the pole lies in
    } else {
      if ((named & tool) != 0)
        b.report(ig::diag("HEI-0105"), ig::Where::block(), std::string_view("the tool axis"), std::string_view("CC"));
      b.erase(pole_plane_);
    }
  }
};

const ig::Register<KlartextPole> klartext_pole_syntax;

}  // namespace
}  // namespace heidenhain
