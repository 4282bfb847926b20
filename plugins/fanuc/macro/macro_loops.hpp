/// The loops that the run is in: each DO whose END has not been reached, by frame.
#pragma once

#include <isogloss/sdk.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <isogloss/flow.hpp>

namespace fanuc {

class MacroLoops {
 public:
  struct Loop {
    std::int64_t number;
    ig_place place;
    bool jumped = false;  ///< a GOTO was executed since: it may have left the loop
  };

  void clear() { *this = {}; }
  /// The loops of the present frame, outer ones first. Drops those of frames that have ended.
  std::span<Loop> own(ig::Block& b, const ig::Flow& flow) {
    const ig_frame frame = flow.frame(b);
    if (frame.id != frame_ || frame.pass != pass_) enter_frame(b, flow, frame);
    const auto first =
        std::find_if(open_.begin(), open_.end(), [&](const Loop& l) { return l.place.frame == frame.id; });
    return {first, open_.end()};
  }
  void begin(std::int64_t number, const ig_place& place) { open_.push_back({number, place}); }
  void end_innermost() { open_.pop_back(); }
  /// Removes the loop of this number and the loops inside it.
  void leave(ig::Block& b, const ig::Flow& flow, std::int64_t number) {
    const std::span<Loop> open = own(b, flow);
    for (std::size_t i = 0; i < open.size(); ++i)
      if (open[i].number == number) {
        open_.erase(open_.end() - static_cast<std::ptrdiff_t>(open.size() - i), open_.end());
        return;
      }
  }

  /// Removes the loops of the present frame, whose program ends in this block.
  void end_frame(ig::Block& b, const ig::Flow& flow) {
    own(b, flow);
    std::erase_if(open_, [&](const Loop& l) { return l.place.frame == frame_; });
  }

 private:
  void enter_frame(ig::Block& b, const ig::Flow& flow, const ig_frame& frame) {
    const auto is_open = [&](std::uint64_t id) {
      for (std::uint32_t level = 0; level <= frame.depth; ++level)
        if (const auto open = flow.frame(b, level); open && open->id == id) return true;
      return false;
    };
    std::erase_if(open_, [&](const Loop& l) {
      return !is_open(l.place.frame) || (l.place.frame == frame.id && frame.pass != pass_ && frame.id == frame_);
    });
    frame_ = frame.id;
    pass_ = frame.pass;
  }

  std::vector<Loop> open_;  // by frame, outer ones first
  std::uint64_t frame_ = 0;
  std::uint32_t pass_ = 1;
};

}  // namespace fanuc
