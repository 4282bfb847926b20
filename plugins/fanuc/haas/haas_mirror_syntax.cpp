/// G101 and G100 of a Haas: mirror image of an axis at the work zero, on and off. ProgrammableMirrorSyntax executes it.

#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct HaasMirror {
  static constexpr auto spec = ig::syntax("HaasMirrorSyntax", "G101/G100 mirror image on, off.")
                                   .after("ParameterizedFlagSyntax", "UnitModeSyntax")
                                   .before("ProgrammableMirrorSyntax", "HaasCodeSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0204", "{0} names no axis: nothing is mirrored"),
  };

  ig::Call on_{{"G101"}, "X Y Z A B C"};
  ig::Call off_{{"G100"}, "X Y Z A B C"};
  ig::Out<ig::Symbol> term_{"MirrorImage.Term"};
  ig::Xyz mirror_{"MirrorImage", ig::read | ig::write};

  ig::Status build(ig::Block& b) {
    const ig_field off = off_.code(0), on = on_.code(0);
    const auto ends = b.take(off_);
    const auto begins = b.take(on_);
    if (ends) end(b, off, *ends);
    if (begins) begin(b, on, *begins);
    return ends || begins ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// Ends the mirror image of the named axes; without words, of all axes.
  void end(ig::Block& b, ig_field code, const ig::Words& words) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (words.mask == 0 || words["XYZ"[axis]]) b.erase(mirror_.id(axis));
    if (b.get(mirror_).mask == 0) b.erase(term_);
    report_rotary(b, code, words);
  }

  void begin(ig::Block& b, ig_field code, const ig::Words& words) const {
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!words["XYZ"[axis]]) continue;
      b.set(mirror_.id(axis), 0);
      any = true;
    }
    if (any) b.set(term_, words.code);
    if (words.mask == 0) b.report(ig::diag("FAN-0204"), ig::Where::word(code), b.text(words.code));
    report_rotary(b, code, words);
  }

  void report_rotary(ig::Block& b, ig_field code, const ig::Words& words) const {
    if (words['A'] || words['B'] || words['C'])
      b.report(ig::diag("FAN-0201"), ig::Where::word(code), b.text(words.code), "rotary axes are not mirrored");
  }
};

const ig::Register<HaasMirror> haas_mirror_syntax;

}  // namespace
}  // namespace fanuc
