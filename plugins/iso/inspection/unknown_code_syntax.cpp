/// A G code that the dialect does not know may be a macro, a cycle or a tilted plane, so the axis words of its block
/// are not executed as positions.
#include <isogloss/cnc/leftovers.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct UnknownCode {
  static constexpr auto spec = ig::syntax("UnknownCodeSyntax", "Makes the words of an unknown G code move nothing.")
                                   .after("ParameterizedFlagSyntax", "FlagSyntax")
                                   .before("UnitModeSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "ISO-0542",
          "{0} is not supported here, so the words {1} of its block move nothing: check the code or the dialect"),
  };

  ig::Signal unknown_{"Source.~UnknownCode", ig::read | ig::wake};
  ig::Signal said_{"Source.~UnknownCodeSaid", ig::write};
  ig::Codes motions_{{"G00", "G01", "G02", "G03"}, ig::read};
  // Taken, but they do not wake the syntax.
  static constexpr std::string_view letters = "XYZABCUVWIJKRQPLE";
  std::array<ig::Word, letters.size()> words_{
      ig::Word{"Parsing.X", ig::read}, ig::Word{"Parsing.Y", ig::read}, ig::Word{"Parsing.Z", ig::read},
      ig::Word{"Parsing.A", ig::read}, ig::Word{"Parsing.B", ig::read}, ig::Word{"Parsing.C", ig::read},
      ig::Word{"Parsing.U", ig::read}, ig::Word{"Parsing.V", ig::read}, ig::Word{"Parsing.W", ig::read},
      ig::Word{"Parsing.I", ig::read}, ig::Word{"Parsing.J", ig::read}, ig::Word{"Parsing.K", ig::read},
      ig::Word{"Parsing.R", ig::read}, ig::Word{"Parsing.Q", ig::read}, ig::Word{"Parsing.P", ig::read},
      ig::Word{"Parsing.L", ig::read}, ig::Word{"Parsing.E", ig::read}};

  ig::Status build(ig::Block& b) const {
    if (!b.is_raised(unknown_) || b.find(motions_)) return ig::Status::unchanged;
    std::string taken;
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (b.take(words_[i])) taken.append(taken.empty() ? "" : " ").append(1, letters[i]);
    if (taken.empty()) return ig::Status::unchanged;
    for (std::uint32_t i = 0; const auto left = leftover(b, i); ++i) {
      if (left->kind != IG_LEFT_UNKNOWN || !left->name.starts_with('G')) continue;
      b.raise(said_);
      b.report(ig::diag("ISO-0542"), ig::Where::columns(left->begin, left->end), std::string_view(left->name),
               std::string_view(taken));
      break;
    }
    return ig::Status::changed;
  }
};

const ig::Register<UnknownCode> unknown_code_syntax;

}  // namespace
}  // namespace iso
