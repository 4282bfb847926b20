// What each M function of Klartext does here.
#include "motion/m_functions.hpp"

#include <charconv>

#include <isogloss/cnc/program_name.hpp>

#include "language/block_words.hpp"
#include "motion/m_not_executed.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr std::uint32_t most_m = 999, most_m_of_builder = 99'999;

/// The position after the words of an M function, which end at the next M, R0, RL, RR or F (M103 has an F of its
/// own).
std::size_t behind_words(std::string_view text, std::size_t position, bool has_feed) {
  const std::size_t last = statement_end(text, position);
  for (std::size_t i = skip(text, position); i < last; i = skip(text, word_end(text, i))) {
    const char c = to_upper(text[i]), d = to_upper(at(text, i + 1));
    const bool is_side = c == 'R' && (d == '0' || d == 'L' || d == 'R');
    if (is_side || (c == 'F' && !has_feed) || (c == 'M' && (is_digit(d) || d == 'Q'))) return i;
  }
  return last;
}

/// F of M128 limits the speed of the axes and changes no path. Its value is read nevertheless, because its parameter
/// may have none, which is reported.
std::size_t behind_m128_feed(ig::Block& b, const Values& values, std::string_view text, std::size_t end) {
  const std::size_t feed = skip(text, end);
  if (to_upper(at(text, feed)) != 'F') return end;
  const std::size_t word = word_end(text, feed);
  for (const std::string_view name : {"FMAX", "FAUTO"})
    if (equals_ignoring_case(piece(text, feed, word), name)) return word;
  const Value v = values.read(b, text, skip(text, feed + 1));
  if (v.ok) return v.end;
  b.report(ig::diag("HEI-0104"), ig::Where::columns(feed, word), std::string_view("M128"), piece(text, feed, word));
  return word;
}

}  // namespace

MFunctions::MFunctions() {
  for (std::size_t i = 0; i < codes_.size(); ++i) {
    std::string_view name = codes_.path(i);
    for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
      if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    std::uint32_t number = 0;
    if (name.size() < 3 || name[0] != 'M') continue;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (error != std::errc{} || end != name.data() + name.size() || number > most_m) continue;
    if (table_.size() <= number) table_.resize(number + 1, IG_NO_FIELD);
    table_[number] = codes_.id(i);
  }
}

std::size_t MFunctions::scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position) const {
  const std::size_t digits = skip_blanks(text, position + 1);
  const Value v = values.read(b, text, digits);
  // M alone is a prompt that was not answered; MB 5 is not.
  if (!v.ok) return is_letter(at(text, position + 1)) ? position : position + 1;
  const std::size_t end = at(text, v.end) == '.' ? v.end + 1 : v.end;
  const double rounded = std::round(v.number);
  if (values.is_indexing()) return end;
  const bool is_code = rounded >= 0 && rounded <= most_m_of_builder && rounded == v.number;
  const Function m{is_code ? static_cast<std::uint32_t>(rounded) : 0, position, end};
  const NumberedName name('M', m.number);
  const ig_machine_code* row = is_code ? machine_.find(name.text()) : nullptr;
  if (row == nullptr && is_code && !knows(m.number)) row = machine_.family(name.text());
  if (row != nullptr) return b.is_in_turn() ? of_builder(b, values, text, m, *row) : end;
  if (is_code && m.number <= most_m) return act(b, values, text, m);
  leave(b, IG_LEFT_UNKNOWN, piece(text, position, end), position, end);
  return end;
}

bool MFunctions::knows(std::uint32_t m) const {
  for (const std::uint32_t own :
       {13u, 14u, 89u, 91u, 92u, 94u, 99u, 109u, 110u, 111u, 126u, 127u, 128u, 129u, 136u, 137u, 140u})
    if (m == own) return true;
  for (const NotExecuted& known : not_executed)
    if (m == known.number) return true;
  return m < table_.size() && table_[m] != IG_NO_FIELD;
}

std::size_t MFunctions::of_builder(ig::Block& b, const Values& values, std::string_view text, const Function& m,
                                   const ig_machine_code& row) const {
  record_.add(b, row, ig::Where::columns(m.begin, m.end), piece(text, m.begin, m.end));
  std::size_t end = m.end;
  for_each_code(row, [&](std::string_view code) { end = std::max(end, put(b, values, text, code, m.begin, m.end)); });
  return end;
}

std::size_t MFunctions::put(ig::Block& b, const Values& values, std::string_view text, std::string_view code,
                            std::size_t begin, std::size_t end) const {
  const auto number = whole_number_of_code(code);
  if (code[0] == 'M' && number && *number <= most_m) return act(b, values, text, {*number, begin, end});
  leave(b, IG_LEFT_UNKNOWN, code, begin, end);
  return end;
}

