/// M02 and M30: the program ends after this block. An M99 that no syntax has executed as a return stands in the main
/// program, where the control would start again: the run ends there too, and reports it. Some controls return from a
/// called program at its M30. A main program that runs into the end of its file stops the control with an alarm.
#include <isogloss/cnc/leftovers.hpp>
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class InSubprogram { end, return_to_caller };
enum class MissingEnd { silent, warning };

struct ProgramEnd {
  static constexpr auto spec = ig::syntax("ProgramEndSyntax", "M02/M30 end of the program; M99 in the main program.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0230",
                     "M99 in the main program: the run ends here, where the control would start again"),
      ig::diagnostic(IG_WARNING, "ISO-0495", "the main program ends here without M30, M02 or M99"),
  };

  ig::Codes end_{"M02", "M30"};
  ig::Call back_to_start_{{"M99"}, "P[] L[]"};
  ig::Out<ig::Symbol> term_{"ProgramEnd.Term"};

  ig::Choice<InSubprogram> in_subprogram_{"in-subprogram", "end|return", "end",
                                          "M02 and M30 in a called program: end of the run, or return to the caller."};
  ig::Choice<MissingEnd> missing_end_{"missing-end", "silent|warning", "silent",
                                      "Whether a main program without an end before the end of its file is reported."};
  ig::Signal text_ended_{"Source.~End", ig::read | ig::wake};
  ig::Flow flow_;

  ig::Status build(ig::Block& b) {
    if (b.is_raised(text_ended_) && missing_end_ == MissingEnd::warning)
      b.report(ig::diag("ISO-0495"), ig::Where::block());
    const auto end = take_modal(b, end_);
    if (end && in_subprogram_ == InSubprogram::return_to_caller && flow_.frame(b).depth > 0) {
      flow_.leave(b);
      return ig::Status::changed;
    }
    const bool again = is_unanswered(b, back_to_start_.code(0));
    if (!end && !again) return ig::Status::unchanged;
    if (again) {
      b.take(back_to_start_);
      b.report(ig::diag("ISO-0230"), ig::Where::word(back_to_start_.code(0)));
    }
    b.set(term_, end ? end_.name(*end) : back_to_start_.name(0));
    b.end_program();
    return ig::Status::changed;
  }
};

const ig::Register<ProgramEnd> program_end_syntax;

}  // namespace
}  // namespace iso
