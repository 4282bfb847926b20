/// Brings two streams of blocks in step. Where they part, the nearest place at which both go on alike is searched in a
/// window; beyond it the side that has called a program, or that stands further back, goes on alone.
#pragma once

#include <deque>
#include <memory>

#include "diff/snapshot.hpp"

namespace isogloss::cli::parting {

template <class Item>
class Aligner {
 public:
  explicit Aligner(std::array<Channel<Item>, 2>& channels) : channels_(channels) {}

  /// The next blocks of both sides that belong together, or the next of one side and null; both null at the end.
  using Pair = std::array<std::unique_ptr<Item>, 2>;
  Pair next() {
    if (alone_[0] == 0 && alone_[1] == 0) look();
    Pair out;
    for (std::size_t side = 0; side < 2; ++side)
      if (alone_[side] > 0) {
        --alone_[side];
        out[side] = take(side);
        return out;
      }
    if (!both_) return out;
    for (std::size_t side = 0; side < 2; ++side) out[side] = take(side);
    both_ = false;
    return out;
  }
  /// What was reported after the last block.
  Item& end_of(std::size_t side) { return *ends_[side]; }

 private:
  static constexpr std::size_t window_ = 64;

  void look() {
    const Item *const a = peek(0, 0), *const b = peek(1, 0);
    if (a == nullptr && b == nullptr) return;
    if (a == nullptr || b == nullptr) {
      alone_[a == nullptr ? 1 : 0] = 1;
      return;
    }
    if (a->key == b->key) {
      both_ = true;
      return;
    }
    for (std::size_t sum = 1; sum < window_; ++sum)
      for (std::size_t i = 0; i <= sum; ++i) {
        const Item *const one = peek(0, i), *const other = peek(1, sum - i);
        if (one == nullptr || other == nullptr || !(one->key == other->key)) continue;
        alone_ = {i, sum - i};
        both_ = true;
        return;
      }
    const bool is_a_behind = a->key.depth != b->key.depth ? a->key.depth > b->key.depth : a->key.rank <= b->key.rank;
    alone_[is_a_behind ? 0 : 1] = 1;
  }

  const Item* peek(std::size_t side, std::size_t place) {
    std::deque<std::unique_ptr<Item>>& waiting = waiting_[side];
    while (waiting.size() <= place && ends_[side] == nullptr) {
      std::unique_ptr<Item> item = channels_[side].take();
      (item->is_end ? ends_[side] : waiting.emplace_back()) = std::move(item);
    }
    return place < waiting.size() ? waiting[place].get() : nullptr;
  }
  std::unique_ptr<Item> take(std::size_t side) {
    std::unique_ptr<Item> out = std::move(waiting_[side].front());
    waiting_[side].pop_front();
    return out;
  }

  std::array<Channel<Item>, 2>& channels_;
  std::array<std::deque<std::unique_ptr<Item>>, 2> waiting_;
  std::array<std::unique_ptr<Item>, 2> ends_;
  std::array<std::size_t, 2> alone_{};
  bool both_ = false;
};

}  // namespace isogloss::cli::parting
