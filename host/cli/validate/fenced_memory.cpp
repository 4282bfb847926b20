#include "validate/fenced_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <utility>

#include "validate/allocation_calls.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t fence = 512;  // bytes on either side; what lies farther away is most often nobody's memory
constexpr unsigned char mark = 0xB5;
constexpr std::array<unsigned char, fence> whole_fence = [] {
  std::array<unsigned char, fence> out{};
  out.fill(mark);
  return out;
}();

PieceList* pieces = nullptr;
std::mutex damage_mutex;
std::string damage_of_gone;  // pieces that were given back

/// What was written beside the piece; empty where nothing was.
std::string damage_of(const void* piece, std::size_t size) {
  const auto* const begin = static_cast<const unsigned char*>(piece) - fence;
  const auto* const behind = static_cast<const unsigned char*>(piece) + size;
  const auto is_whole = [](const unsigned char* at) { return std::memcmp(at, whole_fence.data(), fence) == 0; };
  if (is_whole(begin) && is_whole(behind)) return {};
  const auto is_other = [](unsigned char byte) { return byte != mark; };
  if (const auto* const at = std::find_if(begin, begin + fence, is_other); at != begin + fence)
    return fmt::format("{} bytes before a piece of {} bytes", begin + fence - at, size);
  if (const auto* const at = std::find_if(behind, behind + fence, is_other); at != behind + fence)
    return fmt::format("{} bytes behind the end of a piece of {} bytes", at - behind, size);
  return {};
}

void* fenced_allocate(std::size_t size) {
  if (size > SIZE_MAX - 2 * fence) return nullptr;
  auto* const all = static_cast<unsigned char*>(system_allocation().allocate(size + 2 * fence));
  if (all == nullptr) return nullptr;
  std::memset(all, mark, size + 2 * fence);
  std::memset(all + fence, 0, size);
  pieces->add(all + fence, size);
  return all + fence;
}

/// Takes the piece out of the list: where its memory begins; null: it is none of the list.
void* unfenced(void* piece, std::size_t* size = nullptr) {
  const std::optional<std::size_t> known = pieces->take(piece);
  if (!known) return nullptr;
  if (size != nullptr) *size = *known;
  if (std::string damage = damage_of(piece, *known); !damage.empty()) {
    const std::lock_guard lock(damage_mutex);
    damage_of_gone = std::move(damage);
  }
  return static_cast<unsigned char*>(piece) - fence;
}

void* fenced_resize_of_others(void* piece, std::size_t size) {
  std::size_t before = 0;
  void* const begin = unfenced(piece, &before);
  if (begin == nullptr) return system_allocation().resize(piece, size);
  void* const out = fenced_allocate(size);
  if (out != nullptr) std::memcpy(out, piece, std::min(before, size));
  system_allocation().give_back(begin);
  return out;
}
void* fenced_resize(void* piece, std::size_t size) {
  return piece == nullptr ? fenced_allocate(size) : fenced_resize_of_others(piece, size);
}
void fenced_give_back(void* piece) {
  void* const begin = unfenced(piece);
  system_allocation().give_back(begin != nullptr ? begin : piece);
}
void fenced_remove(void* piece) {
  if (void* const begin = unfenced(piece))
    system_allocation().give_back(begin);
  else
    system_allocation().remove(piece);
}
std::size_t fenced_usable_size(void* piece) {
  const std::optional<std::size_t> known = pieces->size_of(piece);
  return known ? *known : system_allocation().usable_size(piece);
}

}  // namespace

FencedMemory::FencedMemory(const std::filesystem::path& library) {
  system_allocation();
  pieces = new PieceList;
  redirect_allocation(
      {fenced_allocate, fenced_resize, fenced_resize_of_others, fenced_give_back, fenced_remove, fenced_usable_size},
      library);
}

std::string FencedMemory::damage() {
  std::string out;
  {
    const std::lock_guard lock(damage_mutex);
    out = std::exchange(damage_of_gone, {});
  }
  pieces->for_each([&](const void* piece, std::size_t size) {
    if (out.empty()) out = damage_of(piece, size);
  });
  return out;
}

}  // namespace isogloss::cli
