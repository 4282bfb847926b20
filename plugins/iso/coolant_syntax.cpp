/// M07/M08/M09: mist, flood, off.
#include "modal_group.hpp"

namespace iso {
namespace {

struct Coolant {
  static constexpr auto spec = ig::syntax("CoolantSyntax", "M07/M08/M09 coolant.");

  ig::Codes codes_{"M07", "M08", "M09"};
  ig::Out<ig::Symbol> mode_{"Coolant.Mode"};
  ig::Name mist_{"MIST"}, flood_{"FLOOD"}, off_{"OFF"};

  ig::Status build(ig::Block& b) {
    const auto code = take_modal(b, codes_);
    if (!code) return ig::Status::unchanged;
    b.set(mode_, *code == 0 ? mist_ : *code == 1 ? flood_ : off_);
    return ig::Status::changed;
  }
};

const ig::Register<Coolant> registered;

}  // namespace
}  // namespace iso
