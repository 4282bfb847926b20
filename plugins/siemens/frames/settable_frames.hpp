/// The settable frames and their codes: number 0 is G500, 1 to 4 are G54 to G57, 5 to 99 are G505 to G599.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

inline constexpr std::int64_t settable_frames = 100;

/// The code of the settable frame $P_UIFR[number].
constexpr std::int64_t settable_code(std::int64_t number) {
  return number == 0 || number > 4 ? 500 + number : 53 + number;
}
/// The number of the settable frame with that code.
constexpr std::int64_t settable_number(std::int64_t code) { return code >= 500 ? code - 500 : code - 53; }

/// A member of each syntax that depends on the settable frame: which one is selected, and whether it may have changed.
class SettableFrames {
 public:
  explicit SettableFrames(ig::Access access) {
    for (std::int64_t n = 0; n < settable_frames; ++n) {
      const std::string name = "G" + std::to_string(settable_code(n));
      ids_.push_back(ig::Codes({std::string_view(name)}, access).id(0));
      names_.push_back(ig::Name(name));
    }
  }
  /// The code in this block, if there is one.
  std::optional<std::size_t> find(const ig::Block& b) const {
    return some(b.find_code(ids_.data(), static_cast<std::uint32_t>(ids_.size())));
  }
  /// Takes the codes of the block, of which the last one counts; several are reported.
  void take(ig::Block& b) const {
    std::uint32_t found = 0;
    const auto last = some(b.take_code(ids_.data(), static_cast<std::uint32_t>(ids_.size()), &found));
    if (last && found > 1) b.report(ig::diag("ISO-0201"), ig::Where::word(ids_[*last]), b.text(names_[*last]));
  }
  ig::Symbol name(std::size_t i) const { return names_[i]; }
  ig_field id(std::size_t i) const { return ids_[i]; }

  /// The frame in force after the codes of the block, and where a diagnostic about it belongs.
  struct Selected {
    ig::Symbol id;
    ig::Where where;
  };
  Selected in_force(const ig::Block& b) const {
    return {b.get_or(id_, static_cast<ig::Symbol>(g500_)), ig::Where::block()};
  }
  Selected selected(const ig::Block& b) const {
    const auto code = find(b);
    return code ? Selected{names_[*code], ig::Where::word(ids_[*code])} : in_force(b);
  }
  /// The same where a code of the block selects a frame, or the table of frames has changed.
  std::optional<Selected> changed(const ig::Block& b) const {
    return find(b) || b.is_raised(table_changed_) ? std::optional(selected(b)) : std::nullopt;
  }

 private:
  static std::optional<std::size_t> some(std::int32_t code) {
    return code < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(code));
  }

  std::vector<ig_field> ids_;
  std::vector<ig::Symbol> names_;
  ig::In<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  ig::Signal table_changed_{"CoordinateOffset.~TableChanged", ig::read | ig::wake};
  ig::Name g500_{"G500"};
};

}  // namespace siemens
