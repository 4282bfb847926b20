/// Reads the text of a cycle's definition: the Q parameters after its name.
#pragma once

#include "cycles/cycle_number.hpp"
#include "cycles/cycle_parameters.hpp"
#include "language/program_unit.hpp"
#include "motion/feed_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntaxes that read definitions.
class CycleText {
 public:
  /// Whether the cycle has feeds among its parameters.
  enum class Feeds { none, some };
  CycleText() : CycleText(Feeds::some) {}
  explicit CycleText(Feeds feeds) {
    if (feeds == Feeds::some) feed_.emplace();
  }

  /// Executes Q200=2 and so on, between the words of the cycle's name: each is an assignment, and note(number, value)
  /// is called for those that are not local parameters. Returns the position after the last one; `position` where there
  /// is none.
  template <class Note>
  std::size_t parameters(ig::Block& b, std::string_view text, std::size_t position, std::int64_t cycle,
                         Note&& note) const {
    std::size_t done = position;
    bool is_reported = false;
    std::vector<std::uint32_t> named;
    for (std::size_t i = skip(text, position); i < text.size(); i = skip(text, i)) {
      std::size_t end = i;
      const auto q = Values::q_at(text, i, end);
      const std::size_t equals = q ? skip(text, end) : i;
      const bool is_feed_word = q && is_feed_word_at(text, equals);
      if (!q || (at(text, equals) != '=' && !is_feed_word)) {
        const std::size_t next = std::max(i + 1, skip_while(text, i, [](char c) { return !is_space(c); }));
        if (done != position && !is_reported)
          b.report(ig::diag("HEI-0105"), ig::Where::columns(i, next), piece(text, i, next),
                   std::string_view("a parameter of CYCL DEF"));
        is_reported = is_reported || done != position;
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
        if (std::find(named.begin(), named.end(), q->number) != named.end()) report_repeated(b, text, i, v.end);
        named.push_back(q->number);
        if (!knows(cycle, q->number)) b.report(ig::diag("HEI-0179"), where, static_cast<double>(cycle), name);
        note(q->number, v.number);
      }
      done = i = v.end;
    }
    return done;
  }

  /// Sets parameter `q` in mm or mm/min. A parameter that the table lacks, and an infinite value, is not set.
  template <const auto& table>
  void set(ig::Block& b, const CycleParameters<table>& to, std::uint32_t q, double value) const {
    if (!to.holds(q)) return;
    const double in_metric = metric(b, to.unit(q), value);
    if (std::isfinite(in_metric)) to.set(b, q, in_metric);
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
      const bool is_of_word = is_letter(c) || is_blank(c) || c == '.' || (static_cast<unsigned char>(c) & 0x80) != 0;
      if (!is_of_word) break;
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
  /// The value in mm or mm/min, according to `unit`; unchanged where it has another unit.
  double metric(const ig::Block& b, std::string_view unit, double value) const {
    const bool is_feed = feed_ && unit == "mm/min" && value < fmax_feed;
    if ((unit != "mm" && !is_feed) || !unit_.is_inch(b)) return value;
    return mm_per_inch * (is_feed ? feed_->unit().in_unit(b, value) : value);
  }
  Value value(ig::Block& b, std::string_view text, std::size_t i) const {
    const Value v = values_.read(b, text, i);
    if (v.ok) return v;
    const std::size_t word = letters_end(text, i);
    const auto is = [&](std::string_view name) { return equals_ignoring_case(piece(text, i, word), name); };
    if (is("FMAX") || is("MAX")) return {fmax_feed, word, true};
    if (!feed_ || (!is("FAUTO") && !is("AUTO"))) return v;
    const auto of_tool_call = feed_->of_tool_call(b);
    return {feed_->unit().as_written(b, of_tool_call.value_or(0)), word, of_tool_call.has_value()};
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
