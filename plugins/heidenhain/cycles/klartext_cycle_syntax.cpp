// CYCL DEF of cycles that wait for a call, and CYCL CALL. A cycle is identified by its number, because its name is in
// the language of the control. A definition is kept in CycleDefinition, and its Q parameters get their values.
#include "cycles/cycle_text.hpp"
#include "cycles/hole_pattern.hpp"
#include "language/block_words.hpp"
#include "language/file_name.hpp"
#include "motion/m_functions.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextCycle {
  static constexpr auto spec = ig::syntax("KlartextCycleSyntax", "CYCL DEF of cycles that are called, and CYCL CALL.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("KlartextDrillingCycleSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0168",
                     "'{0}' defines no cycle that has a number: write CYCL DEF with the number of the cycle"),
  };

  CycleText text_;
  MFunctions m_;
  CycleDefinition definition_{ig::read | ig::write};
  HolePattern pattern_{ig::write};
  ig::Out<std::int64_t> number_{"CycleDefinition.Number", {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::Out<ig::Symbol> program_{"CycleDefinition.Program", {ig::Life::modal, "", "The program that cycle 12 calls."}};
  ig::Signal said_{"CycleDefinition.~Said", ig::write, ig::Life::modal};
  ig::Signal is_open_{"CycleDefinition.~Open", ig::read | ig::write, ig::Life::modal};
  ig::In<std::int64_t> n_{"Source.N"};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::Out<bool> at_position_{"KlartextCycle.IsAtPosition",
                             {ig::Life::block, "", "CYCL CALL POS: the block goes to the point first."}};
  ig::Out<bool> modal_call_{"KlartextCycle.IsModal",
                            {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::Xyz axes_{"Parsing", ig::read | ig::write};
  ig::Out<double> way_feed_{"KlartextCycle.WayFeed",
                            {ig::Life::block, "", "F of CYCL CALL POS, for the way to its point: mm/min, or mm/rev."}};
  ig::Out<bool> way_per_revolution_{"KlartextCycle.IsWayPerRevolution", {ig::Life::block, "", "WayFeed is mm/rev."}};
  ProgramUnit unit_;
  ig::Codes motions_{{"G00", "G01"}, ig::write};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const bool is_open = b.is_raised(is_open_);
    const unsigned first = letter_index(text[position]);
    if (!is_open && first != letter_index('C') && first != letter_index('Q')) return position;
    return read(b, text, position, is_open);
  }

 private:
  [[gnu::noinline]] std::size_t read(ig::Block& b, std::string_view text, std::size_t position, bool is_open) const {
    if (!stands_first(text, position)) return position;
    const char first = to_upper(text[position]);
    if ((is_open || first == 'Q') && !b.is_in_turn()) return position;
    const std::size_t end = statement_end(text, position);
    const std::size_t definition = keyword(text, position, "CYCL DEF"), call = keyword(text, position, "CYCL CALL");
    // Listings show the parameters of a cycle on lines of their own, without block numbers.
    const bool is_alone = first == 'Q' && position == skip_blanks(text, 0) && !b.has(n_) &&
                          is_parameter_alone(text.substr(0, end), position);
    if (is_open && is_alone && !text_.values().is_indexing())
      return parameters(b, text.substr(0, end), position) == position ? position : end;
    if (is_open) b.erase(is_open_);
    if ((definition == position && call == position) || !b.is_in_turn()) return position;
    if (text_.values().is_indexing()) return end;
    if (call != position)
      read_call(b, text.substr(0, end), position, call);
    else
      return define(b, text.substr(0, end), position, definition);
    return end;
  }

  /// Returns `begin` where another syntax executes the cycle.
  std::size_t define(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    const auto number = CycleNumber::at(text, skip(text, i));
    if (!number) {
      b.report(ig::diag("HEI-0168"), where_of_line(text, begin), rest_of_line(text, begin));
      return text.size();
    }
    if (acts_where_defined(number->cycle)) return begin;
    if (number->is_first()) {
      definition_.clear(b);
      b.set(number_, static_cast<std::int64_t>(number->cycle));
      b.erase(said_);
      b.erase(program_);
      b.erase(modal_call_);
      if (!number->part) b.raise(is_open_);
      if (!waits_for_call(number->cycle))
        b.report(ig::diag("HEI-0161"), where_of_line(text, begin), static_cast<double>(number->cycle),
                 std::string_view("what it does is not known here"));
    }
    if (!number->part)
      parameters(b, text, number->end);
    else if (*number->part > 0)
      part(b, text, skip(text, i), *number);
    return text.size();
  }

  /// CYCL DEF 1.2 DEPTH -20: a part of one of the older cycles.
  void part(ig::Block& b, std::string_view text, std::size_t definition, const CycleNumber& number) const {
    const bool is_known = number.cycle == 1 || number.cycle == 2 || number.cycle == 12 || number.cycle == 17;
    const std::uint32_t most = number.cycle == 1 ? 5 : number.cycle == 2 ? 4 : number.cycle == 12 ? 1 : 3;
    if (b.get_or(number_, std::int64_t{0}) != number.cycle || (is_known && *number.part > most))
      return report_without_meaning(b, text, definition, "CYCL DEF");
    if (number.cycle == 12) return program(b, text, number.end);
    if (!is_known) return;  // reported where the cycle began
    const Value v = text_.number_behind(b, text, number.end);
    const auto where = ig::Where::columns(number.end, std::max(number.end + 1, v.ok ? v.end : text.size()));
    if (!v.ok)
      b.report(ig::diag("HEI-0104"), where, std::string_view("CYCL DEF"), std::string_view("the value"));
    else if (std::isfinite(v.number))
      definition_.set(b, *number.part, v.number);
    if (v.ok) report_rest(b, text, v.end, "CYCL DEF");
  }

  /// CYCL DEF 12.1 PGM TNC:\FOLDER\NAME.H
  void program(ig::Block& b, std::string_view text, std::size_t i) const {
    const std::size_t word = skip(text, i);
    const auto path = file_name_at(b, text_.values(), text, skip(text, keyword(text, word, "PGM")));
    if (path && !path->empty())
      b.set(program_, b.symbol(*path));
    else if (path)
      b.report(ig::diag("HEI-0104"), ig::Where::columns(i, std::max(i + 1, text.size())), std::string_view("CYCL DEF"),
               std::string_view("the name of the program"));
  }

  std::size_t parameters(ig::Block& b, std::string_view text, std::size_t position) const {
    return text_.parameters(b, text, position, b.get_or(number_, std::int64_t{0}),
                            [&](std::uint32_t q, double value) { text_.set(b, definition_, q, value); });
  }

  /// True for Q200=2 with no text after it; any other line is a formula.
  static bool is_parameter_alone(std::string_view text, std::size_t position) {
    std::size_t end = position;
    const bool is_q = Values::q_at(text, position, end).has_value();
    const std::size_t equals = skip(text, end);
    const bool has_sign = at(text, equals) == '=';
    const std::size_t first = has_sign ? skip(text, equals + 1) : equals;
    if (is_q && CycleText::is_feed_word_at(text, first)) return skip(text, letters_end(text, first)) >= text.size();
    if (!is_q || !has_sign) return false;
    std::size_t i = skip_while(text, first, [](char c) { return c == '+' || c == '-' || is_blank(c); });
    std::size_t q_end = i;
    if (Values::q_at(text, i, q_end))
      i = q_end;
    else if (const ig::Decimal d = read_number(text, i); d.ok)
      i = d.end;
    else
      return false;
    return skip(text, i) >= text.size();
  }

  // ---- CYCL CALL

  void read_call(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const std::size_t pattern = keyword(text, i, "PAT"), position = keyword(text, i, "POS");
    const QStore* const store = text_.values().store();
    if (pattern != i && (store == nullptr || store->pattern.empty())) {
      report_not_executed(b, text, begin, "the holes of the pattern are missing");
      return;
    }
    b.set(call_, true);
    if (pattern != i) pattern_.set_number(b, 0);
    bool is_rapid = false;
    const bool is_positioned = position != i;
    if (is_positioned) b.set(at_position_, true);
    const bool is_moving = is_positioned || pattern != i;
    i = std::max(position, pattern);
    const std::size_t behind = i;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t next = call_word(b, text, i, is_positioned, is_rapid);
      if (next == i) {
        report_not_a_word(b, text, i, "CYCL CALL");
        break;
      }
      i = next;
    }
    if (is_moving) put_code(b, motions_.id(is_rapid ? 0 : 1), begin, begin + 9);
    if (!is_positioned) return;
    report_missing_axes(b, begin, behind);
  }

  /// Cycle 12 leaves the way to the point to the motion of the block, which has the feed in force.
  void keep_way_feed(ig::Block& b, std::size_t begin, std::size_t end) const {
    const auto feed = text_.feed().take(b);
    if (!feed) return;
    if (!(feed->value > 0)) return b.report(ig::diag("ISO-0210"), ig::Where::columns(begin, end), feed->value);
    if (b.get_or(number_, std::int64_t{0}) == 12)
      return b.report(ig::diag("HEI-0140"), ig::Where::columns(begin, end), std::string_view("F of CYCL CALL POS"),
                      std::string_view("cycle 12 goes to its point with the feed rate in force"));
    b.set(way_feed_, feed->is_per_revolution ? feed->value : feed->value * unit_.in_mm(b));
    b.set(way_per_revolution_, feed->is_per_revolution);
  }

  /// The manual wants all three: without one the tool stays where it is in that axis.
  void report_missing_axes(ig::Block& b, std::size_t begin, std::size_t end) const {
    std::string missing;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!b.has(axes_.id(axis))) missing.append(missing.empty() ? "" : " ").push_back(axis_letters[axis]);
    if (!missing.empty())
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, end), std::string_view("CYCL CALL POS"),
               std::string_view(missing));
  }

  std::size_t call_word(ig::Block& b, std::string_view text, std::size_t i, bool is_positioned, bool& is_rapid) const {
    const char c = to_upper(text[i]);
    if (c == 'M') return m_.scan(b, text_.values(), text, i);
    if (c == 'F') {
      const std::size_t end = text_.feed().scan(b, text_.values(), text, i, is_rapid);
      if (is_positioned) keep_way_feed(b, i, end);
      return end;
    }
    const std::size_t axis = std::string_view("XYZ").find(c);
    if (axis > 2 || !is_positioned) return i;
    const Value v = text_.values().read(b, text, i + 1);
    if (!v.ok) return i;
    if (b.has(axes_.id(axis))) report_repeated(b, text, i, v.end);
    put_word(b, axes_.id(axis), i, v.end, v.number);
    return v.end;
  }
};

const ig::Register<KlartextCycle> klartext_cycle_syntax;

}  // namespace
}  // namespace heidenhain
