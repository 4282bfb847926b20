/// G29: from a reference position back to work, over the intermediate point of the last G28 or G30, by rapid and with
/// the named axes only. Under G91 the words count from the intermediate point. Stands before ReferenceReturnSyntax,
/// which takes the words of G28 and G30. Fanuc manual, "Reference position".
#include "reference_position.hpp"

namespace iso {
namespace {

struct ReturnFromReference {
  static constexpr auto spec = ig::syntax("ReturnFromReferenceSyntax", "G29 returns over the intermediate point.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax", "McXyzSyntax",
                                          "LinearMotionSyntax", "IncrementalResolveSyntax")
                                   .before("ReferenceReturnSyntax");

  ig::Call passed_{{"G28", "G30"}, "X Y Z", ig::read | ig::wake};
  ig::Call g29_{{"G29"}, "X Y Z"};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::write};
  ig::Xyz intermediate_{"ReferenceReturn.Intermediate", ig::read | ig::write};
  ig::CompoundMotion motion_;
  DistanceMode distance_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    const bool stored = keep_intermediate(b);
    const auto words = b.take(g29_);
    if (!words) return stored ? ig::Status::changed : ig::Status::unchanged;
    go(b, *words);
    return ig::Status::changed;
  }

 private:
  bool keep_intermediate(ig::Block& b) const {
    const auto row = b.find(passed_);
    if (!row) return false;
    ig_value values[3];
    const std::uint32_t named = b.host()->get_many(b.raw(), passed_.row(*row), 3, values);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named >> axis & 1u) != 0) b.host()->set(b.raw(), intermediate_.id(axis), values[axis]);
    return named != 0;
  }

  void go(ig::Block& b, const ig::Words& words) const {
    const ig::PartialVec3 named = axis_words(words);
    if (named.mask == 0) {
      b.report(diag("ISO-0340"), ig::Where::word(g29_.code(0)), b.text(words.code));
      return;
    }
    const ig::PartialVec3 stored = b.get(intermediate_);
    ig::Vec3 over = last_(b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!named.has(axis)) continue;
      if (stored.has(axis))
        over[axis] = stored.value[axis];
      else
        b.report(diag("ISO-0381"), ig::Where::word(g29_.word(0, "XYZ"[axis])), std::string_view(&"XYZ"[axis], 1));
    }
    ig::Vec3 end = over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis)) end[axis] = distance_.is_incremental(b) ? over[axis] + named.value[axis] : named.value[axis];
    const auto machine_over = b.to_machine(over), machine_end = b.to_machine(end);
    if (!machine_over || !machine_end) {
      not_invertible(b);
      return;
    }

    motion_.begin(b, words.code);
    motion_.rapid_to(b, over, *machine_over);
    motion_.rapid_to(b, end, *machine_end);
    b.set(program_, end);
    b.set(machine_, *machine_end);
  }
};

const ig::Register<ReturnFromReference> registered;

}  // namespace
}  // namespace iso
