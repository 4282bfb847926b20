/// The units of lengths and feeds in the program, mm or inch, as BEGIN PGM names it.
#pragma once

#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

/// A member of each syntax that reads lengths.
class ProgramUnit {
 public:
  bool is_inch(const ig::Block& b) const { return b.is(system_, inch_); }
  /// Multiply a length of the program by it to get mm.
  double in_mm(const ig::Block& b) const { return is_inch(b) ? ig::cnc::mm_per_inch : 1; }

 private:
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
};

/// A member of each syntax that reads a feed: what F counts in an inch program is an option.
class FeedUnit {
 public:
  /// The feed in the unit of the program: mm/min, or inch/min in an inch program.
  double in_unit(const ig::Block& b, double feed) const { return is_in_tenths(b) ? feed / 10 : feed; }
  double as_written(const ig::Block& b, double feed) const { return is_in_tenths(b) ? feed * 10 : feed; }
  double in_mm(const ig::Block& b, double feed) const { return in_unit(b, feed) * unit_.in_mm(b); }

 private:
  enum class InchFeed { tenths, inches };

  bool is_in_tenths(const ig::Block& b) const { return inch_feed_ == InchFeed::tenths && unit_.is_inch(b); }

  ProgramUnit unit_;
  ig::Choice<InchFeed> inch_feed_{"inch-feed", "tenths|inches", "tenths",
                                  "The unit of F in an inch program: tenths of an inch a minute, or inches a minute."};
};

}  // namespace heidenhain