std::size_t MFunctions::retract(ig::Block& b, const Values& values, std::string_view text, const Function& m) const {
  const std::size_t first = skip(text, m.end), by = before_value(text, first, "MB"), value = skip(text, by);
  const std::size_t limit = by == first ? first : keyword(text, value, "MAX");
  std::size_t behind = limit;
  if (by != first && limit != value) {
    b.set(to_limit_, true);
  } else if (const Value v = by == first ? Value{} : values.read(b, text, value); v.ok) {
    put_word(b, distance_.id(), m.begin, v.end, v.number);
    behind = v.end;
  } else {
    b.report(ig::diag("HEI-0104"), ig::Where::columns(m.begin, m.end), std::string_view("M140"),
             std::string_view("MB"));
    return m.end;
  }
  const std::size_t feed = skip(text, behind);
  if (to_upper(at(text, feed)) != 'F') return behind;
  const std::size_t feed_end = word_end(text, feed);
  if (!equals_ignoring_case(piece(text, feed, feed_end), "FMAX"))
    b.report(ig::diag("HEI-0140"), ig::Where::columns(m.begin, feed_end), piece(text, feed, feed_end),
             std::string_view("M140 retracts by rapid"));
  return feed_end;
}

std::size_t MFunctions::execute(ig::Block& b, const Values& values, std::string_view text, const Function& m) const {
  const auto where = ig::Where::columns(m.begin, m.end);
  const std::string_view name = trim(piece(text, m.begin, m.end));
  switch (m.number) {
    case 13:
    case 14:
      code(b, {m.number == 13 ? 3u : 4u, m.begin, m.end});
      code(b, {8, m.begin, m.end});
      return m.end;
    case 89:
      b.set(modal_call_, true);
      b.set(call_, true);
      return m.end;
    case 99:
      b.erase(modal_call_);
      b.set(call_, true);
      return m.end;
    case 91: put_code(b, g53_.id(0), m.begin, m.end); return m.end;
    case 92: name_datum(b, values, m); return m.end;
    case 94: return reduce(b, text, m);
    case 109: b.set(feed_on_arcs_, b.symbol("Contour")); return m.end;
    case 110: b.set(feed_on_arcs_, b.symbol("ContourInside")); return m.end;
    case 111: b.erase(feed_on_arcs_); return m.end;
    case 126:
    case 127: b.set(rotary_path_, b.symbol(m.number == 126 ? "M126" : "M127")); return m.end;
    case 128: lead_tip(b, m); return behind_m128_feed(b, values, text, m.end);
    case 129:  // without a preceding M128 the length stays as TOOL CALL set it
      if (b.is(length_term_, led_) || b.is(length_term_, led_by_direction_))
        put_code(b, length_.code(0), m.begin, m.end);
      return m.end;
    case 136:
      b.raise(per_revolution_);
      put_code(b, feed_modes_.id(1), m.begin, m.end);
      return m.end;
    case 137:
      b.erase(per_revolution_);
      put_code(b, feed_modes_.id(0), m.begin, m.end);
      return m.end;
    default: break;
  }
  for (const NotExecuted& known : not_executed)
    if (known.number == m.number) {
      const std::size_t words = skip(text, m.end);
      const bool is_end = m.number == 138 && behind_words(text, m.end, false) <= words;  // of M138 A C
      if (known.severity != IG_NOTE && !is_end)
        b.report(known.severity == IG_ERROR ? ig::diag("HEI-0139") : ig::diag("HEI-0140"), where, name,
                 std::string_view(known.effect));
      return known.has_words ? behind_words(text, m.end, m.number == 103) : m.end;
    }
  code(b, m);
  return m.end;
}

std::size_t MFunctions::reduce(ig::Block& b, std::string_view text, const Function& m) const {
  const std::size_t axis_word = skip(text, m.end);
  const bool is_letter_alone = word_end(text, axis_word) == axis_word + 1;
  const std::size_t named = is_letter_alone ? std::string_view("ABC").find(to_upper(at(text, axis_word))) : 3;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((named > 2 || named == axis) && axes_.has(axis) && axes_.rollover(axis) == Rollover::counts_on) {
      b.report(ig::diag("HEI-0139"), ig::Where::columns(m.begin, m.end), std::string_view("M94"),
               std::string_view("the rotary axes keep what they have counted beyond 360"));
      break;
    }
  return named > 2 ? m.end : axis_word + 1;
}

void MFunctions::name_datum(ig::Block& b, const Values& values, const Function& m) const {
  if (!b.is_in_turn()) return;
  bool is_known = false;
  for (std::uint32_t axis = 0; axis < axis_letters.size(); ++axis)
    is_known = is_known || axis_names_.position(axis, IG_AXIS_DATUM);
  QStore* const store = values.store();
  if (is_known)
    b.set(from_datum_, true);
  else if (store == nullptr || store->is_first_time(175, ""))
    b.report(ig::diag("HEI-0175"), ig::Where::columns(m.begin, m.end));
  put_code(b, g53_.id(0), m.begin, m.end);
}

void MFunctions::lead_tip(ig::Block& b, const Function& m) const {
  put_code(b, tcp_.code(0), m.begin, m.end);
  if (!b.has(offset_id_)) put_code(b, tcp_.word(0, 'H'), m.begin, m.end);
}

void MFunctions::code(ig::Block& b, const Function& m) const {
  if (m.number < table_.size() && table_[m.number] != IG_NO_FIELD) return put_code(b, table_[m.number], m.begin, m.end);
  std::array<char, 8> name{'M', '0'};
  char* const last = std::to_chars(name.data() + (m.number < 10 ? 2 : 1), name.data() + name.size(), m.number).ptr;
  leave(b, IG_LEFT_UNKNOWN, {name.data(), static_cast<std::size_t>(last - name.data())}, m.begin, m.end);
}

}  // namespace heidenhain
