// Which syntaxes a field or a list wakes, one bit each, and which ones a value wakes as long as it is in force.
#include "link/link_steps.hpp"

namespace isogloss {

void make_wake_masks(LinkedDialect& linked) {
  std::uint32_t& first = linked.first_build;
  while (first < linked.chain.size() && linked.chain[first].syntax->build == nullptr) ++first;
  // The last bit of two words is the document's; two cost no more than one.
  linked.wake_words = linked.chain.size() - first < 128 ? 2 : 4;
  const std::size_t fields = linked.layout.fields.size();
  linked.wake.assign((fields + linked.layout.lists.size()) * linked.wake_words, 0);
  for (std::uint32_t position = first; position < linked.chain.size(); ++position) {
    const LinkedSyntax& s = linked.chain[position];
    if (s.syntax->build == nullptr) continue;
    const std::uint32_t place = position - first;
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      if ((decl.access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
      const std::span<const ig_field> one(&s.ids[i], 1);
      for (const ig_field f : (decl.access & IG_PATTERN) != 0 ? s.expansions[i] : one) {
        if (f == IG_NO_FIELD) continue;
        const std::size_t row = is_record_field(f) ? fields + list_of(f) : f;
        if ((decl.access & IG_WAKE) != 0)
          linked.wake[row * linked.wake_words + place / 64] |= std::uint64_t{1} << (place % 64);
        if ((decl.access & IG_WAKE_WHILE) != 0 && !is_record_field(f))
          linked.wake_while.push_back(
              {f, decl.wake_value == nullptr ? 0 : linked.symbols.intern(decl.wake_value), position});
      }
    }
  }
}

}  // namespace isogloss
