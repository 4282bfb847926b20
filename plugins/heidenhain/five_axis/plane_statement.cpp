#include "five_axis/plane_statement.hpp"

#include "language/block_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

/// The position after a keyword of a plane. A digit belongs to the keyword in P1X, but a Q after the letters begins the
/// value: SPAQ1.
std::size_t behind_plane_keyword(std::string_view text, std::size_t i, std::string_view upper) {
  const std::size_t end = i + upper.size();
  const bool is_word = equals_ignoring_case(text.substr(i).substr(0, upper.size()), upper);
  return is_word && (!is_letter(at(text, end)) || to_upper(at(text, end)) == 'Q') ? end : i;
}

bool is_complete_plane(ig::Block& b, const PlaneCommand& command) {
  const PlaneDefinition& plane = command.plane;
  if (plane.kind == PlaneDefinition::reset) return true;
  bool any = false;
  for (std::size_t k = 0; k < plane.names().size(); ++k) {
    any = any || plane.words[k];
    if (plane.words[k] || plane.takes_some()) continue;
    b.report(ig::diag("HEI-0170"), command.where(), plane.shown(), plane.names()[k]);
    return false;
  }
  if (!any)
    b.report(ig::diag("HEI-0170"), command.where(), plane.shown(),
             std::string_view(plane.kind == PlaneDefinition::axial ? "A, B or C" : "SPA, SPB or SPC"));
  return any;
}

}  // namespace

std::size_t PlaneStatement::behind_cycle_19(std::string_view text, std::size_t position) {
  const std::size_t definition = keyword(text, position, "CYCL DEF");
  if (definition == position) return position;
  std::size_t i = skip(text, definition);
  if (text.substr(std::min(i, text.size())).substr(0, 2) != "19") return position;
  i = skip_blanks(text, i + 2);
  if (at(text, i) != '.') return position;
  i = skip_blanks(text, i + 1);
  return at(text, i) == '1' && !is_digit(at(text, i + 1)) ? i + 1 : position;
}

void PlaneStatement::read_cycle(ig::Block& b, std::string_view text, std::size_t position,
                                const std::optional<ig::Vec3>& in_force, PlaneCommand& command) const {
  bool any = false, is_tilted = false;
  std::optional<ig::Where> feed_word;
  command.is_cycle = true;
  for (std::size_t i = skip(text, position); i < text.size(); i = skip(text, i)) {
    const std::size_t axis = std::string_view("ABC").find(to_upper(text[i]));
    const Value v = axis < 3 ? values_.read(b, text, i + 1) : Value{};
    if (axis < 3 && v.ok) {
      if (command.plane.words[axis]) report_repeated(b, text, i, v.end);
      command.plane.words[axis] = v.number;
      any = true;
      i = v.end;
    } else if (const std::size_t end = distance_at(b, text, i, command); end != i) {
      i = end;
    } else if (to_upper(text[i]) == 'F') {
      const std::size_t begin = i;
      i = feed_.scan(b, values_, text, i, command.is_rapid);
      feed_word = ig::Where::columns(begin, i);
    } else {
      report_not_a_word(b, text, i, "CYCL DEF 19");
      break;
    }
  }
  for (std::size_t axis = 0; axis < 3 && any; ++axis) {
    std::optional<double>& word = command.plane.words[axis];
    if (!word) word = in_force ? (*in_force)[axis] : 0;
    is_tilted = is_tilted || *word != 0;
  }
  command.plane.kind = is_tilted ? PlaneDefinition::spatial : PlaneDefinition::reset;
  const bool has_feed = command.is_rapid || feed_.word(b);
  const bool positions = command.distance_word && has_feed && cycle_positions_ == CyclePositions::positions;
  command.move = positions ? PlaneCommand::Move::move : PlaneCommand::Move::stay;
  if (positions) return;
  const bool stays = cycle_positions_ == CyclePositions::stays;
  constexpr std::string_view by_program =
      "the program positions the rotary axes, unless the option cycle-19 says otherwise";
  if (command.distance_word)
    b.report(ig::diag("HEI-0140"), *command.distance_word, std::string_view("DIST of CYCL DEF 19"),
             stays ? by_program : std::string_view("the cycle positions the rotary axes where F stands beside it"));
  else if (feed_word)
    b.report(ig::diag("HEI-0140"), *feed_word, std::string_view("F of CYCL DEF 19"),
             stays ? by_program : std::string_view("the cycle positions the rotary axes where DIST stands beside it"));
  feed_.take(b);
  command.is_rapid = false;
}

