/// Functions of a Haas mill that are recognised but not executed. F of such a block is the feed in force all the same.
#include "recognised_codes.hpp"

namespace fanuc {
namespace {

struct HaasCode {
  static constexpr auto spec = ig::syntax("HaasCodeSyntax", "Says the functions of a Haas that are not executed.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("NotExecutedSyntax", "UnconsumedCheckSyntax");

  RecognisedCodes codes_{{
      {ig::Call{{"G150"}, "X Y Z I J K L[] P[] Q R D[]"}, "the pocket is missing"},
      {ig::Call{{"G47"}, "X Y Z I J[deg] P[] R D[] E[mm/min]"}, "the engraving is missing"},
      {ig::Call{{"G35", "G36", "G136"}, "X Y Z A I J K D[]"}, "nothing is measured, and its move is left out"},
      {ig::Call{{"G107"}, "X Y Z A B C Q R"}, "the path is not wrapped around the cylinder"},
      {ig::Call{{"G143", "G234", "G254"}, "H[]"}, "positions do not follow the rotary axes"},
      {ig::Call{{"G174", "G184"}, "X Y Z R"}, "the cycle is missing, and blocks after it only move"},
  }};

  ig::Status build(ig::Block& b) { return codes_.say(b); }
};

const ig::Register<HaasCode> registered;

}  // namespace
}  // namespace fanuc
