// Acme's vacuum table: M171 switches it on, M172 off.
#include <isogloss/sdk.hpp>
#include <stdexcept>

namespace {

struct AcmeVacuum {
  static constexpr auto spec =
      ig::syntax("AcmeVacuumSyntax", "M171/M172 vacuum table on and off.").before("LinearMotionSyntax");

  ig::Codes codes{"M171", "M172"};
  ig::TextOption pump{"pump", "north", "The pump of the table: north or south."};
  ig::Name name{pump.text()};
  ig::Out<bool> is_on{"AcmeVacuum.IsOn", {ig::Life::modal, "", "The part is held."}};
  ig::Out<ig::Symbol> at_work{"AcmeVacuum.Pump", {ig::Life::modal, "", "The pump at work."}};

  AcmeVacuum() {
    // The prototype, of which the descriptor is made, has no options yet.
    if (ig::detail::binding != nullptr && pump.text() != "north" && pump.text() != "south")
      throw std::invalid_argument("the machine has the pumps north and south");
  }

  ig::Status build(ig::Block& block) const {
    std::uint32_t found = 0;
    const auto code = block.take(codes, &found);
    if (!code) return ig::Status::unchanged;
    if (found > 1) block.report(0, ig::Where::block());
    block.set(is_on, *code == 0);
    block.set(at_work, name);
    return ig::Status::changed;
  }
};

const ig::Register<AcmeVacuum> registered;

}  // namespace
