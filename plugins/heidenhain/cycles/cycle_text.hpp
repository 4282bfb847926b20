/// Reads the text of a cycle's definition: its number, and the Q parameters after its name.
#pragma once

#include <span>

#include "cycles/cycle_parameters.hpp"
#include "language/program_unit.hpp"
#include "motion/feed_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// CYCL DEF 200, CYCL DEF 7.1. The number may follow without a blank, and blanks may separate its parts: CYCL DEF9 .0
struct CycleNumber {
  std::uint32_t cycle = 0;
  std::optional<std::uint32_t> part;
  std::size_t end = 0;
  bool is_first() const { return !part || *part == 0; }

  static std::optional<CycleNumber> at(std::string_view text, std::size_t i) {
    CycleNumber out;
    const auto read = [&](std::size_t from, std::uint32_t& value) {
      const std::size_t behind = skip_digits(text, from);
      const bool is_read =
          behind != from && std::from_chars(text.data() + from, text.data() + behind, value).ec == std::errc{};
      return is_read ? behind : from;
    };
    out.end = read(i, out.cycle);
    if (out.end == i) return std::nullopt;
    const std::size_t point = skip_blanks(text, out.end);
    std::uint32_t number_of_part = 0;
    const std::size_t digits = skip_blanks(text, point + 1);
    if (ig::cnc::at(text, point) != '.') return out;
    if (const std::size_t part_end = read(digits, number_of_part); part_end != digits) {
      out.part = number_of_part;
      out.end = part_end;
    }
    return out;
  }
};

/// Cycles that act where they are defined; all others wait for a call.
constexpr bool acts_where_defined(std::uint32_t cycle) {
  constexpr std::array<std::uint32_t, 27> all{7,   8,   9,   10,  11,  13,  14,  19,  20,  26,  30,  32,  220, 221,
                                              224, 238, 239, 247, 270, 271, 285, 291, 332, 392, 800, 801, 892};
  for (const std::uint32_t c : all)
    if (c == cycle) return true;
  return false;
}

/// Cycles that wait for a call, from the tables of the manuals. For other cycles, those of machine builders among them,
/// it is not known when they act.
constexpr bool waits_for_call(std::uint32_t cycle) {
  struct Range {
    std::uint32_t first, last;
  };
  constexpr std::array all{Range{1, 6},     Range{12, 12},   Range{15, 18},   Range{21, 29},   Range{39, 39},
                           Range{200, 215}, Range{225, 225}, Range{230, 233}, Range{240, 241}, Range{251, 258},
                           Range{262, 267}, Range{270, 277}, Range{290, 292}, Range{810, 883}};
  for (const Range& r : all)
    if (r.first <= cycle && cycle <= r.last) return true;
  return false;
}

/// The parameters of a cycle; empty where they are not known here.
inline std::span<const std::uint16_t> parameters_of(std::int64_t cycle) {
  static constexpr std::uint16_t c200[] = {200, 201, 206, 202, 210, 203, 204, 211, 395};
  static constexpr std::uint16_t c201[] = {200, 201, 206, 211, 208, 203, 204};
  static constexpr std::uint16_t c202[] = {200, 201, 206, 211, 208, 203, 204, 214, 336};
  static constexpr std::uint16_t c203[] = {200, 201, 206, 202, 210, 203, 204, 212, 213, 205, 211, 208, 256, 395};
  static constexpr std::uint16_t c204[] = {200, 249, 250, 251, 252, 253, 254, 255, 203, 204, 214, 336};
  static constexpr std::uint16_t c205[] = {200, 201, 206, 202, 203, 204, 212, 205, 258,
                                           259, 257, 256, 211, 379, 253, 208, 395, 373};
  static constexpr std::uint16_t c206[] = {200, 201, 206, 211, 203, 204};
  static constexpr std::uint16_t c207[] = {200, 201, 239, 203, 204};
  static constexpr std::uint16_t c208[] = {200, 201, 206, 334, 203, 204, 335, 342, 351, 370};
  static constexpr std::uint16_t c209[] = {200, 201, 239, 203, 204, 257, 256, 336, 403};
  static constexpr std::uint16_t c220[] = {216, 217, 244, 245, 246, 247, 241, 200, 203, 204, 301, 365};
  static constexpr std::uint16_t c221[] = {225, 226, 237, 238, 242, 243, 224, 200, 203, 204, 301};
  static constexpr std::uint16_t c240[] = {200, 343, 201, 344, 206, 211, 203, 204, 342, 253};
  static constexpr std::uint16_t c241[] = {200, 201, 206, 211, 203, 204, 379, 253, 208, 426,
                                           427, 428, 429, 430, 435, 401, 202, 212, 205};
  static constexpr std::uint16_t c247[] = {339};
  switch (cycle) {
    case 200: return c200;
    case 201: return c201;
    case 202: return c202;
    case 203: return c203;
    case 204: return c204;
    case 205: return c205;
    case 206: return c206;
    case 207: return c207;
    case 208: return c208;
    case 209: return c209;
    case 220: return c220;
    case 221: return c221;
    case 240: return c240;
    case 241: return c241;
    case 247: return c247;
    default: return {};
  }
}

