/// M functions, which may stand in any block: those that ISO has as well become its codes, the others are executed here
/// or reported.
#pragma once

#include <charconv>
#include <vector>

#include <isogloss/cnc/rotary_axis.hpp>

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of each syntax whose blocks hold M functions.
class MFunctions {
 public:
  MFunctions() {
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      std::string_view name = codes_.path(i);
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      std::uint32_t number = 0;
      if (name.size() < 3 || name[0] != 'M') continue;
      const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
      if (error != std::errc{} || end != name.data() + name.size() || number > most) continue;
      if (table_.size() <= number) table_.resize(number + 1, IG_NO_FIELD);
      table_[number] = codes_.id(i);
    }
  }

  /// Reads the M at `position`; returns the position after it and after the words that belong to it.
  std::size_t scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position) const {
    const std::size_t digits = skip_blanks(text, position + 1);
    const Value v = values.read(b, text, digits);
    if (!v.ok) return position + 1;  // M alone: the prompt was not answered
    const std::size_t end = at(text, v.end) == '.' ? v.end + 1 : v.end;
    const double rounded = std::round(v.number);
    if (values.is_indexing()) return end;
    if (!(rounded >= 0 && rounded <= most) || rounded != v.number) {
      leave(b, IG_LEFT_UNKNOWN, piece(text, position, end), position, end);
      return end;
    }
    if (rounded == 140) return retract(b, values, text, position, end);
    return set(b, values, text, static_cast<std::uint32_t>(rounded), position, end);
  }

  /// The block holds M140 MB.
  bool retracts(const ig::Block& b) const { return b.has(to_limit_) || b.has(distance_); }

 private:
  static constexpr std::uint32_t most = 999;

  /// M140 MB 50, M140 MB MAX: a retract along the tool axis. An F of its own may follow.
  std::size_t retract(ig::Block& b, const Values& values, std::string_view text, std::size_t begin,
                      std::size_t end) const {
    const std::size_t first = skip(text, end), by = keyword(text, first, "MB"), value = skip(text, by);
    const std::size_t limit = by == first ? first : keyword(text, value, "MAX");
    std::size_t behind = limit;
    if (by != first && limit != value) {
      b.set(to_limit_, true);
    } else if (const Value v = by == first ? Value{} : values.read(b, text, value); v.ok) {
      const ig_word word{distance_.id(), column(begin), column(v.end), {.number = v.number}, 0, 0};
      b.set_word(word);
      behind = v.end;
    } else {
      b.report(ig::diag("HEI-0104"), ig::Where::columns(begin, end), std::string_view("M140"), std::string_view("MB"));
      return end;
    }
    const std::size_t feed = skip(text, behind);
    if (to_upper(at(text, feed)) != 'F') return behind;
    const std::size_t feed_end = word_end(text, feed);
    if (!equals_ignoring_case(piece(text, feed, feed_end), "FMAX"))
      b.report(ig::diag("HEI-0140"), ig::Where::columns(begin, feed_end), piece(text, feed, feed_end),
               std::string_view("M140 retracts by rapid"));
    return feed_end;
  }

  /// F of M128 limits the speed of the axes and changes no path. Its value is read nevertheless, because its parameter
  /// may have none, which is reported.
  static std::size_t behind_feed(ig::Block& b, const Values& values, std::string_view text, std::size_t end) {
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

  std::size_t set(ig::Block& b, const Values& values, std::string_view text, std::uint32_t number, std::size_t begin,
                  std::size_t end) const {
    const auto where = ig::Where::columns(begin, end);
    const std::string_view name = trim(piece(text, begin, end));
    switch (number) {
      case 13:
      case 14:
        code(b, number == 13 ? 3 : 4, begin, end);
        code(b, 8, begin, end);
        return end;
      case 89:
        b.set(modal_call_, true);
        b.set(call_, true);
        return end;
      case 99:
        b.erase(modal_call_);
        b.set(call_, true);
        return end;
      case 91: flag(b, g53_.id(0), begin, end); return end;
      case 92:
        if (QStore* const s = values.store(); s == nullptr || s->is_first_time(175, ""))
          b.report(ig::diag("HEI-0175"), where);
        flag(b, g53_.id(0), begin, end);
        return end;
      case 94: return reduce(b, text, begin, end);
      case 126:
      case 127: b.set(rotary_path_, b.symbol(number == 126 ? "M126" : "M127")); return end;
      case 128: lead_tip(b, begin, end); return behind_feed(b, values, text, end);
      case 129:  // without a preceding M128 the length stays as TOOL CALL set it
        if (b.is(length_term_, led_)) flag(b, length_.code(0), begin, end);
        return end;
      case 136:
        b.raise(per_revolution_);
        flag(b, feed_modes_.id(1), begin, end);
        return end;
      case 137:
        b.erase(per_revolution_);
        flag(b, feed_modes_.id(0), begin, end);
        return end;
      default: break;
    }
    for (const Said& s : said)
      if (s.number == number) {
        const std::size_t rest = s.has_words ? behind_words(text, end, number == 103) : end;
        if (s.severity != IG_NOTE)
          b.report(s.severity == IG_ERROR ? ig::diag("HEI-0139") : ig::diag("HEI-0140"), where, name,
                   std::string_view(s.effect));
        return rest;
      }
    code(b, number, begin, end);
    return end;
  }

  /// M94 and M94 C: removes whole turns from the display of the axes. Axes without limits do not move.
  std::size_t reduce(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) const {
    const std::size_t rest = behind_words(text, end, false);
    const std::size_t named = std::string_view("ABC").find(to_upper(at(text, skip(text, end))));
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named > 2 || named == axis) && axes_.has(axis) && axes_.rollover(axis) == Rollover::counts_on) {
        b.report(ig::diag("HEI-0139"), ig::Where::columns(begin, end), std::string_view("M94"),
                 std::string_view("the rotary axes keep what they have counted beyond 360"));
        break;
      }
    return rest;
  }

  /// Without a TOOL CALL before it the tool in the spindle is used; its length is not known.
  void lead_tip(ig::Block& b, std::size_t begin, std::size_t end) const {
    flag(b, tcp_.code(0), begin, end);
    if (!b.has(offset_id_)) flag(b, tcp_.word(0, 'H'), begin, end);
  }

  /// The position after the words of an M function, which end at the next M, R0, RL, RR or F (M103 has an F of its
  /// own).
  static std::size_t behind_words(std::string_view text, std::size_t position, bool has_feed) {
    const std::size_t last = statement_end(text, position);
    for (std::size_t i = skip(text, position); i < last; i = skip(text, word_end(text, i))) {
      const char c = to_upper(text[i]), d = to_upper(at(text, i + 1));
      const bool is_side = c == 'R' && (d == '0' || d == 'L' || d == 'R');
      if (is_side || (c == 'F' && !has_feed) || (c == 'M' && (is_digit(d) || d == 'Q'))) return i;
    }
    return last;
  }

  void code(ig::Block& b, std::uint32_t number, std::size_t begin, std::size_t end) const {
    if (number < table_.size() && table_[number] != IG_NO_FIELD) return flag(b, table_[number], begin, end);
    std::array<char, 8> name{'M', '0'};
    char* const last = std::to_chars(name.data() + (number < 10 ? 2 : 1), name.data() + name.size(), number).ptr;
    leave(b, IG_LEFT_UNKNOWN, {name.data(), static_cast<std::size_t>(last - name.data())}, begin, end);
  }
  static void flag(ig::Block& b, ig_field field, std::size_t begin, std::size_t end) {
    const ig_word word{field, column(begin), column(end), ig_value{}, 0, 0};
    b.set_word(word);
  }
  static std::size_t word_end(std::string_view text, std::size_t position) {
    return skip_while(text, position, [](char c) { return !is_space(c) && c != ';'; });
  }

  struct Said {
    std::uint32_t number;
    ig_severity severity;  // a note: nothing is reported, because nothing changes
    bool has_words;
    const char* effect;
  };
  static constexpr std::array said{
      Said{90, IG_NOTE, false, ""},
      Said{101, IG_NOTE, true, ""},
      Said{102, IG_NOTE, false, ""},
      Said{105, IG_NOTE, false, ""},
      Said{106, IG_NOTE, false, ""},
      Said{112, IG_NOTE, true, ""},
      Said{113, IG_NOTE, false, ""},
      Said{150, IG_NOTE, false, ""},
      Said{107, IG_NOTE, false, ""},
      Said{108, IG_NOTE, false, ""},
      Said{141, IG_NOTE, false, ""},
      Said{148, IG_NOTE, false, ""},
      Said{149, IG_NOTE, false, ""},
      Said{97, IG_WARNING, false, "it has a meaning with RL and RR only"},
      Said{98, IG_WARNING, false, "it has a meaning with RL and RR only"},
      Said{103, IG_WARNING, true, "plunging has the feed in force"},
      Said{109, IG_WARNING, false, "the feed on arcs is that of the tool's centre"},
      Said{110, IG_WARNING, false, "the feed on arcs is that of the tool's centre"},
      Said{111, IG_NOTE, false, ""},
      Said{114, IG_ERROR, false, "X Y Z do not follow the rotary axes"},
      Said{115, IG_NOTE, false, ""},
      Said{116, IG_WARNING, false, "the feed of rotary axes counts degrees"},
      Said{117, IG_NOTE, false, ""},
      Said{118, IG_WARNING, true, "the handwheel moves nothing here"},
      Said{120, IG_WARNING, true, "it has a meaning with RL and RR only"},
      Said{124, IG_WARNING, true, "no point of the path is left out"},
      Said{130, IG_ERROR, false, "the words of the block are positions in the tilted plane"},
      Said{134, IG_NOTE, false, ""},
      Said{135, IG_NOTE, false, ""},
      Said{138, IG_ERROR, true, "all rotary axes take part in tilting"},
      Said{144, IG_ERROR, false, "positions do not follow the rotary axes"},
      Said{145, IG_NOTE, false, ""},
  };

  ig::Fields codes_{"codes", "Parsing.Flags.* Parsing.*", ig::write, "The codes that syntaxes of this chain know.",
                    IG_CODE};
  std::vector<ig_field> table_;
  ig::Codes g53_{{"G53"}, ig::write};
  ig::Out<bool> to_limit_{"KlartextPath.RetractsToLimit",
                          {ig::Life::block, "", "M140 MB MAX: along the tool axis to the end of the travel."}};
  ig::Field<double> distance_{
      "Parsing.MB", ig::read | ig::write, {ig::Life::word, "mm", "M140 MB: how far along the tool axis."}};
  ig::Codes feed_modes_{{"G94", "G95"}, ig::write};
  ig::Call tcp_{{"G43.4"}, "H[]", ig::write};
  ig::Previous<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Call length_{{"G43"}, "", ig::write};
  ig::Previous<ig::Symbol> length_term_{"ToolHeightCompensation.Term"};
  ig::Name led_{"G43.4"};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::Out<bool> modal_call_{"KlartextCycle.IsModal",
                            {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::Out<ig::Symbol> rotary_path_{"RotaryPath.Term",
                                   {ig::Life::modal, "", "M126 or M127: how rotary axes go to a position."}};
  RotaryAxes axes_;
  ig::Signal per_revolution_{"KlartextFeed.~PerRevolution", ig::write, ig::Life::modal};
};

}  // namespace heidenhain
