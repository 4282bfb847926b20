#include "validate/own_memory.hpp"

#include <cstring>

#include "validate/allocation_calls.hpp"

namespace isogloss::cli {

namespace {

PieceList* owned = nullptr;

// Zeros, so that what was in the memory before is not taken for a pointer.
void* own_allocate(std::size_t size) {
  void* const out = system_allocation().allocate(size);
  if (out == nullptr) return out;
  std::memset(out, 0, size);
  owned->add(out, size);
  return out;
}
void* own_resize_of_others(void* piece, std::size_t size) {
  owned->take(piece);
  return system_allocation().resize(piece, size);
}
void* own_resize(void* piece, std::size_t size) {
  void* const out = own_resize_of_others(piece, size);
  if (out != nullptr) owned->add(out, size);
  return out;
}
void own_give_back(void* piece) {
  owned->take(piece);
  system_allocation().give_back(piece);
}
void own_remove(void* piece) {
  owned->take(piece);
  system_allocation().remove(piece);
}

}  // namespace

OwnMemory::OwnMemory(const std::filesystem::path& library) {
  const SystemAllocation& system = system_allocation();
  if (owned == nullptr) owned = new PieceList;
  redirect_allocation({own_allocate, own_resize, own_resize_of_others, own_give_back, own_remove, system.usable_size},
                      library);
}

void OwnMemory::add(const void* begin) { owned->add(begin, 0); }

bool OwnMemory::contains(const void* begin) const { return owned->size_of(begin).has_value(); }

}  // namespace isogloss::cli
