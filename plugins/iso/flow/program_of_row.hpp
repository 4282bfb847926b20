/// The program that a row of MachineCodes calls: "9010", "O9010" or a name.
#pragma once

#include <charconv>
#include <string>

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/program_name.hpp>
#include <isogloss/flow.hpp>

namespace iso {

/// Requests its call after this block. A name is called as <NAME>, as O<NAME> and M98 <NAME> have it.
inline ig::Flow::Answer call_program_of_row(ig::Block& b, const ig::Flow& flow, std::string_view program,
                                            std::uint32_t repeats = 1) {
  const bool has_letter = !program.empty() && (program[0] == 'O' || program[0] == 'o');
  const auto name = ig::cnc::numbered_name('O', program.substr(has_letter ? 1 : 0));
  if (!name) {
    const std::string label = "<" + std::string(program) + ">";
    const ig_text file = ig::to_text(program);
    return flow.call(b, {.program = label, .files = {&file, 1}, .repeats = repeats});
  }
  std::int64_t number = 0;
  std::from_chars(name->text().data() + 1, name->text().data() + name->text().size(), number);
  const ig::cnc::ProgramFileNames files(number);
  return flow.call(b, {.program = name->text(), .files = files.list(), .repeats = repeats});
}

/// A member of the syntaxes that call programs: what MachineCodes does in their place.
class RowsOfPrograms {
 public:
  struct Called {
    std::string_view name;  ///< O9010, or the name without brackets
    std::uint32_t repeats;
    ig::Where where;
  };

  /// Executes the row of this very program, which goes before the program; false where there is none.
  bool goes_before(ig::Block& b, const ig::Flow& flow, const Called& called) const {
    return execute(b, flow, called, builder_.row(called.name));
  }
  /// Executes the row of a family, or ignores the call, for a program that is not found.
  bool replaces(ig::Block& b, const ig::Flow& flow, const Called& called) const {
    return execute(b, flow, called, builder_.family(called.name)) || builder_.ignores(b, called.name, called.where);
  }

 private:
  bool execute(ig::Block& b, const ig::Flow& flow, const Called& called, const ig_machine_code* row) const {
    if (row == nullptr) return false;
    builder_.execute(b, *row, called.name, called.where, [&](std::string_view program) {
      const ig::Flow::Answer answer = call_program_of_row(b, flow, program, called.repeats);
      if (answer.is_not_found()) b.report(ig::diag("ISO-0485"), called.where, program, answer.reason);
    });
    return true;
  }

  ig::cnc::ProgramsOfBuilder builder_;
};

}  // namespace iso
