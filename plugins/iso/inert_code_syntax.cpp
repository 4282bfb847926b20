/// Codes that change nothing in a resolved program: the cancelling code of functions that are not executed here, and
/// the ways in which the control slows down at corners. A dialect that executes such a function takes them off its
/// list.
#include <array>

#include "diagnostics.hpp"

namespace iso {
namespace {

struct InertCode {
  static constexpr auto spec =
      ig::syntax("InertCodeSyntax", "Codes that change nothing here.").after("ParameterizedFlagSyntax");

  ig::Fields codes_{"codes",
                    "Parsing.Flags.G09 Parsing.Flags.G11 Parsing.Flags.G13.1 Parsing.Flags.G15 Parsing.Flags.G23 "
                    "Parsing.Flags.G40 Parsing.Flags.G40.1 Parsing.Flags.G50 Parsing.Flags.G61 Parsing.Flags.G61.1 "
                    "Parsing.Flags.G62 Parsing.Flags.G63 Parsing.Flags.G67 Parsing.Flags.G69 Parsing.Flags.G97",
                    ig::take | ig::wake, "Codes without words that are taken silently.", IG_CODE};
  // Their words belong to them: X of G50.1 is no move, P of G64 no dwell.
  std::array<ig::Call, 5> calls_{ig::Call{{"G05"}, "P[]"}, ig::Call{{"G05.1"}, "P[] Q[] R"}, ig::Call{{"G08"}, "P[]"},
                                 ig::Call{{"G50.1"}, "X Y Z"}, ig::Call{{"G64"}, "P[mm] Q"}};

  ig::Status build(ig::Block& b) {
    std::uint32_t found = 0;
    b.host()->take_code(b.raw(), codes_.ids(), static_cast<std::uint32_t>(codes_.size()), &found);
    bool any = found > 0;
    for (const ig::Call& call : calls_) any |= b.take(call).has_value();
    return any ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<InertCode> registered;

}  // namespace
}  // namespace iso
