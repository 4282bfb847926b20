/// M88 and M89 of a Haas: coolant through the spindle on and off.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct HaasCoolant {
  static constexpr auto spec =
      ig::syntax("HaasCoolantSyntax", "M88/M89 coolant through the spindle.").after("CoolantSyntax");

  ig::Codes codes_{"M88", "M89"};
  ig::Out<ig::Symbol> mode_{"Coolant.Mode"};
  ig::Name through_{"THROUGH"}, off_{"OFF"};

  ig::Status build(ig::Block& b) {
    const auto code = b.take(codes_);
    if (!code) return ig::Status::unchanged;
    b.set(mode_, *code == 0 ? through_ : off_);
    return ig::Status::changed;
  }
};

const ig::Register<HaasCoolant> haas_coolant_syntax;

}  // namespace
}  // namespace fanuc
