// LBL n marks a place, LBL 0 ends a subprogram. CALL LBL n runs the subprogram, CALL LBL n REP k repeats the part of
// the program from the label to here k more times, CALL PGM runs another program.
#include <isogloss/cnc/machine_codes.hpp>

#include "flow/called_program.hpp"
#include "language/block_words.hpp"
#include "language/file_name.hpp"
#include "language/klartext_values.hpp"
#include "motion/contour_side.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextLabel {
  static constexpr auto spec = ig::syntax("KlartextLabelSyntax", "LBL, CALL LBL with REP, CALL PGM and SEL PGM.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .scans("CLScls")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "HEI-0392",
          "LBL {0} stands more than once in this program, which a control refuses: give each label its own name"),
      ig::diagnostic(IG_ERROR, "HEI-0373", "no program is selected, so none is called: program SEL PGM before it"),
  };

  ContourSide side_;  // the call of a program ends RL and RR
  Values values_;
  ProgramsOfBuilder builder_;
  ig::Signal statement_{"Parsing.~KlartextLabel", ig::read | ig::write | ig::wake};
  ig::TextField label_{"KlartextLabel.Name", ig::write, {ig::Life::block, "", "The label that the block defines."}};
  ig::Out<ig::Symbol> term_{"SubProgramCall.Term"};
  ig::TextField file_name_{"SubProgramCall.FileName", ig::write};
  ig::Out<ig::Symbol> selected_{"SelectedProgram.Name",
                                {ig::Life::modal, "", "The program that SEL PGM has selected."}};
  ig::Name call_label_{"CALL LBL"}, call_program_{"CALL PGM"}, call_selected_{"CALL SELECTED PGM"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    // The second letters of CALL, LBL and SEL: nearly all blocks begin otherwise.
    const unsigned second = letter_index(at(text, position + 1));
    if (second != letter_index('A') && second != letter_index('B') && second != letter_index('E')) return position;
    return statement(b, text, position);
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(statement_) || found_.end > b.source().size()) return ig::Status::unchanged;
    const std::string_view text = b.source().substr(0, found_.end);
    const std::size_t i = skip(text, found_.after);
    switch (found_.kind) {
      case Kind::label: label(b, text, i); break;
      case Kind::call: call(b, text, i); break;
      case Kind::program: call_program(b, text, i); break;
      case Kind::selection: select(b, text, i); break;
      case Kind::selected: call_selected(b, text, i); break;
    }
    return ig::Status::changed;
  }

 private:
  [[gnu::noinline]] std::size_t statement(ig::Block& b, std::string_view text, std::size_t position) {
    const auto found = statement_at(text, position);
    if (!found || !stands_first(text, position) || !b.is_in_turn()) return position;
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) {
      if (found->kind == Kind::label) name_label(b, text, found->after, end);
      return end;
    }
    found_ = {found->kind, position, found->after, end};
    if (found->kind == Kind::program || found->kind == Kind::selected) side_.end(b, position, found->after);
    b.raise(statement_);
    return end;
  }

  enum class Kind { label, call, program, selection, selected };
  struct Found {
    Kind kind;
    std::size_t after;
  };

  static std::optional<Found> statement_at(std::string_view text, std::size_t position) {
    if (const std::size_t i = keyword(text, position, "CALL LBL"); i != position) return Found{Kind::call, i};
    if (const std::size_t i = keyword(text, position, "CALL PGM"); i != position) return Found{Kind::program, i};
    if (const std::size_t i = keyword(text, position, "CALL SELECTED PGM"); i != position)
      return Found{Kind::selected, i};
    if (const std::size_t i = keyword(text, position, "SEL PGM"); i != position) return Found{Kind::selection, i};
    if (const std::size_t i = keyword(text, position, "LBL"); i != position) return Found{Kind::label, i};
    return std::nullopt;
  }
  ig::Where whole() const { return ig::Where::columns(found_.begin, found_.end); }

  void name_label(ig::Block& b, std::string_view text, std::size_t i, std::size_t end) {
    std::size_t name_end = i;
    const std::string name = read_name(text.substr(0, end), skip(text, i), name_end);
    if (!name.empty() && name != "0") values_.flow().label(b, "L" + name);
  }

  void label(ig::Block& b, std::string_view text, std::size_t i) {
    std::size_t end = i;
    const std::string name = read_name(text, i, end);
    if (name.empty()) {
      b.report(ig::diag("HEI-0119"), whole(), std::string_view("the label"));
      return;
    }
    b.set_text(label_, name);
    report_rest(b, text, end, "LBL");
    if (name != "0") report_second(b, name);
    if (name == "0" && values_.flow().frame(b).tag == called_label) values_.flow().leave(b);
  }

  void report_second(ig::Block& b, const std::string& name) {
    const bool is_in_program = values_.flow().here(b).line > 0;  // a case of a page is in none
    if (!is_in_program) return;
    const auto is_there = [&](ig_search where) { return values_.flow().has_label(b, "L" + name, where); };
    if (!is_there(IG_SEARCH_FORWARD) && !is_there(IG_SEARCH_BACKWARD)) return;
    QStore* const store = values_.store();
    const std::string place = std::string(ig::to_view(values_.flow().frame(b).file)) + '\n' + name;
    if (store == nullptr || store->is_first_time(392, place))
      b.report(ig::diag("HEI-0392"), whole(), std::string_view(name));
  }

  /// REP 3/3, REP Q3/Q3: the control shows the remaining repeats, and writes them into listings.
  static std::size_t behind_count_left(std::string_view text, std::size_t end) {
    const std::size_t slash = skip(text, end);
    if (at(text, slash) != '/') return end;
    const std::size_t count = skip(text, slash + 1);
    std::size_t behind = count;
    if (!Values::q_at(text, count, behind)) behind = skip_digits(text, count);
    return behind == count ? end : behind;
  }

  void call(ig::Block& b, std::string_view text, std::size_t i) {
    std::size_t end = i;
    std::string name = called_name(b, text, i, end);
    if (name.empty()) return;
    const auto where = ig::Where::columns(i, end);
    const std::size_t rep = skip(text, end);
    const std::size_t behind_rep = glued(text, rep, "REP");
    b.set(term_, call_label_);
    if (rep < text.size() && behind_rep == rep) {
      report_rest(b, text, rep, "CALL LBL");
    } else if (rep < text.size()) {
      const Value times = values_.read(b, text, skip(text, behind_rep));
      if (times.ok) {
        report_rest(b, text, behind_count_left(text, times.end), "CALL LBL");
        if (!(times.number >= 1)) report_no_repeat(b, text, rep, times.end);
        return repeat(b, name, where, times.number);
      }
      if (skip(text, behind_rep) < text.size()) report_rest(b, text, behind_rep, "CALL LBL");
    }
    name.insert(0, 1, 'L');
    const ig::Flow::Answer answer =
        values_.flow().call(b, {.program = name, .scope = IG_IN_PROGRAM, .tag = called_label});
    if (answer.is_not_found()) b.report(ig::diag("HEI-0120"), where, std::string_view(name).substr(1), answer.reason);
  }

  void report_no_repeat(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) const {
    QStore* const store = values_.store();
    if (store == nullptr || store->is_first_time(values_.flow().here(b).offset, "REP"))
      b.report(ig::diag("HEI-0105"), ig::Where::columns(begin, end), trim(piece(text, begin, end)),
               std::string_view("CALL LBL"));
  }

  /// A number, a name in quotes, or the value of a Q parameter.
  std::string called_name(ig::Block& b, std::string_view text, std::size_t i, std::size_t& end) const {
    std::size_t q_end = i;
    if (Values::text_parameter_at(text, i, q_end)) {
      end = q_end;
      const auto held = values_.text(b, text, i, end);
      return in_capitals(held ? trim(*held) : std::string_view());
    }
    if (Values::q_at(text, i, q_end)) {
      const Value v = values_.read(b, text, i);
      end = v.end;
      if (v.number >= 0 && v.number < 1e9 && v.number == std::floor(v.number))
        return std::to_string(static_cast<std::int64_t>(v.number));
    } else if (std::string name = read_name(text, i, end); !name.empty()) {
      return name;
    }
    b.report(ig::diag("HEI-0119"), whole(), std::string_view("the label"));
    return {};
  }

  void repeat(ig::Block& b, const std::string& name, ig::Where where, double times) const {
    const ig_place here = values_.flow().here(b);
    if (values_.store() == nullptr) return;
    const bool goes_on = values_.store()->repeat(here.frame, here.offset, times);
    if (values_.examined().is_heard())
      values_.examined().add_reason(b, goes_on ? values_.store()->repeats_left(here.frame, here.offset)
                                               : std::string(times >= 1 ? "all repeats are made" : "REP is below 1"));
    if (!goes_on) return;
    const ig::Flow::Answer answer = values_.flow().jump(b, "L" + name, IG_SEARCH_TOP);
    if (answer.is_not_found()) b.report(ig::diag("HEI-0120"), where, std::string_view(name), answer.reason);
  }

  /// TNC:\FOLDER\NAME.H, in quotes or not: only the name is used.
  void call_program(ig::Block& b, std::string_view text, std::size_t i) {
    const auto path = file_name_at(b, values_, text, i);
    if (!path) return;
    if (path->empty()) return b.report(ig::diag("HEI-0119"), whole(), std::string_view("the program"));
    b.set(term_, call_program_);
    call(b, *path, ig::Where::columns(i, text.size()));
  }

  void call(ig::Block& b, std::string_view path, ig::Where where) {
    b.set_text(file_name_, path);
    const std::string name = program_name(path);
    if (const ig_machine_code* const row = builder_.row(name)) return execute(b, *row, path, where);
    const ig::Flow::Answer answer = ask_program(b, values_.flow(), path);
    if (!answer.is_not_found()) return;
    if (const ig_machine_code* const row = builder_.family(name)) return execute(b, *row, path, where);
    if (builder_.ignores(b, path, where)) return;
    if (QStore* const s = values_.store(); s == nullptr || s->is_first_time(121, path))
      b.report(ig::diag("HEI-0121"), where, path, answer.reason);
  }

  /// SEL PGM "TNC:\NAME.H"
  void select(ig::Block& b, std::string_view text, std::size_t i) const {
    const auto path = file_name_at(b, values_, text, i);
    if (path && path->empty()) b.report(ig::diag("HEI-0119"), whole(), std::string_view("the program"));
    if (path && !path->empty())
      b.set(selected_, b.symbol(*path));
    else
      b.erase(selected_);
  }

  void call_selected(ig::Block& b, std::string_view text, std::size_t i) {
    const std::string path(b.text(b.get_or(selected_, ig::Symbol{})));
    report_rest(b, text, i, "CALL SELECTED PGM");
    b.set(term_, call_selected_);
    if (path.empty()) return b.report(ig::diag("HEI-0373"), whole());
    call(b, path, whole());
  }

  /// A row of MachineCodes in place of the program.
  void execute(ig::Block& b, const ig_machine_code& row, std::string_view path, ig::Where where) {
    const auto call = [&](std::string_view program) {
      const ig::Flow::Answer answer = ask_program(b, values_.flow(), program);
      if (answer.is_not_found()) b.report(ig::diag("HEI-0121"), where, program, answer.reason);
    };
    builder_.execute(b, row, path, where, call,
                     [&](std::string_view parameter) { return values_.in_row(b, parameter, where); });
  }

  struct {
    Kind kind = Kind::label;
    std::size_t begin = 0, after = 0, end = 0;
  } found_;
};

const ig::Register<KlartextLabel> klartext_label_syntax;

}  // namespace
}  // namespace heidenhain
