/// F of a path block or of TOOL CALL: a number, MAX, AUTO, or feed per revolution.
#pragma once

#include "language/block_words.hpp"
#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of each syntax whose blocks hold F.
class FeedWords {
 public:
  /// Takes the F at `position`. `is_rapid` becomes true for FMAX.
  std::size_t scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
                   bool& is_rapid) const {
    const std::size_t letters = letters_end(text, position + 1);
    std::string_view kind = piece(text, position + 1, letters);
    std::size_t end = position + 1;
    if (kind.empty() || to_upper(kind[0]) == 'Q') {
      const std::size_t next = skip_blanks(text, position + 1);
      if (const std::size_t word = letters_end(text, next); word > next) kind = piece(text, next, word);
    }
    const auto is = [&](std::string_view name) { return equals_ignoring_case(kind, name); };
    // FMAXM3, FAUTOR0: the next word may follow directly.
    for (const std::string_view name : {"MAX", "AUTO"})
      if (kind.size() == name.size() + 1 && to_upper(kind.back()) != 'T' && is_digit(at(text, letters)) &&
          equals_ignoring_case(kind.substr(0, name.size()), name))
        kind.remove_suffix(1);
    if (is("MAX") || is("AUTO")) {
      end = static_cast<std::size_t>(kind.data() + kind.size() - text.data());
      const bool has_number = b.has(f_);
      if (has_number || is_rapid) report_repeated(b, text, position, end);
      if (is("MAX")) {
        if (has_number) b.erase(f_);
        is_rapid = true;
      } else if (const auto feed = b.get(tool_feed_)) {
        select_mode(b, b.is_raised(tool_feed_per_revolution_), position, end);
        put_word(b, f_.id(), position, end, *feed);
      } else {
        b.report(ig::diag("HEI-0138"), ig::Where::columns(position, end));
      }
      return end;
    }
    const char by = kind.empty() ? '\0' : to_upper(kind[0]);
    const bool is_per_revolution = by == 'U';
    const bool is_unknown = by == 'Z' || by == 'T' || is("MAXT");
    if (letters > position + 2 && !is_per_revolution && !is_unknown && by != 'Q' && at(text, letters) != '=') {
      b.report(ig::diag("HEI-0103"), ig::Where::columns(position, letters), piece(text, position, letters),
               std::string_view("F"));
      return letters;
    }
    const Value v = values.read(b, text, is_per_revolution || is_unknown ? letters : position + 1);
    if (!v.ok) return is_unknown ? letters : position + 1;  // F alone: the prompt was not answered
    if (is_unknown) {
      b.report(ig::diag("HEI-0136"), ig::Where::columns(position, v.end), trim(piece(text, position, v.end)));
      return v.end;
    }
    select_mode(b, is_per_revolution, position, v.end);
    if (b.has(f_) || is_rapid) report_repeated(b, text, position, v.end);
    is_rapid = false;
    put_word(b, f_.id(), position, v.end, is_per_revolution ? v.number : unit_.in_unit(b, v.number));
    return v.end;
  }

  /// Keeps the F of TOOL CALL, which is in force and is the meaning of F AUTO.
  void keep(ig::Block& b, double feed) const {
    b.set(tool_feed_, feed);
    const bool is_per_revolution = b.has(modes_.id(1)) || (b.is(mode_, g95_) && !b.has(modes_.id(0)));
    if (is_per_revolution)
      b.raise(tool_feed_per_revolution_);
    else
      b.erase(tool_feed_per_revolution_);
  }
  std::optional<double> word(const ig::Block& b) const { return b.get(f_); }
  /// A feed that counts in its own statement alone, in the program's unit a minute, or mm a revolution.
  struct Own {
    double value;
    bool is_per_revolution;
  };
  /// Takes the F that scan() has just read, and the code of its mode: the feed in force stays. Nothing after FMAX.
  std::optional<Own> take(ig::Block& b) const {
    const auto f = b.get(f_);
    const bool is_per_revolution = b.has(modes_.id(1)) || (b.is(mode_, g95_) && !b.has(modes_.id(0)));
    for (const std::size_t mode : {0u, 1u})
      if (b.has(modes_.id(mode))) b.erase(modes_.id(mode));
    if (!f) return std::nullopt;
    b.erase(f_);
    return Own{*f, is_per_revolution};
  }
  const FeedUnit& unit() const { return unit_; }
  std::optional<double> of_tool_call(const ig::Block& b) const { return b.get(tool_feed_); }

 private:
  /// FU counts mm a revolution, every other F mm a minute, unless M136 is in force.
  void select_mode(ig::Block& b, bool is_per_revolution, std::size_t begin, std::size_t end) const {
    const bool was_per_revolution = b.is(mode_, g95_);
    if (is_per_revolution && !was_per_revolution) put_code(b, modes_.id(1), begin, end);
    if (!is_per_revolution && was_per_revolution && !b.is_raised(per_revolution_))
      put_code(b, modes_.id(0), begin, end);
  }

  ig::Field<double> f_{"Parsing.F", ig::read | ig::write, {ig::Life::standard, "mm/min", ""}};
  ig::Out<double> tool_feed_{
      "KlartextFeed.ToolCall",
      {ig::Life::modal, "", "F of the last TOOL CALL, which F AUTO means; in the program's unit."}};
  ig::Signal tool_feed_per_revolution_{"KlartextFeed.~ToolCallPerRevolution", ig::read | ig::write, ig::Life::modal};
  ig::Codes modes_{{"G94", "G95"}, ig::read | ig::write};
  ig::In<ig::Symbol> mode_{"Feedrate.Term"};
  FeedUnit unit_;
  ig::Signal per_revolution_{"KlartextFeed.~PerRevolution", ig::read, ig::Life::modal};
  ig::Name g95_{"G95"};
};

}  // namespace heidenhain
