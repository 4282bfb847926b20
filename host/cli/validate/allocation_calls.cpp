#include "validate/allocation_calls.hpp"

#include <cstdint>
#include <new>

#include "validate/redirection.hpp"

namespace isogloss::cli {

namespace {

AllocationCalls redirected_calls{};

void* redirected_calloc(std::size_t count, std::size_t size) {
  return size != 0 && count > SIZE_MAX / size ? nullptr : redirected_calls.allocate(count * size);
}
void* redirected_new(std::size_t size) {
  void* const out = redirected_calls.allocate(size);
  if (out == nullptr) throw std::bad_alloc();
  return out;
}
void redirected_sized_delete(void* piece, std::size_t) { redirected_calls.remove(piece); }

}  // namespace

const SystemAllocation& system_allocation() {
  static const SystemAllocation out = [] {
    SystemAllocation found{};
    find_function(found.allocate, "malloc");
    find_function(found.resize, "realloc");
    find_function(found.give_back, "free");
    find_function(found.remove, "_ZdlPv");
    find_function(found.usable_size, "malloc_usable_size");
    return found;
  }();
  return out;
}

void redirect_allocation(const AllocationCalls& calls, const std::filesystem::path& library) {
  redirected_calls = calls;
  const auto at = [](auto function) { return reinterpret_cast<void*>(function); };
  const Replacement for_everyone[] = {{"free", at(calls.give_back)},
                                      {"realloc", at(calls.resize_of_others)},
                                      {"_ZdlPv", at(calls.remove)},
                                      {"_ZdaPv", at(calls.remove)},
                                      {"_ZdlPvm", at(&redirected_sized_delete)},
                                      {"_ZdaPvm", at(&redirected_sized_delete)},
                                      {"malloc_usable_size", at(calls.usable_size)}};
  const Replacement for_library[] = {{"malloc", at(calls.allocate)},
                                     {"calloc", at(&redirected_calloc)},
                                     {"realloc", at(calls.resize)},
                                     {"_Znwm", at(&redirected_new)},
                                     {"_Znam", at(&redirected_new)}};
  redirect(for_everyone, Redirected::libraries_and_command);
  redirect(for_library, Redirected::libraries, library);
}

std::optional<std::size_t> PieceList::take(const void* piece) {
  const Use use(*this);
  if (!use.is_first()) return std::nullopt;
  const auto found = sizes_.find(piece);
  if (found == sizes_.end()) return std::nullopt;
  const std::size_t out = found->second;
  sizes_.erase(found);
  return out;
}

std::optional<std::size_t> PieceList::size_of(const void* piece) const {
  const Use use(*this);
  if (!use.is_first()) return std::nullopt;
  const auto found = sizes_.find(piece);
  return found == sizes_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace isogloss::cli
