/// Levels of macro calls with their local variables, and variables of the control that have been given values.
#include "macro/macro_store.hpp"

#include <algorithm>
#include <utility>

namespace fanuc {
namespace {

bool is_given_before(const std::pair<std::uint32_t, double>& given, std::uint32_t number) {
  return given.first < number;
}

}  // namespace

void MacroStore::define(const NumberRanges& common, const NumberRanges& permanent) {
  for (const auto& r : common.all()) add(r, false);
  for (const auto& r : permanent.all()) add(r, true);
}

void MacroStore::add(const NumberRanges::Range& range, bool is_permanent) {
  areas_.push_back({range.first, is_permanent, std::vector<double>(range.last - range.first + 1, null)});
}

const double* MacroStore::given(std::uint32_t number) const {
  const auto it = std::lower_bound(given_.begin(), given_.end(), number, is_given_before);
  return it != given_.end() && it->first == number ? &it->second : nullptr;
}

void MacroStore::give(std::uint32_t number, double value) {
  ++writes_;
  rows_.overwrite(number);
  const auto it = std::lower_bound(given_.begin(), given_.end(), number, is_given_before);
  if (it != given_.end() && it->first == number)
    it->second = value;
  else
    given_.insert(it, {number, value});
}

std::uint64_t MacroStore::enter(const Locals& arguments, bool is_modal) {
  frame_ = no_frame;
  leave_last();
  std::vector<ModalCall> inside = modal_calls();
  if (is_modal && !inside.empty()) inside.pop_back();
  levels_.push_back({++last_tag_, 1, arguments, arguments, std::move(inside)});
  return last_tag_;
}

void MacroStore::leave_last() {
  levels_.erase(levels_.begin() + static_cast<std::ptrdiff_t>(present_) + 1, levels_.end());
}

void MacroStore::select(std::uint64_t tag, std::uint32_t pass) {
  if (levels_[present_].tag != tag) {
    if (present_ + 1 < levels_.size() && levels_[present_ + 1].tag == tag)
      ++present_;
    else
      while (present_ > 0 && levels_[present_].tag != tag) --present_;
    leave_last();
  }
  Level& level = levels_[present_];
  if (level.tag != tag || level.pass == pass) return;
  level.pass = pass;
  if (!settings.repeats_keep_locals) level.values = level.arguments;
}

}  // namespace fanuc
