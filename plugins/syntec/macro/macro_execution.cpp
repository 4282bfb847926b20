/// Assignments, and functions that stand as statements.
#include "macro/macro_execution.hpp"

#include <algorithm>
#include <cmath>

namespace syntec {

using namespace ig::cnc;

namespace {

/// They order nothing that a run shows: no look-ahead ends here, and nothing is drawn.
constexpr std::string_view without_effect[] = {"WAIT", "SLEEP", "SETDRAW", "DRAWHOLE"};
/// Signals and files of the machine, which are not here. No variable changes by them.
constexpr std::string_view of_machine[] = {"OPEN", "CLOSE", "PRINT", "SETDO", "SETABIT", "SETRREGBIT"};

template <std::size_t N>
bool is_one_of(std::string_view name, const std::string_view (&names)[N]) {
  return std::any_of(std::begin(names), std::end(names),
                     [&](std::string_view one) { return equals_ignoring_case(name, one); });
}

}  // namespace

void MacroExecution::execute(ig::Block& b, const Statement& s) {
  environment.enter(b);
  switch (s.keyword) {
    case Keyword::assignment: return assign(b, s);
    case Keyword::function: return call(b, s);
    case Keyword::go_to: return go_to(b, s);
    default: break;
  }
  const bool is_here = arrival_frame_ == s.place.frame;
  const Arrival arrival = is_here ? std::exchange(arrival_, Arrival::none) : Arrival::none;
  const auto level = level_of(b, s, arrival);
  if (!level) return;
  switch (s.keyword) {
    case Keyword::if_: return begin_if(b, s);
    case Keyword::elseif:
      if (arrival == Arrival::branch) return begin_if(b, s);
      return to_end(b, s, *level);
    case Keyword::else_:
    case Keyword::case_label:
      if (arrival != Arrival::branch) to_end(b, s, *level);
      return;
    case Keyword::case_: return begin_case(b, s, *level);
    case Keyword::while_: return begin_while(b, s, *level);
    case Keyword::for_: return begin_for(b, s, *level, arrival);
    case Keyword::end_while:
    case Keyword::end_for:
      if (arrival != Arrival::end) jump(b, s, "OPEN", *level, Arrival::again);
      return;
    case Keyword::until:
      if (arrival != Arrival::end) end_repeat(b, s, *level);
      return;
    case Keyword::exit: return to_end(b, s, *level);
    default: return;
  }
}

std::string_view MacroExecution::written(const Statement& s) {
  constexpr std::size_t longest = 60;
  return trim(s.text.text.substr(std::min(s.begin, s.text.text.size()), longest));
}

bool MacroExecution::ends(ig::Block& b, const Statement& s, std::size_t position) {
  const std::size_t rest = skip_blanks(s.text.text, position);
  if (rest >= s.text.text.size()) return true;
  b.report(ig::diag("SYN-0021"), s.text.from(rest), trim(s.text.text.substr(rest, 60)));
  return false;
}

void MacroExecution::incomplete(ig::Block& b, const Statement& s, std::string_view missing) {
  b.report(ig::diag("SYN-0041"), s.where(), written(s), missing);
}

void MacroExecution::assign(ig::Block& b, const Statement& s) {
  const std::string_view text = s.text.text;
  MacroExpression target(b, environment, s.text, s.begin);
  const auto v = target.variable();
  if (!v) return;
  std::size_t next = skip_blanks(text, target.position());
  if (at(text, next) == ':' && at(text, next + 1) == '=')
    next += 2;
  else if (at(text, next) == '=' && at(text, next + 1) != '=')
    next += 1;
  else
    return incomplete(b, s, ":=");
  MacroExpression e(b, environment, s.text, next);
  auto value = e.value();
  if (!value || !ends(b, s, e.position())) return;
  const ig::Where where = s.text.where(s.begin, target.position());
  const double shown_value = value->shown();
  if (v->area != MacroStore::Area::local && value->is_text()) {
    if (!assign_text(b, *v, value->text, where)) return;
  } else if (!environment.write(b, *v, std::move(*value), where)) {
    return;
  }
  b.set_text(name_, name_of(*v));
  if (!std::isnan(shown_value)) b.set(value_, shown_value);
}

/// Common variables hold four characters each, the first one in the lowest byte; a zero ends the text.
bool MacroExecution::assign_text(ig::Block& b, const MacroStore::Variable& v, std::string_view text, ig::Where where) {
  const std::size_t count = text.size() / 4 + 1;
  if (!MacroEnvironment::has_room(v, count)) {
    b.report(ig::diag("SYN-0081"), where, static_cast<double>(count), name_of(v));
    return false;
  }
  MacroStore::Variable at_part = v;
  for (std::size_t i = 0;; i += 4, ++at_part.number) {
    std::uint32_t packed = 0;
    for (std::size_t k = i; k < std::min(i + 4, text.size()); ++k)
      packed |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])) << (8 * (k - i));
    if (!environment.write(b, at_part, MacroValue::whole(static_cast<std::int32_t>(packed)), where)) return false;
    if (i + 4 > text.size()) return true;
  }
}

