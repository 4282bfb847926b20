#include "validate/reachable_memory.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>

namespace isogloss::cli {

namespace {

struct Range {
  std::uintptr_t begin = 0, end = 0;
};

std::uintptr_t begin_of_heap() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
    if (line.ends_with("[heap]")) return std::strtoull(line.c_str(), nullptr, 16);
  return UINTPTR_MAX;
}

/// The memory that malloc() takes small pieces from.
Range heap() {
  static const std::uintptr_t begin = begin_of_heap();
  return {begin, reinterpret_cast<std::uintptr_t>(sbrk(0))};
}

std::uintptr_t word_at(std::uintptr_t address) {
  std::uintptr_t out = 0;
  std::memcpy(&out, reinterpret_cast<const void*>(address), sizeof out);
  return out;
}

/// The piece of memory that begins at this address; empty where none in use does. Before a piece glibc keeps its size,
/// whose lowest bit says whether the piece before is in use.
std::string_view piece_at(std::uintptr_t address, const Range& heap) {
  constexpr std::uintptr_t flags = 7, least = 32, alignment = 16, head = sizeof(std::uintptr_t);
  if (address % alignment != 0 || address < heap.begin + alignment || address >= heap.end - alignment) return {};
  const std::uintptr_t size = word_at(address - head) & ~flags;
  if (size < least || size % alignment != 0 || size > heap.end - address) return {};
  const std::uintptr_t next = address + size - head;
  if (next + head > heap.end || (word_at(next) & 1) == 0) return {};
  return {reinterpret_cast<const char*>(address), size - head};
}

}  // namespace

ReachableMemory::ReachableMemory(std::span<const std::string_view> variables,
                                 const std::function<bool(const void*)>& is_owned) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20, most_steps = 4;
  const Range all = heap();
  if (all.begin >= all.end) return;
  std::set<const char*> known;
  std::vector<std::string_view> open(variables.begin(), variables.end()), next;
  std::size_t bytes = 0;
  for (std::size_t step = 0; step < most_steps && !open.empty(); ++step, open = std::move(next), next.clear())
    for (const std::string_view memory : open)
      for (std::size_t i = 0; i + sizeof(std::uintptr_t) <= memory.size(); i += sizeof(std::uintptr_t)) {
        const std::string_view piece = piece_at(word_at(reinterpret_cast<std::uintptr_t>(memory.data()) + i), all);
        if (piece.empty() || bytes + piece.size() > most_bytes || !known.insert(piece.data()).second) continue;
        if (!is_owned(piece.data())) continue;
        bytes += piece.size();
        next.push_back(piece);
        pieces_.push_back({piece, {}});
      }
  for (Piece& p : pieces_) p.bytes = p.memory;
}

std::vector<std::string_view> ReachableMemory::pieces() const {
  std::vector<std::string_view> out;
  for (const Piece& p : pieces_) out.push_back(p.memory);
  return out;
}

bool ReachableMemory::has_changed() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.memory != p.bytes; });
}

}  // namespace isogloss::cli