/// A member of the syntaxes that read definitions.
class CycleText {
 public:
  /// Whether the cycle has feeds among its parameters.
  enum class Feeds { none, some };
  CycleText() : CycleText(Feeds::some) {}
  explicit CycleText(Feeds feeds) {
    if (feeds == Feeds::some) feed_.emplace();
  }

  static constexpr double fastest = 99'999;

  /// Executes Q200=2 and so on, between the words of the cycle's name: each is an assignment, and note(number, value)
  /// is called for those that are not local parameters. Returns the position after the last one; `position` where there
  /// is none.
  template <class Note>
  std::size_t parameters(ig::Block& b, std::string_view text, std::size_t position, std::int64_t cycle,
                         Note&& note) const {
    std::size_t done = position;
    bool is_said = false;
    for (std::size_t i = skip(text, position); i < text.size(); i = skip(text, i)) {
      std::size_t end = i;
      const auto q = Values::q_at(text, i, end);
      const std::size_t equals = q ? skip(text, end) : i;
      const bool is_feed_word = q && is_feed_word_at(text, equals);
      if (!q || (at(text, equals) != '=' && !is_feed_word)) {
        const std::size_t next = std::max(i + 1, skip_while(text, i, [](char c) { return !is_space(c); }));
        if (done != position && !is_said)
          b.report(ig::diag("HEI-0105"), ig::Where::columns(i, next), piece(text, i, next),
                   std::string_view("a parameter of CYCL DEF"));
        is_said = is_said || done != position;
        i = std::max(i + 1, word_end(text, i));
        continue;
      }
      const std::size_t first = is_feed_word ? equals : skip(text, equals + 1);
      const std::string_view name = piece(text, i, end);
      const auto where = ig::Where::columns(i, end);
      const Value v = value(b, text, first);
      if (!v.ok) {
        b.report(ig::diag("HEI-0104"), where, std::string_view("CYCL DEF"), name);
        done = i = std::max(first, end + 1);
        continue;
      }
      values_.set(b, *q, name, where, v.number);
      if (q->kind == QKind::q) {
        if (!knows(cycle, q->number)) b.report(ig::diag("HEI-0179"), where, static_cast<double>(cycle), name);
        note(q->number, v.number);
      }
      done = i = v.end;
    }
    return done;
  }

  /// The value in mm or mm/min, according to `unit`; unchanged where it has another unit.
  double metric(const ig::Block& b, std::string_view unit, double value) const {
    const bool is_feed = feed_ && unit == "mm/min" && value < fastest;
    if ((unit != "mm" && !is_feed) || !unit_.is_inch(b)) return value;
    return mm_per_inch * (is_feed ? feed_->in_unit(b, value) : value);
  }

  /// The number after a word of any language: V.ZEIT 1.5
  Value number_behind(ig::Block& b, std::string_view text, std::size_t i) const {
    i = skip(text, i);
    if (const Value v = values_.read(b, text, i); v.ok) return v;
    while (i < text.size()) {
      const char c = text[i];
      std::size_t end = i;
      if (is_digit(c) || c == '+' || c == '-' || (c == '.' && is_digit(at(text, i + 1))) || Values::q_at(text, i, end))
        break;
      ++i;
    }
    return values_.read(b, text, i);
  }

  /// Q206 FAUTO without the equals sign, as some listings have it.
  static bool is_feed_word_at(std::string_view text, std::size_t i) {
    const std::string_view word = piece(text, i, letters_end(text, i));
    for (const std::string_view name : {"FAUTO", "FMAX", "AUTO", "MAX"})
      if (equals_ignoring_case(word, name)) return true;
    return false;
  }

  const Values& values() const { return values_; }
  const FeedWords& feed() const { return *feed_; }

 private:
  Value value(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value v = values_.read(b, text, i);
    if (v.ok) return v;
    const std::size_t word = letters_end(text, i);
    const auto is = [&](std::string_view name) { return equals_ignoring_case(piece(text, i, word), name); };
    if (is("FMAX") || is("MAX")) return {fastest, word, true};
    if (!feed_ || (!is("FAUTO") && !is("AUTO"))) return v;
    const auto of_tool_call = feed_->of_tool_call(b);
    return {feed_->as_written(b, of_tool_call.value_or(0)), word, of_tool_call.has_value()};
  }
  static bool knows(std::int64_t cycle, std::uint32_t q) {
    const auto all = parameters_of(cycle);
    return all.empty() || std::find(all.begin(), all.end(), q) != all.end();
  }

  Values values_;
  std::optional<FeedWords> feed_;
  ProgramUnit unit_;
};

}  // namespace heidenhain
