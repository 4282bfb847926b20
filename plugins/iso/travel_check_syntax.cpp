/// The travel of the machine's axes: every position of a block against the limits that the machine declares. A machine
/// without limits costs nothing.
#include "rotary_words.hpp"

namespace iso {
namespace {

struct TravelCheck {
  static constexpr auto spec = ig::syntax("TravelCheckSyntax", "Reports positions outside the travel of an axis.")
                                   .after("McXyzSyntax", "McAbcCyclicPathSyntax", "LinearMotionSyntax",
                                          "ReturnFromReferenceSyntax", "ReferenceReturnSyntax", "ReferenceCheckSyntax");

  static constexpr std::string_view names = "XYZABC";
  using Axes = std::array<ig_field, names.size()>;
  Axes position_ = each("MachineCoordinate.", ig::read | ig::wake);
  Axes step_ = each("CompoundMotion.Items[].MachineCoordinate.", ig::read);
  /// The axes of which it was said: until they are back inside.
  std::array<ig::Signal, names.size()> outside_{outside('X'), outside('Y'), outside('Z'),
                                                outside('A'), outside('B'), outside('C')};
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The limits."};
  std::array<AngleRange, names.size()> travel_;
  std::uint32_t limited_ = 0;  // a bit for each axis

  TravelCheck() {
    for (std::size_t axis = 0; machine_ && axis < names.size(); ++axis) {
      AngleRange travel;
      if (machine_->travel(machine_->self, names[axis], &travel.minimum, &travel.maximum) == 0) continue;
      travel_[axis] = travel;
      limited_ |= 1u << axis;
    }
    if (limited_ == 0) ig::stay_idle();
  }

  ig::Status build(ig::Block& b) const {
    const std::uint32_t before = outside(b);
    std::uint32_t now = before;
    ig_value at[names.size()];
    for (std::uint32_t step = 0, n = b.host()->count(b.raw(), step_[0]); step < n; ++step)
      now = check(b, b.host()->record(b.raw(), step, step_.data(), names.size(), at), at, now);
    const std::uint32_t fresh = b.host()->fresh_many(b.raw(), position_.data(), names.size());
    now = check(b, fresh & b.host()->get_many(b.raw(), position_.data(), names.size(), at), at, now);
    if (now == before) return ig::Status::unchanged;
    for (std::size_t axis = 0; axis < names.size(); ++axis) {
      const std::uint32_t bit = 1u << axis;
      if ((now & ~before & bit) != 0) b.raise(outside_[axis]);
      if ((before & ~now & bit) != 0) b.erase(outside_[axis]);
    }
    return ig::Status::changed;
  }

 private:
  std::uint32_t outside(const ig::Block& b) const {
    std::uint32_t mask = 0;
    for (std::size_t axis = 0; axis < names.size(); ++axis)
      if ((limited_ >> axis & 1u) != 0 && b.is_raised(outside_[axis])) mask |= 1u << axis;
    return mask;
  }

  /// The axes that are outside after this position; an axis that it does not name stays as it was.
  std::uint32_t check(ig::Block& b, std::uint32_t named, const ig_value* at, std::uint32_t outside) const {
    for (std::size_t axis = 0; axis < names.size(); ++axis) {
      const std::uint32_t bit = 1u << axis;
      if ((named & limited_ & bit) == 0) continue;
      const double position = at[axis].number;
      const AngleRange& travel = travel_[axis];
      if (travel.holds(position)) {
        outside &= ~bit;
        continue;
      }
      if ((outside & bit) == 0)
        b.report(rotary_diag("ISO-0403"), ig::Where::block(), names.substr(axis, 1), position,
                 position > travel.maximum ? travel.maximum : travel.minimum);
      outside |= bit;
    }
    return outside;
  }

  static Axes each(std::string_view section, ig::Access access) {
    Axes ids{};
    for (std::size_t axis = 0; axis < names.size(); ++axis)
      ids[axis] = ig::Field<double>(std::string(section) + names[axis], access).id();
    return ids;
  }
  static ig::Signal outside(char axis) {
    return {std::string("TravelCheck.~Outside") + axis, ig::read | ig::write, ig::Life::modal};
  }
};

const ig::Register<TravelCheck> registered;

}  // namespace
}  // namespace iso
