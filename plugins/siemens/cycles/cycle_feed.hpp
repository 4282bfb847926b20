/// The feed of cycles and threads, whose steps have no length before they are made.
#pragma once

#include <optional>

#include <isogloss/sdk.hpp>

namespace siemens {

/// The feed in force, as FeedrateSyntax writes it. A member of each syntax whose steps move by feed.
class CycleFeed {
 public:
  /// The feed `own`, or the F in force, in mm/s; 0 where it is not known. Under G93 it is not: a step has no length.
  double mmds(const ig::Block& b, std::optional<double> own = std::nullopt) const {
    const double f = own.value_or(b.get_or(value_, 0.0));
    if (!(f > 0)) return 0;
    if (b.is(term_, g95_)) return f * b.get_or(rpm_, 0.0) / 60;
    return b.is(term_, g93_) ? 0 : f / 60;
  }
  double rpm(const ig::Block& b) const { return b.get_or(rpm_, 0.0); }

 private:
  ig::In<double> value_{"Feedrate.FeedrateValue"};
  ig::In<ig::Symbol> term_{"Feedrate.Term"};
  ig::In<double> rpm_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Name g93_{"G93"}, g95_{"G95"};
};

}  // namespace siemens
