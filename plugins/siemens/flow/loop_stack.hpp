/// The loops and repeats that the run is in, the innermost last.
#pragma once

#include <isogloss/flow.hpp>

#include <vector>

namespace siemens {

enum class LoopKind : std::uint8_t { while_, for_, loop, until, section };

struct Loop {
  LoopKind kind;
  std::uint64_t frame;
  std::uint32_t pass;
  std::int64_t line;
  ig_place place;
  bool goes_on = false;       ///< its end has sent the run back to its beginning
  bool jumped = false;        ///< a GOTO was executed in it: the loop may have been left
  std::int64_t end_line = 0;  ///< 0: not reached yet
  double left = 0;            ///< repeats of a section that are still to be made
  std::string until;          ///< the label after which the section ends
};

class LoopStack {
 public:
  static constexpr std::size_t deepest = 1000;

  void clear() { loops_.clear(); }
  /// Drops the loops of programs that have ended.
  void enter(const ig_frame& frame) {
    while (!loops_.empty() &&
           (loops_.back().frame > frame.id || (loops_.back().frame == frame.id && loops_.back().pass != frame.pass)))
      loops_.pop_back();
  }
  /// The loop that begins at this line of the frame, made the innermost one; null where it is not running.
  Loop* at_line(std::uint64_t frame, std::int64_t line, LoopKind kind) {
    for (std::size_t i = loops_.size(); i-- > 0 && loops_[i].frame == frame;)
      if (loops_[i].line == line && loops_[i].kind == kind) {
        loops_.resize(i + 1);
        return &loops_[i];
      }
    return nullptr;
  }
  /// The loop of that kind that ends at this line. `doubtful` is set where another one may be meant.
  Loop* ending(std::uint64_t frame, std::int64_t line, LoopKind kind, bool& doubtful) {
    doubtful = false;
    while (!loops_.empty() && loops_.back().frame == frame) {
      Loop& loop = loops_.back();
      const bool fits = loop.kind == kind && loop.line < line && (loop.end_line == 0 || loop.end_line == line);
      if (!fits) {
        loops_.pop_back();
        continue;
      }
      doubtful = loop.end_line == 0 && loop.jumped && has_outer(frame, kind);
      loop.end_line = line;
      return &loop;
    }
    return nullptr;
  }
  Loop* innermost(std::uint64_t frame) {
    return loops_.empty() || loops_.back().frame != frame ? nullptr : &loops_.back();
  }
  bool push(Loop loop) {
    if (loops_.size() >= deepest) return false;
    loops_.push_back(std::move(loop));
    return true;
  }
  void pop() { loops_.pop_back(); }
  void note_jump(std::uint64_t frame) {
    for (std::size_t i = loops_.size(); i-- > 0 && loops_[i].frame == frame;) loops_[i].jumped = true;
  }

 private:
  bool has_outer(std::uint64_t frame, LoopKind kind) const {
    for (std::size_t i = loops_.size() - 1; i-- > 0 && loops_[i].frame == frame;)
      if (loops_[i].kind == kind) return true;
    return false;
  }
  std::vector<Loop> loops_;
};

}  // namespace siemens