bool MacroExecution::is_first(std::string_view name) {
  if (std::find(told_.begin(), told_.end(), name) != told_.end()) return false;
  told_.emplace_back(name);
  return true;
}

void MacroExecution::call(ig::Block& b, const Statement& s) {
  const std::string_view text = s.text.text;
  const std::size_t behind = s.behind_word();
  const std::string name = in_capitals(piece(text, s.begin, behind));
  const bool is_call = at(text, skip_blanks(text, behind)) == '(';
  const bool is_known = is_call && (is_one_of(name, without_effect) || is_one_of(name, of_machine) || name == "ALARM" ||
                                    name == "MSG" || name == "PUSH" || name == "POP");
  if (!is_known) return b.report(ig::diag("SYN-0050"), s.where(), written(s));
  MacroExpression e(b, environment, s.text, skip_blanks(text, behind));
  const auto given = e.arguments();
  if (!given || !ends(b, s, e.position())) return;
  if (name == "ALARM") return alarm(b, s, *given);
  if (name == "MSG") return message(b, s, *given);
  if (name == "PUSH") {
    constexpr std::size_t most = 10'000;
    if (given->size() != 1) return incomplete(b, s, "one value");
    if (environment.store().stack.size() >= most) return b.report(ig::diag("SYN-0029"), s.where(), written(s));
    environment.store().stack.push_back(given->front());
  } else if (name == "POP") {
    if (!given->empty()) return b.report(ig::diag("SYN-0021"), s.text.from(behind), trim(text.substr(behind, 60)));
    if (environment.store().stack.empty()) return b.report(ig::diag("SYN-0029"), s.where(), written(s));
    environment.store().stack.pop_back();
  } else if (is_one_of(name, of_machine) && is_first(name)) {
    b.report(ig::diag("SYN-0049"), s.where(), std::string_view(name));
  }
}

void MacroExecution::alarm(ig::Block& b, const Statement& s, const std::vector<MacroValue>& given) {
  if (given.empty() || given.size() > 2 || !given[0].is_number()) return incomplete(b, s, "the number");
  const std::string text = given.size() > 1 ? shown(given[1]) : std::string();
  b.report(ig::diag("SYN-0047"), s.where(), given[0].number,
           text.empty() ? std::string_view("the macro stops the program") : std::string_view(text));
  b.alarm();
}

void MacroExecution::message(ig::Block& b, const Statement& s, const std::vector<MacroValue>& given) const {
  if (given.empty() || given.size() > 2 || given.back().is_vacant()) return incomplete(b, s, "the number or the text");
  const std::string text = given.back().is_text() ? given.back().text : "message " + shown(given.back());
  b.report(ig::diag("SYN-0048"), s.where(), std::string_view(text));
}

}  // namespace syntec
