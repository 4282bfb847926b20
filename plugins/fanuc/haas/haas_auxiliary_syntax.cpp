/// The M codes by which a Haas switches brakes, relays, conveyors, doors and similar devices. They move no axis.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct HaasAuxiliary {
  static constexpr auto spec = ig::syntax("HaasAuxiliarySyntax",
                                          "M codes of a Haas that switch something and move "
                                          "nothing.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("NotExecutedSyntax", "UnconsumedCheckSyntax");

  ig::Codes switches_{"M10", "M11", "M12", "M13",  "M21",  "M22",  "M23",  "M24",  "M25", "M31", "M33", "M34",
                      "M35", "M36", "M39", "M41",  "M42",  "M51",  "M52",  "M53",  "M54", "M55", "M61", "M62",
                      "M63", "M64", "M65", "M73",  "M74",  "M75",  "M78",  "M79",  "M80", "M81", "M82", "M83",
                      "M84", "M86", "M95", "M104", "M105", "M130", "M131", "M138", "M139"};
  ig::Call relays_{{"M29", "M59", "M69", "M70", "M71"}, "P[]"};

  ig::Status build(ig::Block& b) {
    const bool switches = b.take(switches_).has_value();
    const bool relay = b.take(relays_).has_value();
    return switches || relay ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<HaasAuxiliary> haas_auxiliary_syntax;

}  // namespace
}  // namespace fanuc
