/// The unit of lengths in the program, mm or inch, as BEGIN PGM names it.
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

}  // namespace heidenhain
