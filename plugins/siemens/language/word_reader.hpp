/// Reads words and assignments of the Siemens language, computes their values and hands the words to the host.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/cnc/machine_codes.hpp>

#include "language/siemens_expression.hpp"
#include "language/word_fields.hpp"
#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

/// A member of the syntax that reads words.
class WordReader {
 public:
  /// The words that follow each other from `position`: where the last of them ends, `position` where none begins there.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position);

 private:
  WordFields fields_;
  AxisModes modes_{ig::write};
  FurtherAxisWords further_axes_{ig::write, ig::write};
  AssignedFrame frame_{ig::write};
  ig::TextField tool_name_{"ToolName.Text", ig::write, {ig::Life::block, "", "T=\"…\" of this block."}};
  Environment environment_;
  /// An assignment: the control makes no block without a move of it.
  ig::Signal macro_statement_{"Parsing.~MacroStatement", ig::write};
  OtherMeaning other_meaning_{ig::read};
  MachineCodes machine_;
  MachineCodeRecord record_;
  ig::IntegerOption master_{"master-spindle", "1", {1, 31}, "The spindle of S and M3; S1= and M1= name one."};

  /// Words that follow each other, until one host call takes them.
  struct Run {
    std::array<ig_word, 32> words;
    std::uint32_t count = 0;
  };

  // ---- word_reader.cpp: which kind each word is, and words and codes that carry their number

  std::size_t item(ig::Block& b, std::string_view text, std::size_t begin, Run& run);
  /// X12.5, as most words are: a letter, its number, and a blank or the end of the block. `begin`: the word is of
  /// another kind.
  std::size_t plain_word(ig::Block& b, std::string_view text, std::size_t begin, Run& run) const;
  void word(ig::Block& b, Run& run, std::string_view name, ig_field field, std::size_t begin, std::size_t end,
            double value) const;
  std::size_t code(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number, Run& run);
  void set_code(ig::Block& b, Run& run, char letter, std::uint32_t n, std::size_t begin, std::size_t end) const;
  /// The same of a code that the table MachineCodes does not change.
  void set_known(ig::Block& b, Run& run, char letter, std::uint32_t n, std::size_t begin, std::size_t end) const;
  /// The words for which a name stands (DEFINE); a name for a call is SiemensCallSyntax's. What an address opens is
  /// closed behind the name: DEFINE LEFT AS X= and LEFT 10.
  std::size_t expand(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, const std::string& macro,
                     Run& run);
  /// EXECSTRING("R1="<<NR): the words that the text holds.
  std::size_t execute_string(ig::Block& b, std::string_view text, std::size_t begin, std::size_t open, Run& run);
  /// The number of an axis beside X Y Z A B C that programs call so.
  std::optional<std::uint32_t> further_axis(std::string_view name) const;
  void add(ig::Block& b, Run& run, ig_field field, std::size_t begin, std::size_t end, double value,
           std::string_view name) const;
  void give(ig::Block& b, Run& run) const;
  /// Between CTABDEF and CTABEND, where words are points of a curve: they move nothing and stay for no later block.
  bool defines_curve() const { return environment_.store().curve_begins != 0; }
  bool ends_program(ig::Block& b, const Run& run) const;
  ig::Where columns(std::size_t begin, std::size_t end) const { return environment_.columns(begin, end); }
  std::size_t refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                     std::size_t end) const;
  std::size_t empty_word(ig::Block& b, std::string_view text, std::size_t begin) const;
  std::size_t without_address(ig::Block& b, std::string_view text, std::size_t position) const;

  // ---- word_names.cpp: addresses that are names

  /// A name of two characters and more, or one with an index.
  std::size_t named(ig::Block& b, std::string_view text, std::size_t begin, Run& run);
  /// Macros do not nest. One may use the code whose name it has: DEFINE M7 AS M7 M8.
  bool names_other_macro(std::string_view text, std::size_t position, std::string_view macro) const;
  /// Where the name ends by which the machine calls an axis, as C1 of C1=45; `begin` where none stands there, or the
  /// program has a variable of this name.
  std::size_t machine_name_end(ig::Block& b, std::string_view text, std::size_t begin) const;
  /// X1=, where the program has defined X1.
  bool is_assigned_variable(ig::Block& b, std::string_view text, std::size_t begin) const;

  // ---- word_values.cpp: NAME=value

  /// What stands behind =, in AC( ) or without; no value where it is a fault.
  struct Assigned {
    std::optional<double> value;
    ig::Symbol mode;
    std::size_t end;
  };
  Assigned assigned(ig::Block& b, std::string_view text, std::size_t equals);
  /// X=…, CR=…, X1=…, M1=3, S2=500, T="DRILL": `equals` is behind the equals sign.
  std::size_t valued(ig::Block& b, std::string_view text, std::size_t begin, std::size_t name_end, std::size_t equals,
                     Run& run);
  std::size_t valued_as(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                        const std::string& name, Run& run);
  /// AC IC DC ACP ACN before a bracket; at_bracket_ is where the bracket opens.
  ig::Symbol take_mode(ig::Block& b, std::string_view text, std::size_t position);
  /// AC, IC and the like of the same word before, which the last one replaces.
  void erase_mode(ig::Block& b, std::string_view name) const;
  void set_mode(ig::Block& b, std::size_t word, ig::Symbol mode) const {
    if (!defines_curve()) modes_.set(b, word, mode);
  }
  /// G=, M=, M1=3, S1=500, H=: with a number the address of one spindle, or of an auxiliary function.
  std::size_t extended(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, const std::string& name,
                       double value, Run& run) const;
  /// "M1" of M[1], "S2" of S[2]: an address extension that is computed. Empty: something else.
  std::string extended_name(const std::string& indexed) const;
  /// Of the machine, or what SETMS has named.
  bool is_master_spindle(std::string_view number) const;
  /// SPOS[2]=90 and LIMS[2]=3000 behind the index: of the master spindle, or reported.
  std::size_t of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                         const std::string& indexed, Run& run);
  /// T1=5 and T2="DRILL": the number behind T is the spindle.
  std::size_t tool_of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at, Run& run,
                              const std::string& number) const;
  std::size_t tool(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at, Run& run,
                   const std::string& name) const;
  /// A value that could not be read: the rest of it, up to a blank outside brackets with no operator behind it, goes
  /// with it.
  static std::size_t line_end_of_fault(std::string_view text, std::size_t position);

  // ---- word_assignment.cpp: variables

  std::size_t assignment(ig::Block& b, std::string_view text, std::size_t begin, Run& run);
  void assign(ig::Block& b, const Expression::Reference& to, const Value& value, std::size_t begin,
              std::size_t end) const;
  /// A[1]=SET(1,2,3), A[0]=REP(5).
  std::size_t assign_elements(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                              const Expression::Reference& to, const Variable& array) const;
  struct Group;
  static const Group* group_named(std::string_view name);
  std::size_t of_group(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals, const Group& group,
                       Run& run);
  /// To AXIS and FRAME variables, and to F[X,TR]; nothing for other variables.
  std::optional<std::size_t> assign_declared(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                                             const Expression::Reference& to) const;

  std::size_t at_bracket_ = 0;
};

}  // namespace siemens
