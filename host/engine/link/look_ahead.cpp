// Which syntaxes read blocks ahead, and which fields tell them that they have read enough.
#include <algorithm>

#include "isogloss/engine/document.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

bool LookAhead::ends_at(const Document& block) const {
  return std::any_of(ends.begin(), ends.end(), [&block](ig_field f) { return block.present(f); });
}

bool LookAhead::is_satisfied_by(std::span<Document* const> following) const {
  return following.size() >= blocks ||
         std::any_of(following.begin(), following.end(), [this](const Document* d) { return ends_at(*d); });
}

void find_look_ahead(LinkedDialect& linked) {
  for (std::uint32_t position = linked.first_build; position < linked.chain.size(); ++position) {
    const LinkedSyntax& s = linked.chain[position];
    if (s.syntax->look_ahead == 0 || s.syntax->build == nullptr) continue;
    LookAhead& out = linked.look_ahead.emplace_back(LookAhead{position, s.syntax->look_ahead, {}});
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const std::uint32_t access = s.syntax->fields[i].access;
      if ((access & IG_ENDS_AHEAD) == 0) continue;
      const std::span<const ig_field> one(&s.ids[i], 1);
      for (const ig_field f : (access & IG_PATTERN) != 0 ? s.expansions[i] : one)
        if (f != IG_NO_FIELD && !is_record_field(f)) out.ends.push_back(f);
    }
  }
}

}  // namespace isogloss
