/// Two runs that should make the same motions and say the same, for all practical purposes.
#pragma once

#include <string>

#include "events.hpp"

namespace isogloss::properties {

struct Heard {
  Events events;
  DiagnosticList said;
};

Heard heard(const Case& program, const std::string& text);

/// Where F counts degrees, it is another number of mm per second in another unit of length.
enum class RotaryFeeds { compared, left_out };

/// What differs, up to rounding; empty: nothing. Of diagnostics, codes and lines are compared. `first` and `second`
/// name the runs for people.
std::string difference_of(const Heard& one, const Heard& other, const std::string& first, const std::string& second,
                          RotaryFeeds feeds = RotaryFeeds::compared);

}  // namespace isogloss::properties
