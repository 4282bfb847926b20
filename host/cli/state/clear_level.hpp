/// How far a restart may go down by rapid: to the level where the program itself has crossed the part by rapid.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "isogloss/engine/motion.hpp"

namespace isogloss::cli {

/// Follows the moves of a run. A level is a program coordinate, in mm, in the frame of the last block.
class ClearLevel {
 public:
  /// By axis X Y Z, each taken as the tool axis; empty: the program has come to its last point by rapid, or has stood
  /// no higher in this frame.
  using Point = std::array<std::optional<double>, 3>;

  ClearLevel();
  void begin(Document& initial, const SymbolTable& symbols) { motions_->begin(initial, symbols); }
  void block(Document& document, const SymbolTable& symbols);
  Point at_point() const;
  /// Where the tool stands since a frame has changed under it; empty: no frame has changed after the last move.
  Point place() const;

 private:
  bool move(const Motion& m);
  void forget();

  std::unique_ptr<Exporter> motions_;
  bool is_known_ = false;   // at_ is a point of the frame in force
  bool was_rapid_ = false;  // the last move
  bool is_mapped_ = false;  // at_ comes from the machine's position
  unsigned moves_ = 0;      // of the block
  MotionPoint machine_;
  std::array<double, 3> at_{};
  Point crossed_, highest_;
};

}  // namespace isogloss::cli
