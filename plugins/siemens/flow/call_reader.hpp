/// Reads the calls of the Siemens language, and calls: subprograms, cycles, and procedures of the control.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/cnc/machine_codes.hpp>

#include "cycles/cycle_signatures.hpp"
#include "flow/program_path.hpp"
#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

/// A blank-separated list of names.
class NameSet {
 public:
  explicit NameSet(std::string_view list) {
    while (!(list = trim(list)).empty()) {
      const std::size_t end = std::min(list.find(' '), list.size());
      names_.push_back(upper(list.substr(0, end)));
      list.remove_prefix(end);
    }
  }
  bool holds(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

 private:
  std::vector<std::string> names_;
};

/// The one member of the syntax.
class CallReader {
 public:
  /// Where the call at `position` ends; `position` where none stands there.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position);

  ig::Status build(ig::Block& b);

 private:
  // Messages and pictures; what the path is measured on; other channels; couplings of spindles, and the end of
  // couplings, of the handwheel's offset and of synchronized actions, which are not executed either.
  ig::TextOption silent_list_{
      "silent",
      "MSG WORKPIECE GROUP_BEGIN GROUP_END GROUP_ADDEND E_END SETMS FGROUP CYCLE832 WAITM WAITMC SETM "
      "CLEARM WAITS WAITP WAITE COUPDEF COUPDEL COUPON COUPONC COUPOF COUPOFS COUPRES WRITE DELETE BRISKA SOFTA "
      "DRIVEA JERKA IPOBRKA ADISPOSA NEWCONF TMON TMOF RESETMON SETPIECE CHKDNO CHKDM GWPSON GWPSOF TANGOF TANGDEL "
      "TLIFT TRAILOF LEADOF EGOFS EGOFC EGDEL MASLOF MASLOFS MASLDEL CTABDEL CTABLOCK CTABUNLOCK TOFFOF SPCON SPCOF "
      "WAITENC GET GETD RELEASE AXTOCHAN INIT CANCEL LOCK UNLOCK RESET CLRINT ENABLE DISABLE PROTA PROTS "
      "PROTD "
      "CPROT CPROTDEF NPROT NPROTDEF FCTDEF CORROF DRFOF IPTRLOCK IPTRUNLOCK POLFMASK POLFMLIN BLSYNC",
      "Procedures of the control that move nothing and change nothing here."};
  std::vector<CycleFields> cycles_ = all_cycles();
  ig::Codes modal_{{"MCALL"}, ig::read};
  ig::Codes traori_{{"TRAORI"}, ig::write};
  ig::TextField message_{"Message.Text", ig::write, {ig::Life::block, "", "What MSG shows."}};
  ig::Signal modal_call_{"ModalCall.~Begins", ig::write};
  ig::Signal call_{"Parsing.~Call", ig::read | ig::write | ig::wake};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_{"SubProgramCall.FileName", ig::write};
  MachineCodes machine_;
  MachineCodeRecord record_;
  RecordedMachineCodes recorded_;
  CodesOfMachineCodes codes_{machine_};
  Environment environment_;
  OtherMeaning other_meaning_{ig::write};
  NameSet silent_{silent_list_.text()};

  // ---- call_reader.cpp: which call it is

  /// CTABDEF begins the definition of a curve, CTABEND ends it; cycles and calls in between are part of it. Nothing:
  /// the name is none of that.
  std::optional<std::size_t> curve(ig::Block& b, std::string_view name, std::string_view text, std::size_t position,
                                   std::size_t next);

  /// What DEFINE says of the name: one that looks like a code counts, too (DEFINE M6 AS L6).
  const std::string* macro_at(ig::Block& b, std::string_view text, std::size_t position, std::size_t end) const;

  ig::Where columns_of(std::size_t begin, std::size_t end) const { return environment_.columns(begin, end); }

  /// A name for a call (DEFINE).
  std::size_t expand(ig::Block& b, std::string_view text, std::size_t position, std::size_t end,
                     const std::string& macro);

  /// A program or a cycle of the machine's builder, of which the table MachineCodes has a row. `next` is where its
  /// parameters may begin.
  std::size_t of_builder(ig::Block& b, std::string_view text, std::size_t end, std::size_t next,
                         const ig_machine_code& row);
  /// What {2} is in a row that sets fields: the number in the second argument.
  auto number_of_argument() const {
    return [this](std::string_view name) -> std::optional<double> {
      std::size_t number = 0;
      std::from_chars(name.data(), name.data() + name.size(), number);
      if (number < 1 || number > arguments_.size()) return std::nullopt;
      const std::optional<Value>& value = arguments_[number - 1].value;
      return value && !value->is_text() ? std::optional(value->number) : std::nullopt;
    };
  }

  // ---- program_calls.cpp: the call itself

  /// Requests the call in build(). A program that is not found may be one of the builder's.
  void call_program(ig::Block& b, ig::Where where);
  /// A cycle of the control that is not executed here: where the machine has a program of that name, it is called.
  std::size_t of_control(ig::Block& b, std::string_view text, const std::string& name, std::size_t open,
                         std::size_t close);
  /// CALL "NAME", EXTCALL("FOLDER/NAME.SPF"), PCALL NAME(1,2)
  std::size_t indirect(ig::Block& b, std::string_view text, std::size_t next, const std::string& how);

  /// The end of P3 behind a name that calls nothing; `end` where no P stands there.
  std::size_t count_end(ig::Block& b, std::string_view text, std::size_t end);

  static std::vector<CycleFields> all_cycles();
  const CycleFields* cycle_of(std::string_view name) const;

  /// P3 or P=R1 behind the name; `next` is where it may stand.
  std::size_t request(ig::Block& b, std::string_view text, std::size_t next, CalledProgram program, std::size_t end);

  // ---- control_procedures.cpp: what the control knows by name

  /// CALLPATH("/_N_WKS_DIR/_N_PART_WPD"): one more folder in which programs are searched.
  void add_call_path(ig::Block& b, std::string_view text, std::size_t open, ig::Where where);

  /// SETMS(2): what S and M3 mean from here on.
  void name_master(ig::Block& b, std::string_view text, std::size_t open);

  /// GETEXET(NUMBER) and GETSELT(NUMBER): the tool in the spindle, and the one that T has named.
  void give_tool(ig::Block& b, std::string_view text, std::size_t open, std::string_view tool, ig::Where where);

  /// MSG("…"), SETAL(65000), cycles that are not executed. False: a subprogram.
  bool is_known(ig::Block& b, std::string_view text, const std::string& name, std::size_t open, std::size_t close);

  // ---- call_arguments.cpp: the parameters of a call

  bool read_arguments(ig::Block& b, std::string_view text, std::size_t open);

  /// Where a variable alone stands, a VAR parameter may change it.
  void name_of(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, Argument& argument) const;

  void pass(ig::Block& b, const CycleFields& cycle, std::string_view text, std::size_t open, std::size_t close);

  // What scan() has found.
  std::size_t begin_ = 0, open_ = 0, end_ = 0;
  bool is_of_control_ = false;
  CalledProgram program_;
  std::vector<Argument> arguments_;
  double repeats_ = 1;
};

}  // namespace siemens
