// M99: return to the calling program, to the block after the call or to a sequence number. In the main program it
// starts the program again as long as passes are left; the last pass ends the run.
#include <stdexcept>

#include <isogloss/cnc/program_name.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

std::uint64_t read_passes(std::string_view text, std::int64_t otherwise) {
  if (text.empty()) return static_cast<std::uint64_t>(otherwise);
  std::uint64_t passes = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), passes);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument("main-passes is a whole number from 0");
  return passes;
}

enum class PMeans { in_caller, in_own_program };

struct SubprogramReturn {
  static constexpr auto spec = ig::syntax("SubprogramReturnSyntax", "M99 returns to the calling program.")
                                   .after("SubprogramCallSyntax")
                                   .before("ProgramEndSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0487",
                     "M99 P{0}: the calling program has no N{0}, so the run continues after the call"),
      ig::diagnostic(IG_ERROR, "ISO-0488", "M99 P{0}: P is not a valid sequence number and is not executed"),
      ig::diagnostic(IG_WARNING, "ISO-0489", "M99 with L{0} has no meaning here: L is ignored"),
      ig::diagnostic(IG_ERROR, "ISO-0494", "M99 P{0}: the program has no N{0}, so the run ends here"),
  };

  ig::IntegerOption passes_{
      "main-passes",
      "1",
      {0, 1e15},
      "How often the main program runs, restarted by M99, before the run ends; 0: until a limit ends the run."};
  ig::Setting setting_{"main-passes"};
  ig::Choice<PMeans> p_means_{"p-means", "in-caller|in-own-program", "in-caller",
                              "Where block N of M99 P in a subprogram is: in the calling program, or in the subprogram "
                              "itself, which continues."};
  ig::Call return_{{"M99"}, "P[] L[]"};
  ig::Out<ig::Symbol> term_{"SubProgramReturn.Term"};
  ig::Out<std::int64_t> p_{"SubProgramReturn.P"};
  ig::Flow flow_;
  std::uint64_t allowed_ = read_passes(setting_.text(), passes_);
  std::uint64_t pass_ = 1;

  ig::Status restart(ig::Block&) {
    pass_ = 1;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    if (!b.find(return_)) return ig::Status::unchanged;
    if (flow_.frame(b).depth == 0) return in_main(b);
    return p_means_ == PMeans::in_own_program && wanted(b) ? within_subprogram(b) : in_subprogram(b);
  }

 private:
  std::optional<std::int64_t> wanted(const ig::Block& b) const {
    ig_value p;
    return b.get(return_.word(0, 'P'), p) ? whole_number(p.number) : std::nullopt;
  }

  /// A jump within the subprogram, without a return. Where there is no such block the subprogram goes on.
  ig::Status within_subprogram(ig::Block& b) {
    const ig::Where where = place_of_p(b);
    const ig::Words words = *b.take(return_);
    b.set(term_, return_.name(0));
    if (const auto l = words['L']) b.report(ig::diag("ISO-0489"), where, *l);
    const std::int64_t label = sequence_number(b, words, where).value_or(0);
    const ig::Flow::Answer answer = flow_.jump(b, NumberedName('N', label).text());
    if (answer.is_not_found()) {
      b.report(ig::diag("ISO-0494"), where, static_cast<double>(label));
      b.end_program();
    }
    report(b, answer, where);
    return ig::Status::changed;
  }

  ig::Status in_subprogram(ig::Block& b) {
    const ig::Where where = place_of_p(b);
    const ig::Words words = *b.take(return_);
    b.set(term_, return_.name(0));
    std::uint32_t flags = 0;
    if (const auto l = words['L']) {
      if (*l == 0)
        flags = IG_GO_DROP_REPEATS;
      else
        b.report(ig::diag("ISO-0489"), where, *l);
    }
    const auto label = sequence_number(b, words, where);
    ig::Flow::Answer answer = flow_.leave(b, label ? NumberedName('N', *label).text() : std::string_view{}, flags);
    if (label && answer.is_not_found()) {
      b.report(ig::diag("ISO-0487"), where, static_cast<double>(*label));
      answer = flow_.leave(b, {}, flags);
    }
    report(b, answer, where);
    return ig::Status::changed;
  }

  /// A jump forward does not begin a new pass. After the last pass ProgramEndSyntax ends the run.
  ig::Status in_main(ig::Block& b) {
    const ig::Where where = place_of_p(b);
    const auto wanted = this->wanted(b);
    const std::int64_t number = wanted.value_or(0);
    const NumberedName label('N', number);
    ig::Flow::Answer answer{IG_GO_NOT_FOUND, {}};
    if (wanted) answer = flow_.jump(b, label.text(), IG_SEARCH_FORWARD);
    if (!answer.is_done()) {
      answer = wanted ? flow_.jump(b, label.text(), IG_SEARCH_TOP) : flow_.restart(b);
      if (answer.is_done() && allowed_ != 0 && pass_ >= allowed_) return ig::Status::unchanged;
      ++pass_;
    }
    const ig::Words words = *b.take(return_);
    b.set(term_, return_.name(0));
    if (const auto l = words['L']) b.report(ig::diag("ISO-0489"), where, *l);
    if (sequence_number(b, words, where) && answer.is_not_found()) {
      b.report(ig::diag("ISO-0494"), where, static_cast<double>(number));
      b.end_program();
    }
    report(b, answer, where);
    return ig::Status::changed;
  }

  ig::Where place_of_p(const ig::Block& b) const {
    ig_word place{};
    if (b.word(return_.word(0, 'P'), place)) return ig::Where::columns(place.begin, place.end);
    return ig::Where::word(return_.code(0));
  }

  std::optional<std::int64_t> sequence_number(ig::Block& b, const ig::Words& words, const ig::Where& where) {
    const auto p = words['P'];
    if (!p) return std::nullopt;
    const auto label = whole_number(*p);
    if (label)
      b.set(p_, *label);
    else
      b.report(ig::diag("ISO-0488"), where, *p);
    return label;
  }

  static void report(ig::Block& b, const ig::Flow::Answer& answer, const ig::Where& where) {
    if (answer.status == IG_GO_TAKEN) b.report(ig::diag("ISO-0493"), where, std::string_view("M99"));
  }
};

const ig::Register<SubprogramReturn> subprogram_return_syntax;

}  // namespace
}  // namespace iso
