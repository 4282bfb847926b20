/// G65 in files in MACRO format: a macro is called with local variables of its own, and the words of the block are its
/// arguments. G66 and G66.1 keep a macro for the blocks after them. In files in ISO format FanucMacroCallSyntax makes
/// these calls; here the arguments are kept, in case the called file is in MACRO format.

#include "macro/macro_requests.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroCall {
  static constexpr auto spec =
      ig::syntax("SyntecMacroCallSyntax", "G65, G66 and G66.1 in programs in MACRO format, and their arguments.")
          .after("FlagSyntax", "SyntecMacroWordSyntax")
          .before("FanucMacroCallSyntax", "ParameterizedFlagSyntax", "DecimalPointSyntax", "SubprogramCallSyntax")
          .scans("Gg");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0080", "{0} is not executed: {1} modal macros are in force, end one with G67"),
      ig::diagnostic(IG_ERROR, "SYN-0070", "{0} has no P with the number or the name of a program: no macro is called"),
      ig::diagnostic(IG_ERROR, "SYN-0071",
                     "{0} P{1} is not a program number, so no macro is called: write 1 to 99999999"),
      ig::diagnostic(IG_ERROR, "SYN-0076", "{0} is not executed: another call of this block comes first"),
      ig::diagnostic(
          IG_ERROR, "SYN-0078",
          "M99 Q{0} is not executed: the run goes on behind the call, not at line {0} of the calling program"),
      ig::diagnostic(IG_ERROR, "SYN-0079",
                     "{1} has not read {0} of its call in line {2}: the control then moves by the words, here it does "
                     "not"),
  };

  static constexpr std::size_t most_modal = 10;

  ig::Signal call_{"Parsing.~SyntecMacroCall", ig::read | ig::wake};
  ig::Signal modal_{"SyntecMacro.~Modal", ig::write, ig::Life::modal};
  ig::Codes return_{{"M99"}, ig::read | ig::wake};
  ig::In<double> q_{"Parsing.Q"};
  ig::Signal program_{"Parsing.~MacroProgramName", ig::read | ig::wake};
  ig::Signal iso_call_{"Parsing.~SyntecIsoCall", ig::read | ig::write | ig::wake};
  ig::In<std::int64_t> skipped_layer_{"BlockSkip.Layer"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::write};
  SharedScan scan_;
  BlockArguments arguments_;
  MacroEnvironment environment_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const ig::Decimal code = ig::read_decimal(text, skip_blanks(text, position + 1));
    if (!code.ok || !is_macro_call(code.value) || arguments_.is_macro(b) || environment_.flow.is_indexing())
      return position;
    b.raise(iso_call_);
    is_modal_ = code.value != 65;
    words_begin_ = code.end;
    return position;
  }

  ig::Status build(ig::Block& b) {
    if (b.is_raised(iso_call_)) offer(b);
    if (b.find(return_)) return end_macro(b);
    if (!b.is_raised(call_)) {
      // M98 P"NAME" is a call by another syntax, to which names in angle brackets are known.
      if (!b.is_raised(program_)) return ig::Status::unchanged;
      b.set_text(file_name_, "<" + scan_->program + ">");
      return ig::Status::changed;
    }
    environment_.enter(b);
    bool is_done = false;
    for (std::size_t i = scan_->calls.size(); i-- > 0;) {
      const WordCall& call = scan_->calls[i];
      if (call.code != "G65" && call.code != "G66" && call.code != "G66.1") continue;
      if (is_done)
        b.report(ig::diag("SYN-0076"), call.where(), std::string_view(call.code));
      else
        execute(b, call);
      is_done = true;
    }
    return ig::Status::changed;
  }

 private:
  /// The words of a call in ISO format, which FanucMacroCallSyntax makes: here it is known what of them was skipped.
  void offer(ig::Block& b) {
    const ig_place here = environment_.flow.here(b);
    Arguments words = iso_arguments(b.source(), words_begin_, b.get_or(skipped_layer_, std::int64_t{0}));
    environment_.enter(b);
    if (is_modal_)
      environment_.store().offer_modal(std::move(words), here.frame);
    else
      environment_.store().offer(std::move(words), here.frame, here.line);
  }

  void execute(ig::Block& b, const WordCall& call) {
    Arguments given = arguments_.read(b, scan_);
    const std::string name = b.is_raised(program_) ? scan_->program : std::string();
    const MacroValue p = std::exchange(given.letters[letter_index('P')], MacroValue());
    const MacroValue l = given.letters[letter_index('L')];
    arguments_.take(b, all_letters);
    std::int64_t number = 0;
    if (name.empty()) {
      if (!p.is_number() && scan_->has_refused_p) return;  // which is reported
      if (!p.is_number()) return b.report(ig::diag("SYN-0070"), call.where(), std::string_view(call.code));
      if (!(p.number >= 1 && p.number <= 99'999'999) || p.number != std::floor(p.number))
        return b.report(ig::diag("SYN-0071"), call.where(), std::string_view(call.code), p.number);
      number = static_cast<std::int64_t>(p.number);
    }
    const auto repeats = repeats_of(b, l, call.code, call.where());
    if (!repeats || *repeats == 0) return;
    MacroStore& store = environment_.store();
    if (call.code != "G65") {
      if (store.level().modal.size() >= most_modal)
        return b.report(ig::diag("SYN-0080"), call.where(), std::string_view(call.code),
                        static_cast<double>(most_modal));
      const std::uint64_t tag = store.enter_modal(std::move(given));
      store.level().modal.push_back({name, number, *repeats, tag, call.code == "G66.1"});
      b.raise(modal_);
      return;
    }
    const std::uint64_t tag = store.enter(std::move(given), Caller::program);
    const ig::Flow::Answer answer = request_call(b, environment_.flow, number, name, *repeats, tag);
    if (answer.is_done()) return;
    store.leave_last();
    const NumberedName shown('O', number);
    if (answer.is_not_found())
      b.report(ig::diag("SYN-0072"), call.where(), number > 0 ? shown.text() : std::string_view(name), answer.reason);
    else if (answer.status == IG_GO_TAKEN)
      b.report(ig::diag("SYN-0076"), call.where(), std::string_view(call.code));
  }

  ig::Status end_macro(ig::Block& b) {
    environment_.enter(b);
    const ig_frame frame = environment_.flow.frame(b);
    const bool has_line = b.has(q_) && b.is_fresh(q_);
    if (has_line) {
      b.report(ig::diag("SYN-0078"), ig::Where::word(q_.id()), b.get_or(q_, 0.0));
      arguments_.take(b, "Q");
    }
    report_unread(b, frame);
    return has_line ? ig::Status::changed : ig::Status::unchanged;
  }

  /// The words that the macro of a code has not read are the block's again on the control.
  void report_unread(ig::Block& b, const ig_frame& frame) const {
    const MacroStore::Level& level = environment_.store().level();
    if (frame.depth == 0 || level.tag != frame.tag || level.caller != Caller::g_code || !level.is_of_code) return;
    std::string unread;
    for (const char letter : axis_arguments) {
      const bool is_given = !level.arguments.letters[letter_index(letter)].is_vacant();
      if ((level.read_letters >> variable_of_letter(letter) & 1u) != 0) return;  // one that is read takes all
      if (is_given) unread += (unread.empty() ? "" : ", ") + std::string(1, letter);
    }
    if (!unread.empty())
      b.report(ig::diag("SYN-0079"), ig::Where::block(), std::string_view(unread), ig::to_view(frame.program),
               static_cast<double>(frame.call_line));
  }

  // Of the call in ISO format in the block:
  bool is_modal_ = false;
  std::size_t words_begin_ = 0;
};

const ig::Register<SyntecMacroCall> syntec_macro_call_syntax;

}  // namespace
}  // namespace syntec
