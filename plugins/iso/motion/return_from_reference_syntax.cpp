/// G29: from a reference position back to work, through the intermediate point of the last G28 or G30, by rapid and
/// with the named axes only. Under G91 the words are distances from the intermediate point. It runs before
/// ReferenceReturnSyntax, which takes the words of G28 and G30. Fanuc manual, "Reference position".
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_offset.hpp>

#include "motion/reference_position.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct ReturnFromReference {
  static constexpr auto spec = ig::syntax("ReturnFromReferenceSyntax", "G29 returns through the intermediate point.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax", "McXyzSyntax",
                                          "LinearMotionSyntax", "IncrementalResolveSyntax")
                                   .before("ReferenceReturnSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0381",
                     "G29 {0}: no earlier G28 or G30 has set an intermediate point, so the axis goes straight"),
  };

  ig::Call passed_{{"G28", "G30"}, "X Y Z A B C", ig::read | ig::wake};
  ig::Call g29_{{"G29"}, "X Y Z A B C"};
  ReferenceMove move_;
  ig::Xyz intermediate_{"ReferenceReturn.Intermediate", ig::read | ig::write};
  std::array<ig::Out<double>, 3> turned_over_{ig::Out<double>{"ReferenceReturn.Intermediate.A", kept},
                                              ig::Out<double>{"ReferenceReturn.Intermediate.B", kept},
                                              ig::Out<double>{"ReferenceReturn.Intermediate.C", kept}};
  DistanceMode distance_;
  LastProgramXyz last_;
  RotaryOffsets offsets_{ig::read};
  RotaryAxes axes_;
  FurtherAxisOrder further_{"G29"};

  ig::Status build(ig::Block& b) {
    const bool stored = keep_intermediate(b);
    const auto words = b.take(g29_);
    if (!words) return stored ? ig::Status::changed : ig::Status::unchanged;
    go(b, *words);
    return ig::Status::changed;
  }

 private:
  static constexpr ig::About kept{ig::Life::modal, "deg", "Where G28 or G30 sent the axis first, for G29."};

  bool keep_intermediate(ig::Block& b) const {
    const auto row = b.find(passed_);
    if (!row) return false;
    ig_value values[6];
    const std::uint32_t named = b.get_many(passed_.row(*row), 6, values);
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const ig_field place = axis < 3 ? intermediate_.id(axis) : turned_over_[axis - 3].id();
      if ((named >> axis & 1u) == 0) continue;
      if (axis >= 3) values[axis].number = of_program(b, axis - 3, values[axis].number);
      b.set(place, values[axis]);
    }
    return named != 0;
  }

  /// The intermediate point is a program point: a work offset that changes afterwards moves it.
  double of_program(const ig::Block& b, std::size_t axis, double machine) const {
    const double offset = offsets_.get(b)[axis];
    if (axes_.rollover(axis) == Rollover::signed_direction && !distance_.is_incremental(b))
      machine = std::fabs(machine);
    return offset == 0 ? machine : rounded(machine - offset);
  }

  void go(ig::Block& b, const ig::Words& words) const {
    further_.give(b);
    const auto axes = move_.named(b, words, g29_);
    if (!axes) return;
    const auto& [named, turned] = *axes;
    const ig::Vec3 over = intermediate(b, named);
    ig::Vec3 end = over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis)) end[axis] = distance_.is_incremental(b) ? over[axis] + named.value[axis] : named.value[axis];
    const auto machine_over = b.to_machine(over), machine_end = b.to_machine(end);
    if (!machine_over || !machine_end) {
      not_invertible(b);
      return;
    }
    const PartialAngles turned_over = intermediate(b, turned), turned_end = turn_on(b, turned, turned_over);

    move_.begin(b, words.code);
    move_.pass(b, over, *machine_over, turned_over);
    move_.arrive(b, end, *machine_end, turned_end);
  }

  ig::Vec3 intermediate(ig::Block& b, const ig::PartialVec3& named) const {
    const ig::PartialVec3 stored = b.get(intermediate_);
    ig::Vec3 over = last_(b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!named.has(axis)) continue;
      if (stored.has(axis))
        over[axis] = stored.value[axis];
      else
        report_straight(b, "XYZ"[axis]);
    }
    return over;
  }
  PartialAngles intermediate(ig::Block& b, const PartialAngles& named) const {
    const Angles from = move_.rotary.present(b);
    PartialAngles over{named.mask, from};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!named.has(axis)) continue;
      if (const auto stored = b.get(turned_over_[axis]))
        over.value[axis] = move_.rotary.to_machine(axis, from[axis], *stored + offsets_.get(b)[axis]);
      else
        report_straight(b, rotary_names[axis]);
    }
    return over;
  }
  PartialAngles turn_on(const ig::Block& b, const PartialAngles& named, const PartialAngles& over) const {
    PartialAngles end = over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis))
        end.value[axis] = distance_.is_incremental(b)
                              ? over.value[axis] + named.value[axis]
                              : move_.rotary.approach(axis, over.value[axis], named.value[axis]);
    return end;
  }
  void report_straight(ig::Block& b, char axis) const {
    b.report(ig::diag("ISO-0381"), ig::Where::word(g29_.word(0, axis)), std::string_view(&axis, 1));
  }
};

const ig::Register<ReturnFromReference> return_from_reference_syntax;

}  // namespace
}  // namespace iso
