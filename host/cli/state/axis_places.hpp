/// Which axes of the program a run has brought to a place that the program itself gives: any other place is an
/// assumption about offsets, lengths or the machine, and no restart may move an axis there.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "isogloss/engine/motion.hpp"

namespace isogloss::cli {

enum class AxisPlace : std::uint8_t {
  unknown,    ///< no block has given it a position
  program,    ///< a coordinate of the program
  machine,    ///< a coordinate of the machine, without offsets
  reference,  ///< the reference point
};

/// Follows the blocks of a run.
class AxisPlaces {
 public:
  /// By axis X Y Z.
  using Places = std::array<AxisPlace, 3>;

  AxisPlaces();
  void begin(Document& initial, const SymbolTable& symbols);
  void block(Document& document, const SymbolTable& symbols);
  const Places& places() const { return places_; }

 private:
  /// Fields of one axis.
  struct Axis {
    ig_field program = IG_NO_FIELD, machine = IG_NO_FIELD;
    std::vector<ig_field> words;  ///< of the block, that name it
    double was = 0;               ///< program coordinate before the block
  };
  static bool has_word(const Document& document, const Axis& axis);

  std::unique_ptr<Exporter> motions_;
  std::array<Axis, 3> axes_;
  std::vector<ig_field> reference_;  ///< fields that tell of a return to the reference point
  ig_field distance_ = IG_NO_FIELD;
  Places places_{};
  bool moves_ = false;  ///< the block
};

}  // namespace isogloss::cli
