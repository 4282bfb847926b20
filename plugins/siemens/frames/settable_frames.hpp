/// The codes of the settable frames: G500, G54 to G57, G505 to G599.
#pragma once

#include <string>
#include <vector>

#include <isogloss/sdk.hpp>

namespace siemens {

/// A member of each syntax that depends on the settable frame.
class SettableFrames {
 public:
  explicit SettableFrames(ig::Access access) {
    for (std::size_t i = 0; i < 5 + further; ++i) {
      const std::string name = name_of(i);
      ids_.push_back(ig::Codes({std::string_view(name)}, access).id(0));
      names_.push_back(ig::Name(name));
    }
  }
  /// The code in this block, if there is one.
  std::optional<std::size_t> find(const ig::Block& b) const {
    std::uint32_t found = 0;
    return some(b.find_code(ids_.data(), static_cast<std::uint32_t>(ids_.size()), &found));
  }
  std::optional<std::size_t> take(ig::Block& b) const {
    std::uint32_t found = 0;
    return some(b.take_code(ids_.data(), static_cast<std::uint32_t>(ids_.size()), &found));
  }
  ig::Symbol name(std::size_t i) const { return names_[i]; }
  ig_field id(std::size_t i) const { return ids_[i]; }

 private:
  static constexpr std::size_t further = 95;  // G505 to G599
  static std::string name_of(std::size_t i) {
    static constexpr std::array<std::string_view, 5> first{"G500", "G54", "G55", "G56", "G57"};
    return i < first.size() ? std::string(first[i]) : "G" + std::to_string(505 + i - first.size());
  }
  static std::optional<std::size_t> some(std::int32_t code) {
    return code < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(code));
  }

  std::vector<ig_field> ids_;
  std::vector<ig::Symbol> names_;
};

}  // namespace siemens
