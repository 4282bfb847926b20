/// CHF=, CHR= and RND= behind a move, and RNDM= behind each: the chamfer or rounding at the corner to the next move,
/// its kind and size, as a state that CornerBreakPathSyntax and the radius compensation make the path from.
#include <cmath>

#include "plane_util.hpp"
#include "siemens_diagnostics.hpp"

namespace siemens {
namespace {

struct SiemensCorner {
  static constexpr auto spec =
      ig::syntax("SiemensCornerSyntax", "CHF=, CHR=, RND= and RNDM=: chamfers and roundings of corners.")
          .after("SiemensUnitSyntax", "SiemensTurnSyntax", "CircularMotionSyntax", "LinearMotionSyntax")
          .before("CornerBreakPathSyntax", "RadiusCompensationPathSyntax", "UnconsumedCheckSyntax");

  struct Corner {
    ig::Word word;
    ig::Name name;
  };
  std::array<Corner, 3> corners_{
      Corner{ig::Word{"Parsing.CHF", ig::wake, "mm", "Length of the chamfer."}, ig::Name{"CHF="}},
      Corner{ig::Word{"Parsing.CHR", ig::wake, "mm", "From the corner to both ends of the chamfer."}, ig::Name{"CHR="}},
      Corner{ig::Word{"Parsing.RND", ig::wake, "mm", "Radius of the arc."}, ig::Name{"RND="}}};
  ig::Word modal_word_{"Parsing.RNDM", ig::wake, "mm", "Radius of the arcs at all corners; 0 ends it."};
  ig::Field<double> modal_{"CornerBreak.ModalRadius_mm",
                           ig::read | ig::write | ig::wake_while,
                           {ig::Life::modal, "mm", "RNDM=, as long as it is in force."}};
  ig::Out<ig::Symbol> term_{"CornerBreak.Term", {ig::Life::block, "", "What stands at the end of the move."}};
  ig::Out<double> size_{"CornerBreak.Size_mm", {ig::Life::block, "mm", "Length, legs or radius."}};
  ig::Signal open_{"CornerBreak.~Open", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal path_{"CornerBreak.~Path", ig::write};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"}, compound_{"CompoundMotion.Term"};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::Name rndm_{"RNDM="};

  ig::Status build(ig::Block& b) const {
    if (const auto radius = b.take(modal_word_)) set_modal(b, *radius);
    const bool was_open = b.is_raised(open_);
    const bool opens = describe(b);
    if (was_open || opens) b.raise(path_);
    if (opens && !was_open) b.raise(open_);
    if (was_open && !opens && b.has_any(form_, compound_)) b.erase(open_);
    return ig::Status::changed;
  }

 private:
  void set_modal(ig::Block& b, double radius) const {
    if (radius < 0)
      b.report(diag("SIE-0286"), ig::Where::word(modal_word_.id()), b.text(rndm_), radius);
    else if (radius > 0)
      b.set(modal_, radius);
    else if (b.has(modal_))
      b.erase(modal_);
  }

  bool describe(ig::Block& b) const {
    const Corner* found = nullptr;
    double size = 0;
    for (const Corner& corner : corners_) {
      const auto word = b.take(corner.word);
      if (!word) continue;
      if (found != nullptr) b.report(diag("SIE-0287"), ig::Where::word(corner.word.id()), b.text(corner.name));
      if (*word < 0) b.report(diag("SIE-0286"), ig::Where::word(corner.word.id()), b.text(corner.name), *word);
      if (found != nullptr) continue;
      found = &corner;
      size = *word;
    }
    ig::Symbol name{};
    if (found != nullptr) {
      name = found->name;
    } else if (b.has(form_) && !b.get_or(is_rapid_, false)) {
      name = rndm_;
      size = b.get_or(modal_, 0.0);
    }
    if (!(size > 0)) return false;
    b.set(term_, name);
    b.set(size_, size);
    return true;
  }
};

const ig::Register<SiemensCorner> registered;

}  // namespace
}  // namespace siemens
