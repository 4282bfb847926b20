/// G91: distances become positions, in place, so that nothing after this syntax knows of G91. The words of canned
/// cycles are not touched: their R and Z count from other points, and CannedCycleResolveSyntax has resolved them.
#include "program_xyz_util.hpp"

namespace iso {
namespace {

struct IncrementalResolve {
  static constexpr auto spec = ig::syntax("IncrementalResolveSyntax", "G91 distances become positions.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax", "CannedCycleResolveSyntax")
                                   .before("ProgramXyzSyntax", "ReferenceReturnSyntax", "ReferenceCheckSyntax");

  ig::InWhile<ig::Symbol> mode_{"PositioningMode.Term", "G91", ig::wake};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Fields words_{
      "words",
      "Parsing.X Parsing.Y Parsing.Z Parsing.G27.X Parsing.G27.Y Parsing.G27.Z Parsing.G28.X Parsing.G28.Y "
      "Parsing.G28.Z Parsing.G30.X Parsing.G30.Y Parsing.G30.Z",
      ig::read | ig::write, "Axis words that G91 makes distances. Their last letter is the axis."};
  LastProgramXyz last_;
  ig::Name g91_{"G91"};

  std::vector<std::size_t> axes_ = axes_of(words_);  // of each word; 3: no linear axis

  ig::Status build(ig::Block& b) {
    if (!b.is(mode_, g91_) || b.find(machine_select_)) return ig::Status::unchanged;
    ig::Status status = ig::Status::unchanged;
    ig::Vec3 last;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      ig_value v;
      if (axes_[i] > 2 || b.host()->get(b.raw(), words_.id(i), &v) == 0) continue;
      if (status == ig::Status::unchanged) last = last_(b);
      v.number += last[axes_[i]];
      b.host()->rewrite(b.raw(), words_.id(i), v);
      status = ig::Status::changed;
    }
    return status;
  }

 private:
  static std::vector<std::size_t> axes_of(const ig::Fields& words) {
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < words.size(); ++i)
      axes.push_back(std::min<std::size_t>(3, std::string_view("XYZ").find(words.path(i).back())));
    return axes;
  }
};

const ig::Register<IncrementalResolve> registered;

}  // namespace
}  // namespace iso
