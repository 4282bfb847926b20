// Q parameters: FN 0 to FN 8 and FN 13 assign, FN 9 to FN 12 jump to a label, FN 18 reads, Q1 = … is a formula. The
// scanner reads the statement as a whole; build() executes it, after everything before it in the block.
#include <algorithm>
#include <iterator>

#include "cycles/cycle_text.hpp"
#include "language/block_words.hpp"
#include "language/fn_arithmetic.hpp"
#include "language/fn_jump.hpp"
#include "language/string_formula.hpp"
#include "language/system_answers.hpp"
#include "language/system_data.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextParameter {
  static constexpr auto spec = ig::syntax("KlartextParameterSyntax", "FN functions and formulas with Q parameters.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .scans("DFQdfq");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0117", "FN {0} is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "HEI-0372", "{0} cannot hold {1} characters, so it keeps its text: the control has {2}"),
      ig::diagnostic(IG_ERROR, "HEI-0118", "the program stops the control here with error {0} (FN 14)"),
  };

  CycleText cycle_;
  SystemData system_;
  ig::Service<SystemAnswers> answers_{system_answer_service, ig::Need::optional, "What FN 18 reads on this machine."};
  ig::AnsweredRows rows_{system_answer_service};
  ig::TextField row_{"SystemData.Row", ig::write, {ig::Life::block, "", "The row that has answered FN 18."}};
  ig::TextField title_{"SystemData.Title", ig::write, {ig::Life::block, "", "What this row means."}};
  CycleDefinition definition_{ig::read | ig::write};
  ig::Field<std::int64_t> cycle_number_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::Signal statement_{"Parsing.~KlartextStatement", ig::read | ig::write | ig::wake};
  ig::Out<std::int64_t> parameter_{"Vars.Q", {ig::Life::block, "", "Number of the Q parameter that was assigned."}};
  ig::Out<double> value_{"Vars.Value", {ig::Life::block, "", "What was assigned."}};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!stands_first(text, position) || kind_at(text, position) == Kind::none) return position;
    end_ = statement_end(text, position);
    begin_ = position;
    if (!cycle_.values().is_indexing()) b.raise(statement_);
    return end_;
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(statement_) || end_ > b.source().size()) return ig::Status::unchanged;
    const std::string_view text = b.source().substr(0, end_);
    switch (kind_at(text, begin_)) {
      case Kind::function: function(b, text); break;
      case Kind::formula: formula(b, text); break;
      default: string(b, text);
    }
    return ig::Status::changed;
  }

 private:
  enum class Kind { none, function, formula, text };

  static Kind kind_at(std::string_view text, std::size_t position) {
    if (to_upper(text[position]) == 'F') {
      const std::size_t digits = skip_blanks(text, position + 2);
      return to_upper(at(text, position + 1)) == 'N' && is_digit(at(text, digits)) ? Kind::function : Kind::none;
    }
    std::size_t end = position;
    if (keyword(text, position, "DECLARE STRING") != position) return Kind::text;
    if (Values::text_parameter_at(text, position, end)) return Kind::text;
    return Values::q_at(text, position, end) ? Kind::formula : Kind::none;
  }

  ParameterReader reader(ig::Block& b, std::string_view text) const { return {b, cycle_.values(), text, begin_}; }

  void assign(ig::Block& b, const ParameterReader::Target& t, double value) {
    if (!std::isfinite(value)) {
      b.report(ig::diag("HEI-0113"), ig::Where::columns(t.begin, end_),
               trim(b.source().substr(t.after, end_ - t.after)));
      b.alarm();
      return;
    }
    cycle_.values().set(b, t.q, t.name, ig::Where::columns(t.begin, t.begin + t.name.size()), value + 0.0);
    if (!QStore::exists(t.q)) return;
    if (t.q.kind == QKind::q) b.set(parameter_, static_cast<std::int64_t>(t.q.number));
    b.set(value_, value + 0.0);
    if (t.q.kind == QKind::q) of_cycle(b, t.q.number, value);
  }

  /// A cycle reads its parameters when it is called: Q201 = -18 after CYCL DEF 200 changes the depth.
  void of_cycle(ig::Block& b, std::uint32_t q, double value) const {
    if (q >= 200 && b.get_or(cycle_number_, std::int64_t{0}) >= 200) cycle_.set(b, definition_, q, value);
  }

  void formula(ig::Block& b, std::string_view text) {
    const ParameterReader read = reader(b, text);
    const auto t = read.target(begin_);
    if (!t) return;
    const std::size_t first = skip(text, t->after);
    if (at(text, first) == '"' || is_string_parameter(text, first)) return read.refuse_text();
    if (const auto value = cycle_.values().formula(b, text, t->after, end_)) assign(b, *t, *value);
  }

  /// QS10 = QS1 || "A", DECLARE STRING QS10 = "A"
  void string(ig::Block& b, std::string_view text) const {
    const ParameterReader read = reader(b, text);
    const std::size_t name = skip(text, keyword(text, begin_, "DECLARE STRING"));
    std::size_t end = name;
    const auto number = Values::text_parameter_at(text, name, end);
    if (!number) return read.missing("the string parameter");
    const std::size_t equals = skip(text, end);
    if (at(text, equals) != '=') return read.missing("=");
    const std::string_view shown = piece(text, name, end);
    const auto where = ig::Where::columns(name, end);
    QStore* const store = cycle_.values().store();
    if (store == nullptr || *number >= QStore::q_count) return b.report(ig::diag("HEI-0114"), where, shown);
    StringFormula formula(b, cycle_.values(), text, equals + 1);
    auto value = formula.text();
    if (!value || !read.ends(formula.position())) return;
    if (value->size() > QStore::longest_text)
      return b.report(ig::diag("HEI-0372"), where, shown, static_cast<double>(value->size()),
                      static_cast<double>(QStore::longest_text));
    cycle_.values().note_text(b, *number, *value);
    store->set_text(*number, std::move(*value));
  }

  // ---- FN

  void function(ig::Block& b, std::string_view text) {
    const std::size_t digits = skip_blanks(text, begin_ + 2);
    const std::size_t end = skip_digits(text, digits);
    unsigned number = 99;
    std::from_chars(text.data() + digits, text.data() + end, number);
    std::size_t i = skip(text, end);
    if (at(text, i) == ':') i = skip(text, i + 1);
    if (number <= 8 || number == 13) {
      if (const auto result = compute_fn(reader(b, text), i, number)) assign(b, result->target, result->value);
      return;
    }
    if (number <= 12) return jump_by_fn(reader(b, text), i, number);
    if (number == 14) return error(b, text, i);
    const std::string_view whole = rest_of_line(text, begin_);
    if (number == 15 || number == 16 || number == 38) return;  // output: no position depends on it
    // The run reads ahead of nothing, so that there is nothing to wait for.
    if (number == 20 && is_end(text, keyword(text, i, "WAIT FOR SYNC"))) return;
    if (number == 17 && write_system(b, text, i)) return;
    if (number == 18 && read_system(b, text, i)) return;
    // Reported once for each datum that FN 18 reads, and once for each of the other functions.
    QStore* const store = cycle_.values().store();
    const std::size_t equals = number == 18 ? whole.find('=') : std::string_view::npos;
    std::string kind = std::to_string(number);
    if (equals != std::string_view::npos)
      std::copy_if(whole.begin() + static_cast<std::ptrdiff_t>(equals), whole.end(), std::back_inserter(kind),
                   [](char c) { return !is_space(c); });
    if (store != nullptr && !store->is_first_time(117, kind)) return;
    b.report(ig::diag("HEI-0117"), where_of_line(text, begin_), double(number), effect_of(number));
  }

  /// What is missing where the function is not executed.
  static std::string_view effect_of(unsigned number) {
    switch (number) {
      case 17: return "only L, R, R2, DL, DR and DR2 of a tool can be written here, by a number";
      case 18: return "no row of HeidenhainSystemData answers it, so the parameter keeps its value";
      case 19:
      case 29: return "the machine's logic does not get its values, and what it would do is missing";
      case 20: return "the run does not wait, and the state of the machine is not simulated";
      case 26: return "no table is opened, so FN 27 and FN 28 have none";
      case 27: return "the table of the control keeps its values";
      case 28: return "it reads no table, so its parameters keep their values";
      case 37: return "parameters of the calling program keep their values";
      default: return "a parameter that it would write keeps its value";
    }
  }

  /// SYSREAD Q1 = ID270 NR1 IDX3; false where the datum is not known here.
  bool read_system(ig::Block& b, std::string_view text, std::size_t i) {
    i = skip(text, glued(text, i, "SYSREAD"));
    std::size_t end = i;
    const auto q = Values::q_at(text, i, end);
    const std::size_t equals = q ? skip(text, end) : i;
    if (!q || at(text, equals) != '=') return false;
    std::size_t next = equals + 1;
    const auto request = request_at(b, text, next);
    if (!request || skip(text, next) < text.size()) return false;
    const SystemAnswer* const answer =
        answers_ ? answers_->find({request->id, request->number, request->index.value_or(0)}) : nullptr;
    const auto value = answer != nullptr ? std::optional(answer->value) : system_.read(b, *request);
    if (answer != nullptr) {
      b.set_text(row_, answer->row);
      rows_.add(b, answer->row);
    }
    if (answer != nullptr && !answer->title.empty()) b.set_text(title_, answer->title);
    if (value) assign(b, {*q, piece(text, i, end), i, equals + 1}, *value);
    return value.has_value();
  }

  /// SYSWRITE ID50 NR1 IDX5 = +98.5; false where the datum is not known here.
  bool write_system(ig::Block& b, std::string_view text, std::size_t i) const {
    std::size_t next = skip(text, glued(text, i, "SYSWRITE"));
    const auto request = request_at(b, text, next);
    const std::size_t equals = skip(text, next);
    if (!request || at(text, equals) != '=') return false;
    const Value v = cycle_.values().read(b, text, skip(text, equals + 1));
    return v.ok && skip(text, v.end) >= text.size() && system_.write(b, *request, v.number);
  }

  /// ID50 NR1 IDX5; IDX may be left out.
  std::optional<SystemData::Request> request_at(ig::Block& b, std::string_view text, std::size_t& next) const {
    const auto number = [&](std::string_view word) -> std::optional<double> {
      const std::size_t first = skip(text, next), behind = glued(text, first, word);
      const Value v = behind == first ? Value{} : cycle_.values().read(b, text, behind);
      if (!v.ok) return std::nullopt;
      next = v.end;
      return v.number;
    };
    const auto id = number("ID"), nr = number("NR"), index = number("IDX");
    if (!id || !nr) return std::nullopt;
    return SystemData::Request{*id, *nr, index};
  }

  void error(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, glued(text, i, "ERROR"));
    if (at(text, i) == '=') i = skip(text, i + 1);
    const ParameterReader read = reader(b, text);
    const auto number = read.value(i);
    if (!number) return;
    b.report(ig::diag("HEI-0118"), read.whole(), *number);
    b.alarm();
  }

  std::size_t begin_ = 0, end_ = 0;
};

const ig::Register<KlartextParameter> klartext_parameter_syntax;

}  // namespace
}  // namespace heidenhain
