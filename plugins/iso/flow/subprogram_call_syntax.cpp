// M98, and M198 and M97 where the machine has them: a program is called after this block, once or several times. It
// begins with the caller's modal state, and its changes stay after the return.
#include <cmath>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/cnc/program_name.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "flow/program_of_row.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class Answered { no, yes };
enum class PForm { split, whole };
enum class StartAddress { none, q, h };
enum class WithoutProgram { error, same_program };

constexpr double largest_number = 99'999'999;
constexpr std::uint32_t in_folders = IG_IN_FOLDERS;
constexpr std::uint32_t anywhere = IG_IN_FILES | IG_IN_FOLDERS;

struct SubprogramCall {
  static constexpr auto spec = ig::syntax("SubprogramCallSyntax", "M98, M198 and M97 call a subprogram.")
                                   .after("ProgramNumberSyntax")
                                   .before("ProgramEndSyntax", "NotExecutedSyntax")
                                   .scans("<");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0481", "{0} without P: no program is called"),
      ig::diagnostic(IG_ERROR, "ISO-0482", "{0}: P{1} is not a valid program number, so nothing is called"),
      ig::diagnostic(IG_ERROR, "ISO-0483", "{0}: L{1} is not a valid number of calls, so the program is called once"),
      ig::diagnostic(IG_WARNING, "ISO-0484",
                     "{0} with a count of 0: the program is not called, so remove the block or the count"),
      ig::diagnostic(IG_ERROR, "ISO-0485", "program {0} is not found, so it is not called: {1}"),
      ig::diagnostic(IG_ERROR, "ISO-0486",
                     "calls are already nested {0} deep, the limit of this control: {1} is not called"),
      ig::diagnostic(IG_WARNING, "ISO-0491", "{0}: there is no O{1} for P{2}, so O{2} is called once"),
      ig::diagnostic(IG_ERROR, "ISO-0595",
                     "{0}: {1}{2} is not a valid sequence number, so the program is called from its beginning"),
      ig::diagnostic(IG_WARNING, "ISO-0596",
                     "{0}: the word {1} has no effect, because a row of MachineCodes stands for the program"),
      ig::diagnostic(IG_ERROR, "ISO-0492", "'{0}' does not belong to a call and is not executed"),
  };

  ig::Choice<PForm> p_form_{
      "p-form", "split|whole", "split",
      "P with more digits than a program number, without L: a count and a number, or one number."};
  ig::IntegerOption p_digits_{
      "p-digits", "4", {1, 8}, "The number of digits of a program number in a P that is split."};
  ig::Choice<StartAddress> start_address_{
      "start-address", "none|Q|H", "none",
      "The word that gives the sequence number at which the called program starts."};
  ig::Choice<WithoutProgram> without_program_{
      "without-program", "error|same-program", "error",
      "A call with a sequence number but no program: an error, or a call of that block in the same program."};
  ig::IntegerOption levels_{"levels", "10", {0, 1000}, "How deep calls may be nested on the control; 0: any depth."};
  ig::Choice<Answered> external_{"m198", "no|yes", "no",
                                 "M198 calls a program on another device: in the folders, not in the same file."};
  ig::Choice<Answered> local_{"m97", "no|yes", "no", "M97 calls a sequence number of the same program."};

  ig::Call call_{{"M98", "M198", "M97"}, "P[] L[] Q[] H[]"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::read | ig::write | ig::wake};
  ig::Codes other_calls_{{"G65", "G66", "G66.1"}, ig::read};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::Out<std::int64_t> p_{"SubProgramCall.P"};
  ig::Out<std::int64_t> l_{"SubProgramCall.L"};
  ig::Flow flow_;
  RowsOfPrograms builder_;

  /// The name of M98 <PART>. A name that stands first in the block begins a program and is not read here.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    constexpr std::size_t longest = 256;  // of the name of a file, with its brackets
    const std::size_t end = skip_bracketed(text.substr(0, std::min(text.size(), position + longest)), position);
    if (text[end - 1] != '>' || stands_first(text, position)) return position;
    b.set_text(file_name_, piece(text, position, end));
    return end;
  }

  ig::Status build(ig::Block& b) {
    const std::string_view name = b.text(file_name_);
    const auto row = b.find(call_);
    if (!row || !is_answered(*row)) {
      if (!name.empty() && !b.find(other_calls_)) report_lost(b, name);
      return ig::Status::unchanged;
    }
    Request request{*row, b.text(call_.name(*row)), ig::Where::word(call_.code(*row)), 0, 1, 0, *row == m97};
    const std::optional<double> p = take(b, *row, 'P', &request.where);
    const std::optional<double> l = take(b, *row, 'L');
    const std::optional<double> start = start_of(b, *row);
    const ig_field code = call_.code(*row);
    b.take_code(&code, 1);
    b.set(term_, call_.name(*row));
    if (start) request.start = static_cast<std::int64_t>(*start);
    if (l) count(b, request, *l);
    if (p && !name.empty()) report_lost(b, name);
    if (p)
      number(b, request, *p, l.has_value());
    else if (!name.empty())
      named(b, request, name);
    else if (start && without_program_ == WithoutProgram::same_program)
      of_same_program(b, request);
    else
      b.report(ig::diag("ISO-0481"), request.where, request.code);
    return ig::Status::changed;
  }

 private:
  static void report_lost(ig::Block& b, std::string_view name) {
    const std::size_t begin = b.source().find(name);
    b.report(ig::diag("ISO-0492"),
             begin == std::string_view::npos ? ig::Where::block() : ig::Where::columns(begin, begin + name.size()),
             name);
  }

  struct Request {
    std::size_t row;
    std::string_view code;
    ig::Where where;
    std::int64_t program;
    std::uint32_t repeats;
    std::int64_t start;
    bool is_local;  ///< `program` is a sequence number of the calling program
  };
  static constexpr std::size_t m97 = 2;  // of call_

  bool is_answered(std::size_t row) const { return row == 0 || (row == 1 ? external_ : local_) == Answered::yes; }

  std::optional<double> take(ig::Block& b, std::size_t row, char letter, ig::Where* where = nullptr) const {
    const ig_field field = call_.word(row, letter);
    ig_value value;
    if (where != nullptr) {
      ig_word place{};
      if (b.word(field, place)) *where = ig::Where::columns(place.begin, place.end);
    }
    if (!b.take(field, value)) return std::nullopt;
    return value.number;
  }

  std::optional<double> start_of(ig::Block& b, std::size_t row) const {
    if (start_address_ == StartAddress::none) return std::nullopt;
    const char letter = start_letter();
    const auto start = take(b, row, letter);
    if (!start || is_number(*start)) return start;
    b.report(ig::diag("ISO-0595"), ig::Where::word(call_.word(row, letter)), b.text(call_.name(row)),
             std::string_view(&letter, 1), *start);
    return std::nullopt;
  }
  char start_letter() const { return start_address_ == StartAddress::q ? 'Q' : 'H'; }

  void report_start_of_row(ig::Block& b, const Request& r) const {
    const char letter = start_letter();
    if (r.start != 0 && start_address_ != StartAddress::none)
      b.report(ig::diag("ISO-0596"), ig::Where::word(call_.word(r.row, letter)), r.code, std::string_view(&letter, 1));
  }

  static bool is_number(double value) { return value >= 1 && value <= largest_number && value == std::floor(value); }

  void count(ig::Block& b, Request& r, double l) const {
    if (!(l >= 0 && l <= largest_number && l == std::floor(l)))
      b.report(ig::diag("ISO-0483"), ig::Where::word(call_.word(r.row, 'L')), r.code, l);
    else
      r.repeats = static_cast<std::uint32_t>(l);
  }

  void number(ig::Block& b, Request& r, double p, bool has_count) const {
    if (!is_number(p)) return b.report(ig::diag("ISO-0482"), r.where, r.code, p);
    r.program = static_cast<std::int64_t>(p);
    if (!has_count && !r.is_local && p_form_ == PForm::split) {
      std::int64_t limit = 1;
      for (std::int64_t i = 0; i < p_digits_; ++i) limit *= 10;
      if (r.program >= limit && r.program % limit != 0) return split(b, r, limit);
    }
    show(b, r);
    if (may_call(b, r) && !has_own_row(b, r)) report(b, r, ask(b, r));
  }

  bool has_own_row(ig::Block& b, const Request& r) const {
    if (r.is_local || !builder_.goes_before(b, flow_, {NumberedName('O', r.program).text(), r.repeats, r.where}))
      return false;
    report_start_of_row(b, r);
    return true;
  }

  /// M98 P51234 calls O1234 five times; where only a program O51234 exists, it calls that one.
  void split(ig::Block& b, Request& r, std::int64_t limit) const {
    Request whole = r;
    r.repeats = static_cast<std::uint32_t>(r.program / limit);
    r.program %= limit;
    show(b, r);
    if (!may_call(b, r) || has_own_row(b, r)) return;
    const ig::Flow::Answer answer = ask(b, r);
    if (answer.is_not_found() && ask(b, whole).is_done()) {
      show(b, whole);
      return b.report(ig::diag("ISO-0491"), r.where, r.code, static_cast<double>(r.program),
                      NumberedName('\0', whole.program).text());
    }
    report(b, r, answer.is_not_found() ? ask(b, r) : answer);
  }

  void named(ig::Block& b, Request& r, std::string_view name) const {
    b.set(l_, static_cast<std::int64_t>(r.repeats));
    if (!may_call(b, r, name)) return;
    const std::string_view inner = name.substr(1, name.size() - 2);
    const RowsOfPrograms::Called called{inner, r.repeats, r.where};
    if (builder_.goes_before(b, flow_, called)) return report_start_of_row(b, r);
    const ig_text file = ig::to_text(inner);
    const NumberedName start('N', r.start);
    const ig::Flow::Answer answer = flow_.call(b, {.program = name,
                                                   .files = {&file, 1},
                                                   .scope = r.row == 1 ? in_folders : anywhere,
                                                   .repeats = r.repeats,
                                                   .tag = r.start != 0 ? begins_inside : 0,
                                                   .start = r.start != 0 ? start.text() : std::string_view()});
    if (answer.is_not_found() && builder_.replaces(b, flow_, called)) return report_start_of_row(b, r);
    if (answer.is_not_found())
      b.report(ig::diag("ISO-0485"), r.where, name, answer.reason);
    else
      report(b, r, answer);
  }

  void of_same_program(ig::Block& b, Request& r) const {
    r.program = r.start;
    r.is_local = true;
    show(b, r);
    if (may_call(b, r)) report(b, r, ask(b, r));
  }

  void show(ig::Block& b, const Request& r) const {
    b.set(p_, r.program);
    b.set(l_, static_cast<std::int64_t>(r.repeats));
  }

  bool may_call(ig::Block& b, const Request& r, std::string_view name = {}) const {
    if (r.repeats == 0) {
      b.report(ig::diag("ISO-0484"), r.where, r.code);
      return false;
    }
    const ig_frame frame = flow_.frame(b);
    if (levels_ == 0 || static_cast<std::int64_t>(frame.depth) < levels_) return true;
    const NumberedName number(r.is_local ? 'N' : 'O', r.program);
    b.report(ig::diag("ISO-0486"), r.where, static_cast<double>(frame.depth), name.empty() ? number.text() : name);
    b.alarm();
    return false;
  }

  ig::Flow::Answer ask(ig::Block& b, const Request& r) const {
    if (r.is_local)
      return flow_.call(b,
                        {.program = NumberedName('N', r.program).text(), .scope = IG_IN_PROGRAM, .repeats = r.repeats});
    const ProgramFileNames files(r.program);
    const NumberedName start('N', r.start);
    return flow_.call(b, {.program = NumberedName('O', r.program).text(),
                          .files = files.list(),
                          .scope = r.row == 1 ? in_folders : anywhere,
                          .repeats = r.repeats,
                          .tag = r.start != 0 ? begins_inside : 0,
                          .start = r.start != 0 ? start.text() : std::string_view{}});
  }

  void report(ig::Block& b, const Request& r, const ig::Flow::Answer& answer) const {
    if (answer.is_not_found() && !r.is_local &&
        builder_.replaces(b, flow_, {NumberedName('O', r.program).text(), r.repeats, r.where}))
      return report_start_of_row(b, r);
    if (answer.is_not_found())
      b.report(ig::diag("ISO-0485"), r.where, NumberedName(r.is_local ? 'N' : 'O', r.program).text(), answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("ISO-0493"), r.where, r.code);
  }
};

const ig::Register<SubprogramCall> subprogram_call_syntax;

}  // namespace
}  // namespace iso
