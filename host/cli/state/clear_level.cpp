#include "state/clear_level.hpp"

#include <algorithm>
#include <cmath>

#include "isogloss/engine/document.hpp"

namespace isogloss::cli {

namespace {
constexpr double same_place_mm = 1e-6;
}

ClearLevel::ClearLevel()
    : motions_(make_motion_listener([this](const Motion& m) { return move(m); }, {.zero_moves = true})) {}

void ClearLevel::block(Document& document, const SymbolTable& symbols) {
  if (document.frame_changed) forget();
  moves_ = 0;
  motions_->block(document, symbols);
  // The same place of the machine is another one of the program.
  if (document.frame_changed && moves_ == 0 && (machine_.known & 7u) == 7u) {
    double point[3];
    is_known_ = document.map_to_program({machine_.at[0], machine_.at[1], machine_.at[2]}, point);
    if (is_known_) std::copy_n(point, 3, at_.begin());
    is_mapped_ = is_known_;
  }
}

void ClearLevel::forget() {
  is_known_ = false;
  crossed_ = highest_ = {};
}

bool ClearLevel::move(const Motion& m) {
  if (m.event > Motion::Event::arc) return true;
  was_rapid_ = m.event == Motion::Event::rapid;
  ++moves_;
  machine_ = m.machine;
  is_mapped_ = false;
  for (unsigned axis = 3; axis < 6 && !m.is_led; ++axis)  // the workpiece has turned under the tool
    if (m.machine.has(axis) && m.machine_start.has(axis) && m.machine.at[axis] != m.machine_start.at[axis]) forget();
  if ((m.program.known & 7u) != 7u) return true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double goal = m.program.at[axis];
    highest_[axis] = std::max(highest_[axis].value_or(goal), goal);
    if (!was_rapid_ || !is_known_) continue;
    bool is_across = false;
    for (std::size_t other = 0; other < 3; ++other)
      is_across |= other != axis && std::abs(m.program.at[other] - at_[other]) > same_place_mm;
    if (is_across || goal > at_[axis]) crossed_[axis] = std::max(goal, at_[axis]);
  }
  std::copy_n(m.program.at, 3, at_.begin());
  is_known_ = true;
  return true;
}

ClearLevel::Point ClearLevel::place() const {
  Point out;
  for (std::size_t axis = 0; is_mapped_ && axis < 3; ++axis) out[axis] = at_[axis];
  return out;
}

ClearLevel::Point ClearLevel::at_point() const {
  Point out;
  for (std::size_t axis = 0; is_known_ && !was_rapid_ && axis < 3; ++axis) {
    const double level = crossed_[axis].value_or(highest_[axis].value_or(at_[axis]));
    if (level > at_[axis] + same_place_mm) out[axis] = level;
  }
  return out;
}

}  // namespace isogloss::cli
