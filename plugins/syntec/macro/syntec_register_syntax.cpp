/// G10 L1000 P100 R5 in files in MACRO format: register R100 of the PLC becomes 5, and macros read it so. R counts no
/// lengths, so the words are taken before those are converted.
#include <cmath>

#include "macro/macro_requests.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecRegister {
  static constexpr auto spec =
      ig::syntax("SyntecRegisterSyntax", "G10 L1000 writes a register of the PLC, which macros read.")
          .after("SyntecMacroWordSyntax", "FlagSyntax", "WordSyntax")
          .before("ParameterizedFlagSyntax", "DecimalPointSyntax", "ProgrammableDataInputSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0064",
                     "G10 L1000 is not executed: P is a register from 0 to 65535, and R its value"),
  };

  static constexpr double l_of_registers = 1000;

  ig::Call input_{{"G10"}, "", ig::read | ig::write | ig::wake};
  ig::In<double> l_{"Parsing.L"}, p_{"Parsing.P"}, r_{"Parsing.R"};
  BlockArguments arguments_;
  MacroEnvironment environment_;

  ig::Status build(ig::Block& b) const {
    if (!arguments_.is_macro(b) || !b.find(input_) || b.get_or(l_, 0.0) != l_of_registers || !b.is_fresh(l_))
      return ig::Status::unchanged;
    const auto where = ig::Where::word(input_.code(0));
    const double p = b.is_fresh(p_) ? b.get_or(p_, -1.0) : -1, r = b.get_or(r_, 0.0);
    const bool has_value = b.is_fresh(r_);
    b.erase(input_.code(0));
    arguments_.take(b, "LPR");
    if (!has_value || !(p >= 0 && p <= last_register) || p != std::floor(p)) {
      b.report(ig::diag("SYN-0064"), where);
      return ig::Status::changed;
    }
    environment_.enter(b);
    environment_.write(b, {MacroStore::Area::reg, static_cast<std::uint32_t>(p)}, MacroValue::real(r), where);
    return ig::Status::changed;
  }
};

const ig::Register<SyntecRegister> syntec_register_syntax;

}  // namespace
}  // namespace syntec
