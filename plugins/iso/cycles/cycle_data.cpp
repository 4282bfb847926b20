#include "cycles/cycle_data.hpp"

#include <isogloss/cnc/modal_group.hpp>

#include "cycles/field_writes.hpp"

namespace iso {

void CycleData::cancel(ig::Block& b) const {
  for (std::size_t axis = 0; axis < 3; ++axis) b.erase(hole_.id(axis));
  b.erase(r_);
  for (const auto& field : kept_) b.erase(field);
  b.erase(return_mode_);
  b.erase(initial_level_);
  b.set(term_, cancelled_);
}

bool CycleData::take_return_mode(ig::Block& b) const {
  const auto mode = take_modal(b, return_codes_);
  if (!mode) return false;
  if (return_codes_.name(*mode) == g99_)
    b.raise(return_to_r_);
  else
    b.erase(return_to_r_);
  if (b.has(return_mode_)) b.amend(return_mode_, return_codes_.name(*mode));
  return true;
}

void CycleData::forget_levels(ig::Block& b, double level) const {
  for (std::size_t axis = 0; axis < 3; ++axis) b.erase(hole_.id(axis));
  b.erase(r_);
  if (level_rule_ == InitialLevel::cycle_entry) b.amend(initial_level_, level);
}

void CycleData::end_other_way_to_peck(ig::Block& b, const CycleWords& in) const {
  if (in.has(Address::I) && !in.has(Address::Q)) b.erase(kept_[0]);
  if (in.has(Address::Q) && !in.has(Address::I))
    for (const std::size_t i : {2, 3, 4}) b.erase(kept_[i]);
}

void CycleData::enter(ig::Block& b, const ActiveCycle& now, ig::Symbol code, double level) const {
  b.amend(term_, code);
  b.amend(return_mode_, return_mode(b));
  if (level_rule_ == InitialLevel::cycle_entry && now.is_entry) b.amend(initial_level_, level);
}

void CycleData::store(ig::Block& b, const ActiveCycle& now, const CycleWords& in, const ResolvedHole& hole,
                      std::span<const Address> kept) const {
  static_assert(words.size() + 7 <= FieldWrites::most, "the words that are kept, and what is named below");
  FieldWrites writes;
  writes.add(term_, hole.cycle);
  writes.add(return_mode_, return_mode(b));
  if (level_rule_ == InitialLevel::cycle_entry && now.is_entry) writes.add(initial_level_, hole.initial_level);
  if (hole.levels.r) writes.add(r_, *hole.levels.r);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (const auto value = in[kept[i]]) writes.add(kept_[i], *value);
  if (hole.levels.bottom) writes.add(hole_.id(hole.plane.tool), *hole.levels.bottom);
  if (!hole.is_drilled) return writes.amend(b);
  for (const std::size_t axis : {hole.plane.first, hole.plane.second}) writes.add(hole_.id(axis), hole.position[axis]);
  writes.set(b);
}

}  // namespace iso
