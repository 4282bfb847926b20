/// Codes that change nothing in a resolved program, because they cancel functions that are not executed here. A dialect
/// that executes such a function takes its codes off the list.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct InertCode {
  static constexpr auto spec = ig::syntax("InertCodeSyntax", "Codes that are ignored.")
                                   .after("ParameterizedFlagSyntax", "RadiusCompensationSyntax");

  ig::Fields codes_{"codes",
                    "Parsing.Flags.G13.1 Parsing.Flags.G23 Parsing.Flags.G40 Parsing.Flags.G40.1 Parsing.Flags.G67 "
                    "Parsing.Flags.G91.1",
                    ig::take | ig::wake, "Codes without words that are ignored without a report.", IG_CODE};

  ig::Fields with_words_{
      "with-words", "", ig::take | ig::wake,
      "Codes that are ignored without a report, with every word that nothing else in the block uses.", IG_CODE};
  ig::Fields words_{"words", "Parsing.?", ig::take, "The words that go with them."};

  enum class Tuning { unknown, taken };
  ig::Call tuning_codes_{{"G103", "G187"}, "P[] E[]"};
  ig::Choice<Tuning> tuning_{
      "tuning", "unknown|G103-G187", "unknown",
      "Whether the control has G103 P (limit of the look-ahead) and G187 P E (smoothness); they change no position."};

  ig::Status build(ig::Block& b) {
    const bool any = tuning_ == Tuning::taken && b.take(tuning_codes_).has_value();
    std::uint32_t found = 0;
    b.take_code(codes_.ids(), static_cast<std::uint32_t>(codes_.size()), &found);
    std::uint32_t with_words = 0;
    if (with_words_.size() > 0)
      b.take_code(with_words_.ids(), static_cast<std::uint32_t>(with_words_.size()), &with_words);
    for (std::size_t i = 0; with_words > 0 && i < words_.size(); ++i) {
      ig_value unused;
      b.take(words_.id(i), unused);
    }
    return any || found + with_words > 0 ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<InertCode> inert_code_syntax;

}  // namespace
}  // namespace iso
