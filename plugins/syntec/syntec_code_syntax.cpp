/// Functions of a Syntec that are recognised but not executed: each is one error that says what is missing, and its
/// words are taken with it. F and S of such a block come into force all the same.
#include <isogloss/cnc/recognised_codes.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecCode {
  static constexpr auto spec =
      ig::syntax("SyntecCodeSyntax", "Reports the functions of a Syntec that are not executed.")
          .after("ParameterizedFlagSyntax", "SubprogramCallSyntax")
          .before("CannedCycleResolveSyntax", "NotExecutedSyntax", "UnconsumedCheckSyntax");

  RecognisedCodes codes_{
      ig::diag("SYN-0003"),
      {{ig::Call{{"G134", "G135", "G136", "G137", "G137.1"}, "X[] Y[] Z[] I[] J[] K[] R[] P[] Q[] L[] H[]"},
        "the holes of the pattern are missing"},
       {ig::Call{{"G02.4", "G03.4"}, "X[] Y[] Z[] A[] B[] C[] I[] J[] K[] U[] V[] W[]"},
        "the arc through three points is missing"},
       {ig::Call{{"G06.2"}, "X[] Y[] Z[] K[] P[] R[]"}, "the curve is missing"},
       {ig::Call{{"G04.1"}, "X[] P[] Q[] R[]"}, "the program does not wait for the other one"},
       {ig::Call{{"M96", "M97"}, "P[] H[] Q[]"}, "no signal interrupts the program here"}}};

  ig::Status build(ig::Block& b) const { return codes_.report(b) ? ig::Status::changed : ig::Status::unchanged; }
};

const ig::Register<SyntecCode> syntec_code_syntax;

}  // namespace
}  // namespace syntec
