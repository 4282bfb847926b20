// Q parameters: FN 0 to FN 8 and FN 13 assign, FN 9 to FN 12 jump to a label, FN 18 reads, Q1 = … is a formula. The
// scanner reads the statement as a whole; build() executes it, after everything before it in the block.
#include <isogloss/cnc/units.hpp>

#include "cycles/cycle_text.hpp"
#include "language/system_data.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextParameter {
  static constexpr auto spec = ig::syntax("KlartextParameterSyntax", "FN functions and formulas with Q parameters.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .scans("FQfq");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0116", "'{0}' is not executed: string parameters are not supported"),
      ig::diagnostic(IG_ERROR, "HEI-0117", "FN {0} is not executed: a parameter that it would write keeps its value"),
      ig::diagnostic(IG_ERROR, "HEI-0118", "the program stops the control here with error {0} (FN 14)"),
  };

  CycleText cycle_;
  SystemData system_;
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
      default: {
        const std::string_view whole = trim(piece(text, begin_, end_));
        b.report(ig::diag("HEI-0116"), ig::Where::columns(begin_, begin_ + whole.size()), whole);
      }
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
    if (to_upper(at(text, position + 1)) == 'S' && is_digit(at(text, position + 2))) return Kind::text;
    std::size_t end = position;
    return Values::q_at(text, position, end) ? Kind::formula : Kind::none;
  }

  ig::Where from(std::string_view text, std::size_t position) const {
    return ig::Where::columns(position, std::max(position + 1, text.size()));
  }

  /// A Q parameter at `position` and the = after it.
  struct Target {
    QNumber q;
    std::string_view name;
    std::size_t begin, after;
  };
  std::optional<Target> target(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t end = position;
    const auto q = Values::q_at(text, position, end);
    const std::size_t equals = q ? skip(text, end) : position;
    if (!q) {
      if (to_upper(at(text, position)) == 'Q' && to_upper(at(text, position + 1)) == 'S')
        b.report(ig::diag("HEI-0116"), from(text, begin_), rest_of_line(text, begin_));
      else
        b.report(ig::diag("HEI-0119"), from(text, begin_), std::string_view("the Q parameter"));
      return std::nullopt;
    }
    if (at(text, equals) != '=') {
      b.report(ig::diag("HEI-0119"), from(text, begin_), std::string_view("="));
      return std::nullopt;
    }
    return Target{*q, piece(text, position, end), position, equals + 1};
  }

  void assign(ig::Block& b, const Target& t, double value) {
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
    const std::size_t i = index_of_parameter(q);
    if (q < 200 || i >= cycle_parameters.size() || b.get_or(cycle_number_, std::int64_t{0}) < 200) return;
    const double metric = cycle_.metric(b, cycle_parameters[i].unit, value);
    if (std::isfinite(metric)) definition_.set(b, q, metric);
  }

  void formula(ig::Block& b, std::string_view text) {
    const auto t = target(b, text, begin_);
    if (!t) return;
    const std::size_t first = skip(text, t->after);
    if (at(text, first) == '"' || (to_upper(at(text, first)) == 'Q' && to_upper(at(text, first + 1)) == 'S')) {
      b.report(ig::diag("HEI-0116"), from(text, begin_), rest_of_line(text, begin_));
      return;
    }
    if (const auto value = cycle_.values().formula(b, text, t->after, end_)) assign(b, *t, *value);
  }

  // ---- FN

  void function(ig::Block& b, std::string_view text) {
    const std::size_t digits = skip_blanks(text, begin_ + 2);
    const std::size_t end = skip_digits(text, digits);
    unsigned number = 99;
    std::from_chars(text.data() + digits, text.data() + end, number);
    std::size_t i = skip(text, end);
    if (at(text, i) == ':') i = skip(text, i + 1);
    if (number <= 8 || number == 13) return compute(b, text, i, number);
    if (number <= 12) return jump(b, text, i, number);
    if (number == 14) return error(b, text, i);
    const std::string_view whole = rest_of_line(text, begin_);
    if (number == 15 || number == 16 || number == 38) return;  // output: no position depends on it
    if (number == 18 && read_system(b, text, i)) return;
    // Reported once for each datum that FN 18 reads, and once for each of the other functions.
    QStore* const store = cycle_.values().store();
    const std::size_t equals = number == 18 ? whole.find('=') : std::string_view::npos;
    const std::string_view kind = equals == std::string_view::npos ? whole.substr(0, i - begin_) : whole.substr(equals);
    if (store != nullptr && !store->is_first_time(117, kind)) return;
    b.report(ig::diag("HEI-0117"), ig::Where::columns(begin_, begin_ + whole.size()), double(number));
  }

  /// A value at `i`, which moves past it; reported where there is none.
  std::optional<double> value(ig::Block& b, std::string_view text, std::size_t& i) const {
    i = skip(text, i);
    const Value v = cycle_.values().read(b, text, i);
    if (v.ok) {
      i = v.end;
      return v.number;
    }
    const std::size_t end = skip_while(text, i, [](char c) { return !is_space(c); });
    if (i >= text.size())
      b.report(ig::diag("HEI-0119"), from(text, begin_), std::string_view("a value"));
    else
      b.report(ig::diag("HEI-0110"), ig::Where::columns(i, end), piece(text, i, end));
    return std::nullopt;
  }
  bool ends(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, i);
    if (i >= text.size()) return true;
    const std::string_view rest = rest_of_line(text, i);
    b.report(ig::diag("HEI-0110"), ig::Where::columns(i, i + rest.size()), rest);
    return false;
  }

  /// The position after the operator between the two operands; a sign of the second one may follow.
  static std::size_t operation(std::string_view text, std::size_t i, unsigned number) {
    i = skip(text, i);
    if (number == 1) return at(text, i) == '+' ? i + 1 : i;
    if (number == 2) return at(text, i) == '-' ? i + 1 : i;
    if (number == 3) return at(text, i) == '*' ? i + 1 : i;
    const std::string_view word = number == 4 ? "DIV" : number == 8 ? "LEN" : "ANG";
    if (number == 4 && at(text, i) == '/') return i + 1;
    std::size_t end = i;
    for (const char c : word) end = to_upper(at(text, end)) == c ? end + 1 : text.size() + 1;
    return end <= text.size() ? end : i;
  }

  void compute(ig::Block& b, std::string_view text, std::size_t i, unsigned number) {
    const auto t = target(b, text, i);
    if (!t) return;
    i = skip(text, t->after);
    if (number >= 5 && number <= 7) {
      const std::string_view word = number == 5 ? "SQRT" : number == 6 ? "SIN" : "COS";
      for (const char c : word) i += to_upper(at(text, i)) == c ? 1 : 0;
    }
    const auto left = value(b, text, i);
    if (!left) return;
    double result = *left;
    if (number == 5) result = std::sqrt(*left);
    if (number == 6) result = std::sin(*left * radians_per_degree);
    if (number == 7) result = std::cos(*left * radians_per_degree);
    if (number != 0 && (number < 5 || number > 7)) {
      const std::size_t behind = operation(text, i, number);
      if (behind == i || skip(text, i) == behind) {
        b.report(ig::diag("HEI-0119"), from(text, begin_), std::string_view("the operator"));
        return;
      }
      i = behind;
      const auto right = value(b, text, i);
      if (!right) return;
      switch (number) {
        case 1: result = *left + *right; break;
        case 2: result = *left - *right; break;
        case 3: result = *left * *right; break;
        case 4: result = *left / *right; break;
        case 8: result = std::hypot(*left, *right); break;
        default: {
          result = std::atan2(*left, *right) / radians_per_degree;
          if (result < 0) result += 360;
        }
      }
    }
    if (ends(b, text, i)) assign(b, *t, result);
  }

  /// SYSREAD Q1 = ID270 NR1 IDX3; false where the datum is not known here.
  bool read_system(ig::Block& b, std::string_view text, std::size_t i) {
    i = skip(text, glued(text, i, "SYSREAD"));
    std::size_t end = i;
    const auto q = Values::q_at(text, i, end);
    const std::size_t equals = q ? skip(text, end) : i;
    if (!q || at(text, equals) != '=') return false;
    SystemData::Request request;
    std::size_t next = equals + 1;
    const auto number = [&](std::string_view word) -> std::optional<double> {
      const std::size_t first = skip(text, next), behind = glued(text, first, word);
      const Value v = behind == first ? Value{} : cycle_.values().read(b, text, behind);
      if (!v.ok) return std::nullopt;
      next = v.end;
      return v.number;
    };
    const auto id = number("ID"), nr = number("NR");
    request.index = number("IDX");
    if (!id || !nr || skip(text, next) < text.size()) return false;
    request.id = *id;
    request.number = *nr;
    const auto value = system_.read(b, request);
    if (value) assign(b, {*q, piece(text, i, end), i, equals + 1}, *value);
    return value.has_value();
  }

  /// Whether Q1 IS DEFINED or Q1 IS UNDEFINED holds; nothing where another condition is there.
  std::optional<bool> definedness(ig::Block& b, std::string_view text, std::size_t& next) const {
    std::size_t i = skip(text, next), end = i;
    if (at(text, i) == '+') ++i;
    const auto q = Values::q_at(text, i, end);
    const std::size_t is = skip(text, end), word = skip(text, keyword(text, is, "IS"));
    if (!q || word == is) return std::nullopt;
    const std::size_t defined = keyword(text, word, "DEFINED"), undefined = keyword(text, word, "UNDEFINED");
    if (defined == word && undefined == word) return std::nullopt;
    next = std::max(defined, undefined);
    return cycle_.values().has(b, *q) == (defined != word);
  }

  /// IF +Q1 EQU +5 GOTO LBL 3, IF Q1 IS UNDEFINED GOTO LBL 3
  void jump(ig::Block& b, std::string_view text, std::size_t i, unsigned number) const {
    static constexpr std::array<std::string_view, 4> comparisons{"EQU", "NE", "GT", "LT"};
    const auto missing = [&](std::string_view what) { b.report(ig::diag("HEI-0119"), from(text, begin_), what); };
    std::size_t next = glued(text, i, "IF");
    if (next == i) return missing("IF");
    auto holds = number == 9 ? definedness(b, text, next) : std::nullopt;
    if (!holds) {
      const auto left = value(b, text, next);
      if (!left) return;
      i = skip(text, next);
      next = glued(text, i, comparisons[number - 9]);
      if (next == i) return missing(comparisons[number - 9]);
      const auto right = value(b, text, next);
      if (!right) return;
      holds = number == 9    ? same(*left, *right)
              : number == 10 ? !same(*left, *right)
              : number == 11 ? *left > *right
                             : *left < *right;
    }
    i = skip(text, next);
    next = glued(text, i, "GOTO");
    if (next == i) return missing("GOTO LBL");
    i = skip(text, next);
    next = glued(text, i, "LBL");
    if (next == i) return missing("LBL");
    i = skip(text, next);
    std::size_t end = i;
    std::string name = read_name(text, i, end);
    if (name.empty()) return missing("the label");
    if (!ends(b, text, end)) return;
    if (!*holds) return;
    const ig::Flow::Answer answer = cycle_.values().flow().jump(b, "L" + name, IG_SEARCH_TOP);
    if (answer.is_not_found())
      b.report(ig::diag("HEI-0120"), ig::Where::columns(i, end), std::string_view(name), answer.reason);
  }
  /// True for values that the control's display shows as equal.
  static bool same(double left, double right) {
    return std::fabs(left - right) <= 1e-9 * std::fmax(1, std::fabs(left));
  }

  /// The position after a word that a sign, a number or a letter may follow directly.
  static std::size_t glued(std::string_view text, std::size_t i, std::string_view upper) {
    std::size_t end = i;
    for (const char c : upper) {
      if (to_upper(at(text, end)) != c) return i;
      ++end;
    }
    return end;
  }

  void error(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, glued(text, i, "ERROR"));
    if (at(text, i) == '=') i = skip(text, i + 1);
    const auto number = value(b, text, i);
    if (!number) return;
    b.report(ig::diag("HEI-0118"), from(text, begin_), *number);
    b.alarm();
  }

  std::size_t begin_ = 0, end_ = 0;
};

const ig::Register<KlartextParameter> klartext_parameter_syntax;

}  // namespace
}  // namespace heidenhain
