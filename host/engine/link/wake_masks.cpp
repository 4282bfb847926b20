// Which syntaxes a field or a list wakes, one bit each, and which ones a value wakes as long as it is in force.
#include "link/link_steps.hpp"

namespace isogloss {

void make_wake_masks(LinkedDialect& linked) {
  std::uint32_t& first = linked.first_build;
  while (first < linked.chain.size() && linked.chain[first].syntax->build == nullptr) ++first;
  linked.wake_words = wake_words_for(linked.chain.size() - first);
  const std::size_t fields = linked.layout.fields.size();
  linked.wake.assign((fields + linked.layout.lists.size()) * linked.wake_words, 0);
  for (std::uint32_t position = first; position < linked.chain.size(); ++position) {
    const LinkedSyntax& s = linked.chain[position];
    if (s.syntax->build == nullptr) continue;
    const std::size_t bit = wake_bit(position - first);
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      if ((decl.access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
      const std::span<const ig_field> one(&s.ids[i], 1);
      for (const ig_field f : (decl.access & IG_PATTERN) != 0 ? s.expansions[i] : one) {
        if (f == IG_NO_FIELD) continue;
        const std::size_t row = is_record_field(f) ? fields + list_of(f) : f;
        if ((decl.access & IG_WAKE) != 0) {
          std::uint64_t* const woken = linked.wake.data() + row * linked.wake_words;
          woken[bit / 64] |= std::uint64_t{1} << (bit % 64);
          if (bit >= 128) woken[1] |= wakes_beyond;
        }
        if ((decl.access & IG_WAKE_WHILE) != 0 && !is_record_field(f))
          linked.wake_while.push_back(
              {f, decl.wake_value == nullptr ? 0 : linked.symbols.intern(decl.wake_value), position});
      }
    }
  }
}

}  // namespace isogloss