std::size_t PlaneStatement::distance_at(ig::Block& b, std::string_view text, std::size_t position,
                                        PlaneCommand& command) const {
  const std::size_t value = std::max(before_value(text, position, "DIST"), before_value(text, position, "ABST"));
  const Value v = value != position ? values_.read(b, text, value) : Value{};
  if (!v.ok) return position;
  command.distance = v.number;
  command.distance_word = ig::Where::columns(position, v.end);
  return v.end;
}

bool PlaneStatement::read(ig::Block& b, std::string_view text, std::size_t position, PlaneCommand& command) const {
  std::size_t i = skip(text, position);
  const std::size_t letters = letters_end(text, i);
  command.plane.kind = PlaneDefinition::kind_of(piece(text, i, letters));
  if (command.plane.kind == PlaneDefinition::kind_count) {
    b.report(ig::diag("HEI-0171"), command.where(), rest_of_line(text, command.begin),
             std::string_view("the plane does not change"));
    return false;
  }
  for (i = skip(text, letters); i < text.size(); i = skip(text, i)) {
    const std::size_t next = word_at(b, text, i, command);
    if (next == i) {
      report_not_a_word(b, text, i, "PLANE");
      break;
    }
    i = next;
  }
  report_idle_words(b, command);
  return is_complete_plane(b, command);
}

void PlaneStatement::report_idle_words(ig::Block& b, const PlaneCommand& command) {
  if (command.distance_word && command.move != PlaneCommand::Move::move)
    b.report(ig::diag("HEI-0140"), *command.distance_word, std::string_view("DIST of PLANE"),
             std::string_view("only with MOVE the tool turns about a point"));
  if (command.retract && !command.turns_axes())
    b.report(ig::diag("HEI-0140"), ig::Where::columns(command.retract->begin, command.retract->end),
             std::string_view("MB of PLANE"), std::string_view("the axes do not turn in this block"));
}

std::size_t PlaneStatement::angle_or_point(ig::Block& b, std::string_view text, std::size_t position,
                                           PlaneDefinition& plane) const {
  const auto read = [&](std::string_view name, std::size_t word) {
    const std::size_t value = behind_plane_keyword(text, position, name);
    const Value v = value != position ? values_.read(b, text, value) : Value{};
    if (v.ok && plane.words[word]) report_repeated(b, text, position, v.end);
    if (v.ok) plane.words[word] = v.number;
    return v.ok ? v.end : position;
  };
  const auto names = plane.names();
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const std::size_t end = read(names[k], k); end != position) return end;
  // The manuals of the iTNC write the angle of nutation in this way.
  return plane.kind == PlaneDefinition::euler ? read("EULNU", 1) : position;
}

std::size_t PlaneStatement::word_at(ig::Block& b, std::string_view text, std::size_t i, PlaneCommand& command) const {
  using Move = PlaneCommand::Move;
  if (const std::size_t end = angle_or_point(b, text, i, command.plane); end != i) return end;
  const std::size_t letters = letters_end(text, i);
  const auto is = [&](std::string_view name) { return equals_ignoring_case(piece(text, i, letters), name); };
  const auto set = [&](Move move) {
    if (command.move != Move::none) report_repeated(b, text, i, letters);
    command.move = move;
    return letters;
  };
  if (is("STAY")) return set(Move::stay);
  if (is("TURN")) return set(Move::turn);
  if (is("MOVE")) return set(Move::move);
  if (is("SEQ") || is("SYM")) {
    const std::size_t sign = skip_blanks(text, letters);
    if (at(text, sign) != '+' && at(text, sign) != '-') return i;
    if (command.sequence != 0) report_repeated(b, text, i, sign + 1);
    command.sequence = at(text, sign) == '+' ? 1 : -1;
    return sign + 1;
  }
  if (is("TABLE") || is("COORD")) {
    const std::size_t rot = keyword(text, skip(text, letters), "ROT");
    if (rot == skip(text, letters)) return i;
    command.turns_table = is("TABLE");
    return rot;
  }
  if (const std::size_t end = distance_at(b, text, i, command); end != i) return end;
  if (const std::size_t value = before_value(text, i, "MB"); value != i) {
    const Value v = values_.read(b, text, value);
    const std::size_t behind = skip(text, value), limit = keyword(text, behind, "MAX");
    if (!v.ok && limit == behind) return i;
    const std::size_t end = v.ok ? v.end : limit;
    if (!v.ok || v.number != 0)
      command.retract = PlaneCommand::Retract{v.ok ? std::optional(v.number) : std::nullopt, i, end};
    return end;
  }
  if (to_upper(text[i]) == 'F') return feed_.scan(b, values_, text, i, command.is_rapid);
  if (to_upper(text[i]) == 'M') return m_.scan(b, values_, text, i);
  return i;
}

}  // namespace heidenhain
