/// G91: distances become positions, in place, so that no later syntax has to know of G91. The words of canned cycles
/// are left alone: their R and Z start from other points, and CannedCycleResolveSyntax has resolved them.
#include <isogloss/cnc/program_xyz.hpp>

#include "motion/words_of_axes.hpp"
#include "tool/untravelled_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct IncrementalResolve {
  static constexpr auto spec = ig::syntax("IncrementalResolveSyntax", "Turns G91 distances into positions.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax", "CannedCycleResolveSyntax")
                                   .before("ProgramXyzSyntax", "ReferenceReturnSyntax", "ReferenceCheckSyntax");

  ig::InWhile<ig::Symbol> mode_{"PositioningMode.Term", "G91", ig::wake};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Fields words_{
      "words",
      "Parsing.X Parsing.Y Parsing.Z Parsing.A Parsing.B Parsing.C Parsing.G27.X Parsing.G27.Y Parsing.G27.Z "
      "Parsing.G27.A Parsing.G27.B Parsing.G27.C Parsing.G28.X Parsing.G28.Y Parsing.G28.Z Parsing.G28.A "
      "Parsing.G28.B Parsing.G28.C Parsing.G30.X Parsing.G30.Y Parsing.G30.Z Parsing.G30.A Parsing.G30.B Parsing.G30.C",
      ig::read | ig::write, "Axis words that are distances under G91. The last letter is the axis."};
  std::array<ig::Previous<double>, 3> angles_{ig::Previous<double>{"MachineCoordinate.A"},
                                              ig::Previous<double>{"MachineCoordinate.B"},
                                              ig::Previous<double>{"MachineCoordinate.C"}};
  LastProgramXyz last_;
  ig::Field<double> untravelled_ = untravelled_length(ig::read | ig::write);
  std::array<ig::Word, 3> places_{ig::Word{"Parsing.X", ig::read | ig::write},
                                  ig::Word{"Parsing.Y", ig::read | ig::write},
                                  ig::Word{"Parsing.Z", ig::read | ig::write}};
  ig::Name g91_{"G91"};

  WordsOfAxes axis_words_{words_, "XYZABC"};

  ig::Status build(ig::Block& b) {
    if (!b.is(mode_, g91_) || b.find(machine_select_)) return ig::Status::unchanged;
    const bool travels = b.has(untravelled_) && b.has(places_[2]);
    std::optional<ig::Vec3> last;
    if (travels) last = last_(b) + travel(b);
    const bool any = axis_words_.rewrite(b, [&](std::size_t axis, double distance) {
      if (axis < 3 && !last) last = last_(b);
      return std::optional(distance + (axis < 3 ? (*last)[axis] : b.get_or(angles_[axis - 3], 0.0)));
    });
    if (travels) b.erase(untravelled_);
    return any || travels ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// The pending change of the tool length in the frame of the block. In a rotated frame it leads along other axes,
  /// too, which get a word where the block names none.
  ig::Vec3 travel(ig::Block& b) const {
    const auto from = b.to_program({}), to = b.to_program({0, 0, b.get_or(untravelled_, 0.0)});
    const ig::Vec3 way = from && to ? rounded(*to - *from) : ig::Vec3{0, 0, b.get_or(untravelled_, 0.0)};
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (way[axis] != 0 && !b.has(places_[axis])) b.set(places_[axis], 0.0);
    return way;
  }
};

const ig::Register<IncrementalResolve> incremental_resolve_syntax;

}  // namespace
}  // namespace iso
