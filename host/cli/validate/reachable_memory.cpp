#include "validate/reachable_memory.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

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

/// Takes the pieces that malloc() keeps at hand after they were given back, which look as if they were in use.
void take_kept_pieces(std::set<const void*>& taken) {
  constexpr std::size_t largest = 1040, step = 16, kept_of_a_size = 7;
  mallopt(M_MXFAST, 0);
  for (std::size_t size = 8; size <= largest; size += step)
    for (std::size_t i = 0; i < kept_of_a_size; ++i) taken.insert(std::malloc(size));
}

}  // namespace

std::set<const void*> pieces_in_use() {
  std::set<const void*> taken, out;
  heap();  // what it gives back when it is asked first is taken with the others
  take_kept_pieces(taken);
  constexpr std::uintptr_t flags = 7, least = 32, alignment = 16, head = sizeof(std::uintptr_t);
  const Range all = heap();
  if (all.begin >= all.end) return out;
  std::vector<const void*> pieces;  // while the heap is walked nothing may be added to a set
  pieces.reserve((all.end - all.begin) / least);
  for (std::uintptr_t at = all.begin + alignment; at + head < all.end;) {
    const std::uintptr_t size = word_at(at - head) & ~flags;
    if (size < least || size % alignment != 0 || size > all.end - at) break;
    if (!piece_at(at, all).empty()) pieces.push_back(reinterpret_cast<const void*>(at));
    at += size;
  }
  std::set_difference(pieces.begin(), pieces.end(), taken.begin(), taken.end(), std::inserter(out, out.end()));
  return out;
}

ReachableMemory::ReachableMemory(std::span<const std::string_view> variables, const IsPointer& is_pointer) {
  constexpr std::size_t most_bytes = std::size_t{1} << 20, most_steps = 4;
  const Range all = heap();
  if (all.begin >= all.end) return;
  std::set<const char*> known;
  std::vector<Piece> open, next;
  for (const std::string_view v : variables) open.push_back({v, nullptr});
  std::size_t bytes = 0;
  for (std::size_t step = 0; step < most_steps && !open.empty(); ++step, open = std::move(next), next.clear())
    for (const Piece& from : open)
      for (std::size_t i = 0; i + sizeof(std::uintptr_t) <= from.memory.size(); i += sizeof(std::uintptr_t)) {
        const char* const word = from.memory.data() + i;
        const std::string_view piece = piece_at(word_at(reinterpret_cast<std::uintptr_t>(word)), all);
        if (piece.empty() || bytes + piece.size() > most_bytes || !is_pointer(piece.data(), word)) continue;
        if (!known.insert(piece.data()).second) continue;
        bytes += piece.size();
        next.push_back({piece, from.variable != nullptr ? from.variable : word});
        pieces_.push_back(next.back());
      }
  for (Piece& p : pieces_) p.bytes = p.memory;
}

std::vector<std::string_view> ReachableMemory::pieces() const {
  std::vector<std::string_view> out;
  for (const Piece& p : pieces_) out.push_back(p.memory);
  return out;
}

const char* ReachableMemory::changed_from() const {
  for (const Piece& p : pieces_)
    if (p.memory != p.bytes) return p.variable;
  return nullptr;
}

}  // namespace isogloss::cli
