/// Functions of a Syntec that are recognised but not executed: each is one error that says what is missing, and its
/// words go with it. F and S of such a block are those in force all the same.
#include "leftovers.hpp"
#include "syntec_diagnostics.hpp"

namespace syntec {
namespace {

struct SyntecCode {
  static constexpr auto spec = ig::syntax("SyntecCodeSyntax", "Says the functions of a Syntec that are not executed.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("CannedCycleResolveSyntax", "NotExecutedSyntax", "UnconsumedCheckSyntax");

  /// Their words have no unit, since nobody reads them: a decimal point that is missing there is no news.
  struct Feature {
    ig::Call codes;
    std::string_view missing;
  };
  std::vector<Feature> features_{
      {ig::Call{{"G134", "G135", "G136", "G137", "G137.1"}, "X[] Y[] Z[] I[] J[] K[] R[] P[] Q[] L[] H[]"},
       "the holes of the pattern are missing"},
      {ig::Call{{"G02.4", "G03.4"}, "X[] Y[] Z[] A[] B[] C[] I[] J[] K[] U[] V[] W[]"},
       "the arc through three points is missing"},
      {ig::Call{{"G06.2"}, "X[] Y[] Z[] K[] P[] R[]"}, "the curve is missing"},
      {ig::Call{{"G04.1"}, "X[] P[] Q[] R[]"}, "the program does not wait for the other one"},
      {ig::Call{{"M96", "M97"}, "P[] H[] Q[]"}, "no signal interrupts the program here"},
  };

  ig::Status build(ig::Block& b) const {
    bool any = false;
    for (const Feature& feature : features_)
      for (std::uint32_t row = 0; row < feature.codes.code_count(); ++row) any |= take(b, feature, row);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static bool take(ig::Block& b, const Feature& feature, std::uint32_t row) {
    const ig_field code = feature.codes.code(row);
    if (!iso::is_unanswered(b, code)) return false;
    std::uint32_t found = 0;
    ig_value unused[32];
    b.host()->take_code(b.raw(), &code, 1, &found);
    b.host()->take_many(b.raw(), feature.codes.row(row), static_cast<std::uint32_t>(feature.codes.letters().size()),
                        unused);
    b.report(diag("SYN-0003"), ig::Where::word(code), b.text(feature.codes.name(row)), feature.missing);
    return true;
  }
};

const ig::Register<SyntecCode> registered;

}  // namespace
}  // namespace syntec
