// Acme's vacuum table: M171 switches it on, M172 off.
#include <isogloss/sdk.hpp>

namespace {

struct AcmeVacuum {
  static constexpr auto spec = ig::syntax("AcmeVacuumSyntax", "M171/M172 vacuum table on and off");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ACME-0001", "M171 and M172 stand in one block; the last one counts."),
  };

  ig::Codes codes{"M171", "M172"};
  ig::Out<bool> is_on{"AcmeVacuum.IsOn", {ig::Life::modal, "", "The part is held."}};

  ig::Status build(ig::Block& block) const {
    std::uint32_t found = 0;
    const auto code = block.take(codes, &found);
    if (!code) return ig::Status::unchanged;
    if (found > 1) block.report(ig::diag("ACME-0001"), ig::Where::block());
    block.set(is_on, *code == 0);
    return ig::Status::changed;
  }
};

const ig::Register<AcmeVacuum> acme_vacuum_syntax;

}  // namespace
