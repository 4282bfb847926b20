/// The codes of inch and metric input: G20 and G21, and G70 and G71 on controls that have them (Syntec).
#pragma once

#include <optional>

#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that asks for the unit of its block, or takes its code.
class UnitCodes {
 public:
  explicit UnitCodes(ig::Access access) : usual_{{"G20", "G21"}, access}, further_{{"G70", "G71"}, access} {}

  struct Found {
    bool is_inch;
    ig::Symbol name;
  };
  std::optional<Found> find(const ig::Block& b) const {
    if (further_codes_ == Further::g70_g71)
      if (const auto code = b.find(further_)) return Found{*code == 0, further_.name(*code)};
    if (const auto code = b.find(usual_)) return Found{*code == 0, usual_.name(*code)};
    return std::nullopt;
  }
  /// Of several codes the last one of a pair is in force, and G70 and G71 come before G20 and G21.
  std::optional<Found> take(ig::Block& b) const {
    std::optional<Found> found;
    if (const auto code = take_modal(b, usual_)) found = Found{*code == 0, usual_.name(*code)};
    if (further_codes_ == Further::g70_g71)
      if (const auto code = take_modal(b, further_)) found = Found{*code == 0, further_.name(*code)};
    return found;
  }

 private:
  enum class Further { none, g70_g71 };

  ig::Codes usual_, further_;
  ig::Choice<Further> further_codes_{"unit-codes", "G20-G21|G20-G21-G70-G71", "G20-G21",
                                     "The codes of inch and metric input: G20 and G21, or G70 and G71 too."};
};

}  // namespace iso
