// E puts the force of a clamp in force.
#include <isogloss/sdk.hpp>
#include <stdexcept>

#include "acme_clamp.hpp"

namespace {

/// Thrown and caught within one build, so that the plugin's own unwinder is at work beside the host's.
struct NoClamp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct AcmeClamp {
  static constexpr auto spec =
      ig::syntax("AcmeClampSyntax", "E puts the force of a clamp in force.").before("LinearMotionSyntax");

  ig::Word clamp{"Parsing.E", ig::wake, ""};
  ig::Service<AcmeClampService> table{clamp_service, ig::Need::required, "The forces of the clamps."};
  ig::Out<double> force{"AcmeClamp.Force_kN", {ig::Life::modal, "kN", "The force of the clamp that E named last."}};

  double force_of(double number) const {
    double out = 0;
    if (table->force(table->self, number, &out) == 0) throw NoClamp("no such clamp");
    return out;
  }

  ig::Status build(ig::Block& block) const {
    const auto number = block.take(clamp);
    if (!number) return ig::Status::unchanged;
    try {
      block.set(force, force_of(*number));
    } catch (const NoClamp&) {
      block.report(1, ig::Where::word(clamp.id()), *number);
    }
    return ig::Status::changed;
  }
};

const ig::Register<AcmeClamp> registered;

}  // namespace
