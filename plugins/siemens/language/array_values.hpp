/// The values of an array: SET(1,2,3) and (1,2,3) for consecutive elements, REP(0) for all elements, REP(0,5) for five
/// of them; in a definition, and in an assignment from the named element on.
#pragma once

#include "flow/flow_words.hpp"
#include "language/declared_value.hpp"

namespace siemens {

using namespace ig::cnc;

class ArrayValues {
 public:
  ArrayValues(ig::Block& b, const Environment& environment, std::string_view text)
      : b_(b), environment_(environment), text_(text) {}

  /// True at SET( or REP( at `position`, or at a bracket alone.
  static bool begin(std::string_view text, std::size_t position, bool or_bracket) {
    if (or_bracket && at(text, position) == '(') return true;
    return (is_word(text, position, "SET") || is_word(text, position, "REP")) &&
           at(text, skip_blanks(text, skip_name(text, position))) == '(';
  }

  /// Stores the values from element number `first` on and moves `next` past them. False, with a diagnostic, where that
  /// is not possible.
  bool read(std::size_t& next, const std::string& array, std::size_t first) {
    const std::size_t begin = next;
    const bool repeats = is_word(text_, next, "REP");
    if (at(text_, next) != '(') next = skip_blanks(text_, skip_name(text_, next));
    if (!read_list(next, array, repeats)) return false;
    const Variable* const target = environment_.store().find(array);
    // One more than the program may have, so that the store reports the excess.
    const std::size_t most_elements = environment_.store().most_names + 1;
    const bool is_sized = !target->sizes.empty();
    const std::size_t room = is_sized ? target->size() - std::min(first, target->size()) : most_elements;
    if (repeats) {
      const std::size_t count = std::min(count_.value_or(room), room);
      if (first == 0 && count >= room && values_[0]) {
        environment_.store().fill(array, *values_[0]);
        environment_.note_fill(b_, array, *values_[0]);
        return true;
      }
      const std::size_t elements = std::min({count, room, most_elements});
      if (values_[0] && !environment_.store().may_hold(array, first, elements)) {
        environment_.report_not_stored(b_, ig::Where::columns(begin, next), array, *values_[0], Stored::too_many);
        return false;
      }
      values_.assign(elements, std::optional<Value>(values_[0]));
    } else if (values_.size() > room) {
      b_.report(ig::diag("SIE-0303"), ig::Where::columns(begin, next), std::string_view(array),
                static_cast<double>(room));
      values_.resize(room);
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!values_[i]) continue;  // SET(1,,3) does not change the second element
      const std::string name = array + target->indices_of(first + i);
      const Stored outcome = environment_.store().assign(name, *values_[i]);
      environment_.note_write(b_, name, *values_[i]);
      if (outcome == Stored::yes) continue;
      const bool is_full = outcome == Stored::too_many;
      environment_.report_not_stored(b_, ig::Where::columns(begin, next), is_full ? array : name, *values_[i], outcome);
      if (is_full) return false;
    }
    return true;
  }

 private:
  bool read_list(std::size_t& next, const std::string& array, bool repeats) {
    const Declared& type = environment_.store().find(array)->declared;
    do {
      next = skip_blanks(text_, next + 1);
      if (repeats && values_.size() == 1) {
        Expression e(b_, environment_, text_, next);
        const auto count = e.number();
        if (!count) return false;
        count_ = *count > 0 ? static_cast<std::size_t>(std::min(*count, 1e9)) : 0;
        next = skip_blanks(text_, e.position());
        continue;
      }
      values_.emplace_back();
      if (const char c = at(text_, next); c == ',' || c == ')') continue;
      const std::size_t begin = next;
      auto v = value_of(b_, environment_, text_, next, type);
      if (!v) return false;
      next = skip_blanks(text_, next);
      if (const Stored outcome = type.fit(*v); outcome != Stored::yes) {
        environment_.report_not_stored(b_, ig::Where::columns(begin, next), array, *v, outcome);
        return false;
      }
      values_.back() = std::move(v);
    } while (at(text_, next) == ',');
    if (at(text_, next) != ')') {
      b_.report(ig::diag("SIE-0102"), columns(text_, std::min(next, text_.size())));
      return false;
    }
    ++next;
    return true;
  }
  ig::Block& b_;
  const Environment& environment_;
  std::string_view text_;
  std::vector<std::optional<Value>> values_;
  std::optional<std::size_t> count_;  // of REP
};

}  // namespace siemens
