/// M00/M01: the program stops until the operator goes on. M01 only where the operator asked for optional stops.

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct ProgramStop {
  static constexpr auto spec = ig::syntax("ProgramStopSyntax", "M00 stop, M01 optional stop.");

  ig::Codes stop_{"M00"};
  ig::Codes optional_stop_{"M01"};
  ig::Out<ig::Symbol> term_{"ProgramStop.Term"};
  ig::Setting setting_{"optional-stop"};

  ig::Status build(ig::Block& b) {
    const bool stop = b.take(stop_).has_value();
    const bool optional_stop = b.take(optional_stop_).has_value();
    if (stop) {
      b.set(term_, stop_.name(0));
    } else if (optional_stop && is_on()) {
      b.set(term_, optional_stop_.name(0));
    }
    return stop || optional_stop ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool is_on() const { return !setting_.text().empty() && setting_.text() != "off"; }
};

const ig::Register<ProgramStop> program_stop_syntax;

}  // namespace
}  // namespace iso
