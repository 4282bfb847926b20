// The syntaxes of a chain: instances, the bytes that their scanners take, the fields that wake them while a value
// holds.
#include <algorithm>
#include <stdexcept>

#include "contract/host_table.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/scanned_line.hpp"
#include "run/calling.hpp"

namespace isogloss {

void Chain::create_syntaxes() {
  steps_.resize(linked_.chain.size());
  std::vector<std::uint32_t> idle;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const LinkedSyntax& s = linked_.chain[i];
    ig_link link{this, &s.options, &s, nullptr, {}, false};
    const Calling calling(*s.plugin, s.element.alias.c_str(), "create");
    ig_status status = IG_FAILED;
    creating_ = static_cast<std::uint16_t>(i + 1);
    try {
      status = s.syntax->create(&link_functions(), &link, s.ids.data(), &steps_[i].self);
    } catch (...) {
      steps_[i].self = nullptr;
      sink_.add(exception_diagnostic(*s.plugin, s.element.alias, "create", s.element.where));
      throw std::runtime_error(s.element.alias + " could not be created");
    }
    if (status == IG_FAILED) {
      steps_[i].self = nullptr;
      sink_.add(host_diagnostic("IG-0308", s.element.where, {s.element.alias, link.reason()}));
      throw std::runtime_error(s.element.alias + " could not be created");
    }
    (s.syntax->look_ahead == 0 ? steps_[i].build : steps_[i].build_ahead) = link.is_idle ? nullptr : s.syntax->build;
    if (link.is_idle && i >= linked_.first_build)
      idle.push_back(static_cast<std::uint32_t>(wake_bit(i - linked_.first_build)));
    const bool is_left = host_ == &ahead_table() && (s.syntax->scan_flags & IG_SCANS_AHEAD) == 0;
    steps_[i].scan = is_left && s.syntax->scan != nullptr ? leave_to_turn : s.syntax->scan;
    if (steps_[i].any_build() != nullptr && i >= linked_.inspection_begin) {
      const std::size_t bit = wake_bit(i - linked_.first_build);
      inspection_.add(bit);
      if (s.syntax->inspects != 0) inspectors_.add(bit);
    }
    if (s.syntax->scan != nullptr && s.syntax->triggers != nullptr)
      for (const char* c = s.syntax->triggers; *c != '\0'; ++c)
        scanners_[static_cast<unsigned char>(*c)].push_back(static_cast<std::uint16_t>(i));
  }
  document_.silence(idle);
}

void Chain::watch_modal_state() {
  for (const WakeWhile& w : linked_.wake_while)
    if (steps_[w.position].any_build() != nullptr) watched_.push_back(w);
  std::stable_sort(watched_.begin(), watched_.end(),
                   [](const WakeWhile& a, const WakeWhile& b) { return a.field < b.field; });
  const std::vector<FieldInfo>& fields = linked_.layout.fields;
  for (std::uint32_t i = 0; i < watched_.size(); ++i) {
    const ig_field field = watched_[i].field;
    if (watches_.empty() || watches_.back().field != field) {
      // A `previous` field changes one block after its source.
      const ig_field original = fields[field].previous_of != IG_NO_FIELD ? fields[field].previous_of : field;
      document_.watch(original, change_of(watches_.size()));
      watches_.push_back({field, i, i, is_carried(fields[original].life), {}});
      // Scanned words bypass `tell_watch`, so check them in every block.
      if (fields[original].life == IG_LIFE_WORD) always_ |= change_of(watches_.size() - 1);
    }
    ++watches_.back().end;
  }
  document_.changes = ~std::uint64_t{0};
}

}  // namespace isogloss
