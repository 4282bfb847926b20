/// Calls: NAME(1,2), NAME P3, L100, CALL "NAME", EXTCALL("NAME"), and the cycles, whose parameters become words. What
/// the control knows by name but this run does not execute is one diagnostic for each call.
#include "flow/call_reader.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCall {
  static constexpr auto spec = ig::syntax("SiemensCallSyntax", "Calls of subprograms and cycles.")
                                   .after("SiemensWordSyntax", "SiemensFlowSyntax", "SiemensDeclarationSyntax")
                                   .before("UnitModeSyntax", "ProgramEndSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0168",
                     "the synchronized action '{0}' is not executed: the machine runs it in parallel with the program"),
      ig::diagnostic(
          IG_WARNING, "SIE-0374",
          "the synchronized action '{0}' is not executed: it switches outputs only, so positions stay right"),
      ig::diagnostic(IG_ERROR, "SIE-0169",
                     "'{0}' does not belong in a call, so nothing is called: write the call as NAME(1,,R5)"),
      ig::diagnostic(IG_ERROR, "SIE-0170", "the program stops the control with its own alarm {0}"),
      ig::diagnostic(IG_ERROR, "SIE-0171", "'{0}' is not executed: this form of CALL is not supported"),
      ig::diagnostic(IG_ERROR, "SIE-0172",
                     "{0} is not called with P={1}: the number of calls is whole, from 0 to 9999"),
      ig::diagnostic(IG_WARNING, "SIE-0394",
                     "{0} is not called, because P is 0: the number of calls is from 1 to 9999"),
      ig::diagnostic(IG_ERROR, "SIE-0173",
                     "{0} is not a known statement, so '{1}' after it is not executed: check the spelling"),
      ig::diagnostic(IG_ERROR, "SIE-0174", "{0} is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "SIE-0181", "{0} is not executed: its moves are missing from the path"),
      ig::diagnostic(IG_ERROR, "SIE-0182",
                     "{0} is not executed, because a parameter has no value: see the diagnostic before this one"),
      ig::diagnostic(IG_WARNING, "SIE-0311", "P={0} is ignored: MCALL calls {1} once after each block that moves"),
      ig::diagnostic(IG_ERROR, "SIE-0370",
                     "the folder '{0}' is not added to the search path: CALLPATH has already added {1}"),
      ig::diagnostic(IG_WARNING, "SIE-0184",
                     "{0} has {1} parameters, but only the first {2} are used: check the commas of the call"),
  };

  CallReader calls_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) { return calls_.scan(b, text, position); }
  ig::Status build(ig::Block& b) { return calls_.build(b); }
};

const ig::Register<SiemensCall> siemens_call_syntax;

}  // namespace
}  // namespace siemens
