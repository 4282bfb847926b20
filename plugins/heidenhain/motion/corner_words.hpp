/// RND R5 and CHF 2: the size of a corner between two moves. Positions are byte offsets into the text of the block;
/// sizes are in the unit of the program as written, and in mm in the block.
#pragma once

#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"
#include "motion/feed_words.hpp"
#include "motion/path_function.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that reads path blocks.
class CornerWords {
 public:
  /// The size at `position`, with the R of RND before it; not ok where it is missing.
  Value size(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
             PathFunction function) const;
  /// F of a corner at `position`, which counts in its block alone: F100, F AUTO; F MAX is reported. Without a value it
  /// has no effect. Returns the position after it.
  std::size_t feed(ig::Block& b, const Values& values, const FeedWords& words, std::string_view text,
                   std::size_t position, PathFunction function) const;
  /// Sets the corner of the block; one that is less than 0 is reported at `where`, and stays sharp.
  void set(ig::Block& b, PathFunction function, double size, ig::Where where) const;

 private:
  ig::Out<double> radius_{"KlartextCorner.Radius_mm", {ig::Life::block, "mm", "RND R"}};
  ig::Out<double> chamfer_{"KlartextCorner.Chamfer_mm", {ig::Life::block, "mm", "CHF"}};
  ig::Out<double> feed_mmds_{"KlartextCorner.Feedrate_mmds", {ig::Life::block, "mm/s", "F of RND or CHF"}};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ProgramUnit unit_;
};

}  // namespace heidenhain
