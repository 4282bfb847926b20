#include "cycles/cycle_data.hpp"

#include <isogloss/cnc/modal_group.hpp>

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
  const bool drills = hole.is_drilled;
  const auto put = [&](const auto& field, auto value) { drills ? b.set(field, value) : b.amend(field, value); };
  put(term_, hole.cycle);
  put(return_mode_, return_mode(b));
  if (level_rule_ == InitialLevel::cycle_entry && now.is_entry) put(initial_level_, hole.initial_level);
  if (hole.levels.r) put(r_, *hole.levels.r);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (const auto value = in[kept[i]]) put(kept_[i], *value);
  const auto keep = [&](std::size_t axis, double value) {
    const ig_value v{.number = value};
    const ig_field id = hole_.id(axis);
    drills ? b.set(id, v) : b.amend_many(&id, 1, &v);
  };
  if (hole.levels.bottom) keep(hole.plane.tool, *hole.levels.bottom);
  if (!drills) return;
  keep(hole.plane.first, hole.position[hole.plane.first]);
  keep(hole.plane.second, hole.position[hole.plane.second]);
}

}  // namespace iso
