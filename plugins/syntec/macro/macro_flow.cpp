/// GOTO, IF, CASE and loops.
#include <cmath>

#include "macro/macro_execution.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

/// A GOTO may lead into the middle of a statement.
bool is_closing(Keyword k) {
  return k == Keyword::end_if || k == Keyword::end_case || k == Keyword::end_while || k == Keyword::end_for ||
         k == Keyword::until;
}

}  // namespace

std::optional<int> MacroExecution::level_of(ig::Block& b, const Statement& s, Arrival arrival) {
  const int level = structure.level(b, s.place);
  if (level > MacroStructure::deepest && arrival != Arrival::end) {
    b.report(ig::diag("SYN-0045"), s.where(), static_cast<double>(MacroStructure::deepest));
    b.alarm();
    if (!is_closing(s.keyword)) to_end(b, s, level);
    return std::nullopt;
  }
  if (level > 0) return level;
  std::string_view opening;
  switch (s.keyword) {
    case Keyword::elseif:
    case Keyword::end_if: opening = "IF"; break;
    case Keyword::else_: opening = "IF or CASE"; break;
    case Keyword::case_label:
    case Keyword::end_case: opening = "CASE"; break;
    case Keyword::end_while: opening = "WHILE"; break;
    case Keyword::end_for: opening = "FOR"; break;
    case Keyword::until:
    case Keyword::end_repeat: opening = s.keyword == Keyword::until ? "REPEAT" : "UNTIL"; break;
    case Keyword::exit: opening = "loop"; break;
    default: return 1;  // an opening, where nothing is indexed: a case of a page
  }
  b.report(ig::diag("SYN-0043"), s.where(), written(s), opening);
  return std::nullopt;
}

bool MacroExecution::jump(ig::Block& b, const Statement& s, std::string_view role, int level, Arrival arrival) {
  const auto search = role == "OPEN" ? ig_search{IG_SEARCH_BACKWARD} : ig_search{IG_SEARCH_FORWARD};
  const ig::Flow::Answer answer = environment.flow.jump(b, MacroStructure::named(role, level), search);
  if (answer.is_not_found()) {
    std::string_view missing = "END_IF";
    if (s.keyword == Keyword::case_ || s.keyword == Keyword::case_label) missing = "END_CASE";
    if (s.keyword == Keyword::while_) missing = "END_WHILE";
    if (s.keyword == Keyword::for_) missing = "END_FOR";
    if (s.keyword == Keyword::repeat) missing = "UNTIL";
    if (s.keyword == Keyword::exit) missing = "the end of the loop";
    b.report(ig::diag("SYN-0044"), s.where(), missing);
    b.alarm();
    return false;
  }
  arrival_ = arrival;
  arrival_frame_ = s.place.frame;
  return true;
}

std::optional<bool> MacroExecution::condition(ig::Block& b, const Statement& s, std::string_view closing) {
  const std::string_view text = s.text.text;
  const std::size_t begin = s.behind_word();
  MacroExpression e(b, environment, s.text, begin);
  const auto holds = e.truth();
  if (!holds) return std::nullopt;
  const std::size_t next = skip_blanks(text, e.position());
  const bool is_closed =
      is_word(text, next, closing) || (s.keyword == Keyword::until && is_word(text, next, "ENDREPEAT"));
  if (!is_closed) {
    if (next < text.size())
      ends(b, s, next);
    else
      incomplete(b, s, closing);
    return std::nullopt;
  }
  if (!ends(b, s, name_end(text, next))) return std::nullopt;
  environment.note_condition(b, trim(piece(text, begin, e.position())), *holds);
  return holds;
}

/// Where the condition has no value, no branch is known to be the right one: all are skipped.
void MacroExecution::begin_if(ig::Block& b, const Statement& s) {
  const int level = structure.level(b, s.place);
  const auto holds = condition(b, s, "THEN");
  if (!holds) return to_end(b, s, std::max(level, 1));
  if (!*holds) jump(b, s, "BRANCH", std::max(level, 1), Arrival::branch);
}

void MacroExecution::begin_case(ig::Block& b, const Statement& s, int level) {
  const std::string_view text = s.text.text;
  MacroExpression e(b, environment, s.text, s.behind_word());
  const auto value = e.number();
  if (!value) return to_end(b, s, level);
  const std::size_t next = skip_blanks(text, e.position());
  if (!is_word(text, next, "OF")) {
    incomplete(b, s, "OF");
    return to_end(b, s, level);
  }
  if (!ends(b, s, name_end(text, next))) return to_end(b, s, level);
  const bool is_label = *value >= 0 && *value <= largest_whole && *value == std::floor(*value);
  const std::string label =
      is_label ? MacroStructure::of_case(s.place, std::to_string(static_cast<std::int64_t>(*value))) : std::string();
  for (const std::string& one : {label, MacroStructure::of_case(s.place, "ELSE")}) {
    if (one.empty() || environment.flow.jump(b, one, IG_SEARCH_FORWARD).is_not_found()) continue;
    arrival_ = Arrival::branch;
    arrival_frame_ = s.place.frame;
    return;
  }
  to_end(b, s, level);
}

