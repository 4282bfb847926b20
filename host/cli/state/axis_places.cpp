#include "state/axis_places.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace isogloss::cli {

namespace {

constexpr double same_coordinate_mm = 1e-9;

/// The axis that the last part of the path names: 0 for "Parsing.X" and "Parsing.G81.X"; 3: none.
std::size_t named_axis(std::string_view path) {
  const std::string_view leaf = path.substr(path.rfind('.') + 1);
  return leaf.size() == 1 && leaf[0] >= 'X' && leaf[0] <= 'Z' ? static_cast<std::size_t>(leaf[0] - 'X') : 3;
}

}  // namespace

AxisPlaces::AxisPlaces()
    : motions_(make_motion_listener(
          [this](const Motion& m) {
            moves_ |= m.event <= Motion::Event::arc;
            return true;
          },
          {.zero_moves = true})) {}

void AxisPlaces::begin(Document& initial, const SymbolTable& symbols) {
  motions_->begin(initial, symbols);
  const Layout& layout = initial.layout();
  for (std::size_t i = 0; i < 3; ++i) {
    axes_[i].program = layout.id(std::string("ProgramXyz.") + "XYZ"[i]);
    axes_[i].machine = layout.id(std::string("MachineCoordinate.") + "XYZ"[i]);
    if (initial.present(axes_[i].program)) axes_[i].was = initial.number(axes_[i].program);
  }
  distance_ = layout.id("PositioningMode.Mode");
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    const std::string& path = layout.fields[f].path;
    if (path.starts_with("ReferenceReturn.") && layout.fields[f].type != IG_SWITCH) reference_.push_back(f);
    if (const std::size_t axis = named_axis(path); axis < 3 && layout.is_word(f)) axes_[axis].words.push_back(f);
  }
}

bool AxisPlaces::has_word(const Document& document, const Axis& axis) {
  return std::any_of(axis.words.begin(), axis.words.end(), [&](ig_field f) { return document.taken(f); });
}

void AxisPlaces::block(Document& document, const SymbolTable& symbols) {
  moves_ = false;
  motions_->block(document, symbols);
  const bool returns = std::any_of(reference_.begin(), reference_.end(), [&](ig_field f) { return document.fresh(f); });
  const bool is_incremental = document.present(distance_) &&
                              symbols.text(static_cast<ig_symbol>(document.value(distance_).symbol)) == "Incremental";
  for (std::size_t i = 0; i < 3; ++i) {
    Axis& axis = axes_[i];
    if (!document.present(axis.program)) continue;
    const double now = document.number(axis.program);
    const bool goes = std::abs(now - axis.was) > same_coordinate_mm && !document.frame_changed;
    axis.was = now;
    if (!moves_ || !(goes || has_word(document, axis))) continue;
    // A syntax that writes both places has its goal in the machine, and no offset acts.
    const bool is_direct = document.fresh(axis.machine) && document.fresh(axis.program) &&
                           document.writer(axis.machine) == document.writer(axis.program);
    if (returns)
      places_[i] = AxisPlace::reference;
    else if (is_direct)
      places_[i] = AxisPlace::machine;
    else if (!is_incremental)
      places_[i] = AxisPlace::program;
  }
}

}  // namespace isogloss::cli
