/// The programmable frame that a block assigns, $P_PFRAME=CTRANS(X,10), on the way from the word to the frame in force.
#pragma once

#include <optional>

#include <isogloss/sdk.hpp>

#include "frames/frame_value.hpp"

namespace siemens {

class AssignedFrame {
 public:
  explicit AssignedFrame(ig::Access access)
      : links_{"ProgrammableFrame.Assigned",
               access,
               {ig::Life::block, "", "$P_PFRAME=…: the frame's links, lengths in the unit of the program."}} {}

  void set(ig::Block& b, const FrameValue& frame) const { b.set_text(links_, frame.text()); }
  /// Nothing where the block assigns none.
  std::optional<FrameValue> get(const ig::Block& b) const {
    return b.is_fresh(links_) ? FrameValue::read(b.text(links_)) : std::nullopt;
  }

 private:
  ig::TextField links_;
};

}  // namespace siemens