void MacroExecution::begin_while(ig::Block& b, const Statement& s, int level) {
  const auto holds = condition(b, s, "DO");
  if (!holds || !*holds) return to_end(b, s, level);
  if (!environment.flow.has_label(b, MacroStructure::named("CLOSE", level), IG_SEARCH_FORWARD))
    b.report(ig::diag("SYN-0044"), s.where(), std::string_view("END_WHILE"));
}

void MacroExecution::begin_for(ig::Block& b, const Statement& s, int level, Arrival arrival) {
  const std::string_view text = s.text.text;
  const auto refuse = [&](std::string_view missing) {
    incomplete(b, s, missing);
    to_end(b, s, level);
  };
  const std::size_t to = find_word(text, s.begin, "TO"), by = find_word(text, s.begin, "BY"),
                    close = find_word(text, s.begin, "DO");
  MacroExpression counter(b, environment, s.text, skip_blanks(text, s.behind_word()));
  const auto v = counter.variable();
  if (!v) return to_end(b, s, level);
  std::size_t first = skip_blanks(text, counter.position());
  if (at(text, first) == ':') ++first;
  if (at(text, first) != '=') return refuse(":=");
  if (to == text.size()) return refuse("TO");
  if (close == text.size()) return refuse("DO");

  const auto part = [&](std::size_t begin, std::size_t end) -> std::optional<MacroValue> {
    const MacroText until{text.substr(0, end), s.text.offset};
    MacroExpression e(b, environment, until, begin);
    auto out = e.value();
    if (!out) return std::nullopt;
    Statement piece_of = s;
    piece_of.text = until;
    if (!ends(b, piece_of, e.position())) return std::nullopt;
    if (out->is_number()) return out;
    b.report(ig::diag("SYN-0031"), until.where(begin, end), trim(piece(text, begin, end)));
    return std::nullopt;
  };
  const bool has_step = by < close;
  const auto limit = part(to + 2, has_step ? by : close);
  const auto step = !limit ? std::nullopt : has_step ? part(by + 2, close) : std::optional(MacroValue::whole(1));
  if (!step || !ends(b, s, close + 2)) return to_end(b, s, level);
  if (step->number == 0) {
    b.report(ig::diag("SYN-0055"), s.where());
    return to_end(b, s, level);
  }
  std::optional<MacroValue> value;
  const ig::Where where = s.text.where(s.begin, counter.position());
  if (arrival == Arrival::again) {
    const auto now = environment.read(b, *v, where);
    if (now && now->is_number()) {
      value = now;
      value->number += step->number;
      if (step->kind == MacroValue::Kind::real) value->kind = MacroValue::Kind::real;
      if (value->is_whole() && !is_of_32_bits(value->number)) {
        b.report(ig::diag("SYN-0033"), where, name_of(*v));
        value.reset();
      }
    } else if (now) {
      b.report(ig::diag("SYN-0031"), where, name_of(*v));
    }
  } else {
    value = part(first + 1, to);
  }
  if (!value) return to_end(b, s, level);
  const double counted = value->number;
  if (!environment.write(b, *v, std::move(*value), where)) return to_end(b, s, level);
  b.set_text(name_, name_of(*v));
  b.set(value_, counted);
  if (step->number > 0 ? counted > limit->number : counted < limit->number) return to_end(b, s, level);
  if (arrival != Arrival::again &&
      !environment.flow.has_label(b, MacroStructure::named("CLOSE", level), IG_SEARCH_FORWARD))
    b.report(ig::diag("SYN-0044"), s.where(), std::string_view("END_FOR"));
}

/// Where the condition has no value the loop ends, because nothing would end it.
void MacroExecution::end_repeat(ig::Block& b, const Statement& s, int level) {
  const auto holds = condition(b, s, "END_REPEAT");
  if (holds && !*holds) jump(b, s, "OPEN", level, Arrival::again);
}

void MacroExecution::go_to(ig::Block& b, const Statement& s) {
  const std::string_view text = s.text.text;
  const std::size_t target = skip_blanks(text, s.behind_word());
  const auto refuse = [&] {
    b.report(ig::diag("SYN-0058"), s.text.from(target), trim(text.substr(std::min(target, text.size()), 60)));
  };
  if (is_letter(at(text, target)) || target >= text.size()) return refuse();
  MacroExpression e(b, environment, s.text, target);
  const auto value = e.value();
  if (!value || !ends(b, s, e.position())) return;
  constexpr double largest = 999'999'999;
  if (!value->is_number() || !(value->number >= 0 && value->number <= largest) ||
      value->number != std::floor(value->number))
    return refuse();
  const auto number = static_cast<std::int64_t>(value->number);
  const ig::Flow::Answer answer = environment.flow.jump(b, "N" + std::to_string(number), IG_SEARCH_TOP);
  if (answer.is_not_found())
    b.report(ig::diag("SYN-0042"), s.text.from(target), static_cast<double>(number), answer.reason);
}

}  // namespace syntec
