/// M07/M08/M09: mist, flood, off.
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class InOneBlock { last, both };

struct Coolant {
  static constexpr auto spec = ig::syntax("CoolantSyntax", "M07/M08/M09 coolant.");

  ig::Codes codes_{"M07", "M08", "M09"};
  ig::Out<ig::Symbol> mode_{"Coolant.Mode"};
  ig::Codes mist_code_{{"M07"}, ig::read}, flood_code_{{"M08"}, ig::read}, off_code_{{"M09"}, ig::read};
  ig::Choice<InOneBlock> in_one_block_{"in-one-block", "last|both", "last", "What M07 and M08 in one block mean."};
  ig::Name mist_{"MIST"}, flood_{"FLOOD"}, off_{"OFF"}, together_{"FLOOD+MIST"};

  ig::Status build(ig::Block& b) {
    if (in_one_block_ == InOneBlock::both && b.find(mist_code_) && b.find(flood_code_) && !b.find(off_code_)) {
      b.take(codes_);
      b.set(mode_, together_);
      return ig::Status::changed;
    }
    const auto code = take_modal(b, codes_);
    if (!code) return ig::Status::unchanged;
    b.set(mode_, *code == 0 ? mist_ : *code == 1 ? flood_ : off_);
    return ig::Status::changed;
  }
};

const ig::Register<Coolant> coolant_syntax;

}  // namespace
}  // namespace iso
