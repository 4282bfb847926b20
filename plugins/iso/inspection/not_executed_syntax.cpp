/// Functions that are known by name but not executed. Each code is taken with its words, so that they are not executed
/// as a move or as a spindle speed, and a diagnostic says what is unreliable from here on. Where an earlier syntax of
/// the chain executes the code, this one reports nothing.
#include <string>
#include <vector>

#include <isogloss/cnc/leftovers.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct NotExecuted {
  static constexpr auto spec =
      ig::syntax("NotExecutedSyntax", "Functions that are recognised but not executed: one error each.")
          .after("ParameterizedFlagSyntax", "ProgrammableMirrorSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0265", "{0} is not executed: the previous tool length stays in force"),
      ig::diagnostic(IG_ERROR, "ISO-0267", "{0} is not executed: the tool does not move"),
      ig::diagnostic(IG_ERROR, "ISO-0268",
                     "{0} is not executed: the macro is not called, and its words have no effect"),
      ig::diagnostic(IG_ERROR, "ISO-0269", "{0} is not executed: the subprogram is not called"),
      ig::diagnostic(IG_ERROR, "ISO-0270", "{0} is not executed: X, Y and C are not transformed"),
      ig::diagnostic(IG_ERROR, "ISO-0272", "{0} is not executed: moves into the forbidden zone are not reported"),
  };

  /// A macro call owns every address, even those that no other syntax reads.
  struct AnyAddress {
    static constexpr std::string_view letters = "ABCDEFHIJKLPQRSTUVWXYZ";
    AnyAddress() {
      std::string path = "Parsing.?";
      for (const char letter : letters) {
        path.back() = letter;
        const ig::Word word(path, ig::read);
      }
    }
  };
  AnyAddress any_address_;

  struct Feature {
    ig::Call codes;
    ig::DiagnosticCode diagnostic;
  };
  std::vector<Feature> features_{
      {ig::Call{{"G43.1"}, "H[]"}, ig::diag("ISO-0265")},
      {ig::Call{{"G30.1", "G37"}, "X Y Z A B C H[] P[]"}, ig::diag("ISO-0267")},
      {ig::Call{{"G45", "G46", "G47", "G48"}, "X Y Z D[]"}, ig::diag("ISO-0267")},
      {ig::Call{{"G65", "G66", "G66.1"}, "A B C D E F H I J K L P Q R S T U V W X Y Z"}, ig::diag("ISO-0268")},
      {ig::Call{{"M97", "M98", "M198"}, "P[] L[] Q[] H[]"}, ig::diag("ISO-0269")},
      {ig::Call{{"G12.1"}, ""}, ig::diag("ISO-0270")},
      {ig::Call{{"G07.1"}, "A[mm] B[mm] C[mm]"}, ig::diag("ISO-0270")},
      {ig::Call{{"G22"}, "X Y Z I J K"}, ig::diag("ISO-0272")},
  };
  // Rotary words of these codes are not positions.
  ig::Call coordinates_{{"G50.1", "G51.1"}, "A B C"};

  ig::Status build(ig::Block& b) {
    bool any = false;
    for (const Feature& feature : features_)
      while (take(b, feature)) any = true;
    any |= take_rotary_coordinates(b);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool take_rotary_coordinates(ig::Block& b) const {
    bool any = false;
    for (std::uint32_t row = 0; row < coordinates_.code_count(); ++row)
      for (const char axis : coordinates_.letters()) {
        const ig_field word = coordinates_.word(row, axis);
        ig_value unused;
        if (!b.take(word, unused)) continue;
        b.report(ig::diag("ISO-0266"), ig::Where::word(word), b.text(coordinates_.name(row)));
        any = true;
      }
    return any;
  }

  static bool take(ig::Block& b, const Feature& feature) {
    for (std::uint32_t row = 0; row < feature.codes.code_count(); ++row) {
      const ig_field code = feature.codes.code(row);
      if (!is_unanswered(b, code)) continue;
      ig_value unused[32];
      b.take_code(&code, 1);
      b.take_many(feature.codes.row(row), static_cast<std::uint32_t>(feature.codes.letters().size()), unused);
      b.report(feature.diagnostic, ig::Where::word(code), b.text(feature.codes.name(row)));
      return true;
    }
    return false;
  }
};

const ig::Register<NotExecuted> not_executed_syntax;

}  // namespace
}  // namespace iso
