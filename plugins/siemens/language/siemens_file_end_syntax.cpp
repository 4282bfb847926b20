/// A main program whose file ends without M2, M17 or M30: the run ends there, with a diagnostic.

#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

struct SiemensFileEnd {
  static constexpr auto spec =
      ig::syntax("SiemensFileEndSyntax", "Reports a program that ends without M30, M2, M17 or RET.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "SIE-0293",
                     "the program ends here without M30, M2, M17 or RET: end its last block with one of them"),
  };

  ig::Signal text_ended_{"Source.~End", ig::read | ig::wake};

  ig::Status build(ig::Block& b) {
    if (b.is_raised(text_ended_)) b.report(ig::diag("SIE-0293"), ig::Where::block());
    return ig::Status::unchanged;
  }
};

const ig::Register<SiemensFileEnd> siemens_file_end_syntax;

}  // namespace
}  // namespace siemens
