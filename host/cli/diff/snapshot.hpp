/// A finished block, copied out of its run: what the other side's block is compared with.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss::cli::parting {

/// Where a block stands: two blocks with the same key are compared. Called programs are told apart by the way there.
struct Key {
  std::uint64_t way = 0;  ///< of the calls that led here, and of the file
  std::uint32_t depth = 0;
  std::uint32_t rank = 0;   ///< the line; of two programs, the place in an order that holds the lines of both
  std::uint32_t place = 0;  ///< in the line
  friend bool operator==(const Key&, const Key&) = default;
};

struct Cell {
  enum class Kind : std::uint8_t { absent, number, text, code, matrix };
  std::uint32_t field = 0;
  std::uint16_t writer = 0;  ///< chain position + 1; 0: the host
  Kind kind = Kind::absent;
  bool is_fresh = false;
  double number = 0;      ///< of a matrix: its place in Snapshot::matrices
  std::string_view text;  ///< into the snapshot, or of the run's table of names
};

/// A record of a list: a stroke of a cycle.
struct Stroke {
  std::uint32_t begin = 0, end = 0;  ///< in Snapshot::stroke_cells
};

struct StrokeList {
  std::uint32_t list = 0;
  std::uint16_t maker = 0;  ///< chain position + 1 of the syntax that added records
  std::vector<Stroke> strokes;
};

/// A cell of a row that has a value.
struct RowCell {
  std::string column;
  std::string given;  ///< as the table holds it
  std::string shown;  ///< in the unit, which follows
  std::string unit;   ///< of a number; empty: none is known
  double scale = 1;   ///< the number that is given times this is in the unit
};

/// A row as people read it.
struct RowText {
  std::string title;   ///< "peck clearance"; empty: the table does not say
  std::string prefix;  ///< "Pr"
  std::string name;    ///< "Pr4002"; with the name of its table where it has no title
  std::string value;   ///< "0.5 mm", "X=0 mm Y=0 mm"
  std::vector<RowCell> cells;
};

/// A row of a table that has answered a syntax in this block.
struct AskedRow {
  std::uint16_t syntax = 0;  ///< chain position + 1
  std::size_t dependency = 0;
  std::string row;
  std::shared_ptr<const RowText> text;
};

struct Snapshot {
  Key key;
  std::string file, text;
  std::uint32_t line = 0, column = 0;
  bool is_initial = false;  ///< the state before the first block
  bool is_end = false;      ///< no block: what was reported after the last one
  std::string fault;        ///< of the end: why the run could not go on
  std::vector<Cell> cells;  ///< by field
  std::vector<Cell> stroke_cells;
  std::vector<StrokeList> lists;
  std::vector<std::array<double, 16>> matrices;
  std::vector<std::uint16_t> called;  ///< chain positions, in their order
  std::vector<AskedRow> rows;
  std::vector<Diagnostic> reported;
  std::string arena;
};

/// Blocks on their way from a run to the comparison: a few hundred at most, so that both runs go in step.
template <class Item>
class Channel {
 public:
  /// False: nobody reads any more.
  bool put(std::unique_ptr<Item> item) {
    std::unique_lock lock(mutex_);
    has_room_.wait(lock, [this] { return is_closed_ || items_.size() < most_; });
    if (is_closed_) return false;
    items_.push_back(std::move(item));
    ++puts_;
    if (items_.size() >= most_ / 2 || items_.back()->is_end) has_items_.notify_one();
    return true;
  }
  std::unique_ptr<Item> take() {
    if (taken_.empty()) {
      std::unique_lock lock(mutex_);
      wait_for_items(lock);
      taken_.swap(items_);
      has_room_.notify_one();
    }
    std::unique_ptr<Item> out = std::move(taken_.front());
    taken_.pop_front();
    return out;
  }
  /// From now on `stalled` is called when take() has waited so long and nothing came; 0 seconds: never.
  void watch(unsigned seconds, std::function<void()> stalled) {
    patience_ = std::chrono::seconds(seconds);
    stalled_ = std::move(stalled);
  }
  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    has_room_.notify_all();
  }
  /// An item to fill again, with the memory that it has.
  std::unique_ptr<Item> blank() {
    const std::lock_guard lock(spare_mutex_);
    if (spare_.empty()) return std::make_unique<Item>();
    std::unique_ptr<Item> out = std::move(spare_.back());
    spare_.pop_back();
    return out;
  }
  void give_back(std::unique_ptr<Item> item) {
    const std::lock_guard lock(spare_mutex_);
    if (spare_.size() < most_) spare_.push_back(std::move(item));
  }

 private:
  void wait_for_items(std::unique_lock<std::mutex>& lock) {
    const auto is_there = [this] { return items_.size() >= most_ / 2 || (!items_.empty() && items_.back()->is_end); };
    if (patience_.count() == 0) return has_items_.wait(lock, is_there);
    while (true) {
      const std::uint64_t before = puts_;
      if (has_items_.wait_for(lock, patience_, is_there)) return;
      if (puts_ == before) stalled_();
    }
  }

  static constexpr std::size_t most_ = 128;
  std::mutex mutex_, spare_mutex_;
  std::condition_variable has_room_, has_items_;
  std::deque<std::unique_ptr<Item>> items_, taken_;  // taken_ belongs to the reader
  std::vector<std::unique_ptr<Item>> spare_;
  bool is_closed_ = false;
  std::uint64_t puts_ = 0;
  std::chrono::seconds patience_{0};
  std::function<void()> stalled_;
};

}  // namespace isogloss::cli::parting
