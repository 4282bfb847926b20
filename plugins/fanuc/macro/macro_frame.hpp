/// Which local variables are the present ones: those of the macro call that the block's frame belongs to.
#pragma once

#include <array>
#include <charconv>
#include <cmath>

#include <isogloss/cnc/frame_tag.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/provenance.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace fanuc {

using namespace ig::cnc;

/// A member, or the base, of what reads and writes variables.
class MacroFrame {
 public:
  ig::Flow flow;

  /// Before the first expression of a block: the local variables are those of its macro call.
  void enter(const ig::Block& b) const {
    const ig_frame frame = flow.frame(b);
    if (store_->is_new_frame(frame.id, frame.pass)) select_level(b, frame);
  }

  MacroStore& store() const { return *store_; }

  /// Does anybody want to know which variables a block reads and writes?
  bool is_heard() const { return used_.is_heard(); }
  void note_read(ig::Block& b, std::uint32_t number, double value) const {
    if (number != 0) used_.read(b, name_of(number).data(), value, store_->scope_of(number));
  }
  void note_write(ig::Block& b, std::uint32_t number, double value) const {
    used_.wrote(b, name_of(number).data(), value, store_->scope_of(number));
  }
  /// A condition, as the program writes it, has been examined.
  void note_condition(ig::Block& b, std::string_view text, bool holds) const { examined_.add(b, text, holds); }
  /// What the call of this tag gives to the local variables of the macro.
  void note_arguments(ig::Block& b, std::uint64_t tag, const MacroStore::Locals& arguments) const {
    if (!is_heard()) return;
    for (std::uint32_t number = 1; number < arguments.size(); ++number)
      if (!std::isnan(arguments[number])) used_.wrote(b, name_of(number).data(), arguments[number], tag);
  }

  /// A program that a code called sees all codes as they are.
  bool is_in_bound_program(const ig::Block& b) const {
    const ig_frame frame = flow.frame(b);
    for (std::uint32_t level = 1; level <= frame.depth; ++level)
      if (const auto at = flow.frame(b, level); at && (at->tag & called_by_code) != 0) return true;
    return false;
  }

 private:
  static std::array<char, 12> name_of(std::uint32_t number) {
    std::array<char, 12> out{'#'};
    std::to_chars(out.data() + 1, out.data() + out.size() - 1, number);
    return out;
  }

  void select_level(const ig::Block& b, const ig_frame& frame) const {
    ig_frame at = frame;
    for (std::uint32_t level = frame.depth; level > 0 && !has_locals(at);) {
      const auto below = flow.frame(b, --level);
      if (!below) break;
      at = *below;
    }
    store_->select(at.depth == 0 ? 0 : at.tag & ~called_by_code, at.depth == 0 ? 1 : at.pass);
  }
  static bool has_locals(const ig_frame& frame) {
    return (frame.tag & ~begins_inside) != 0 && (frame.tag & shares_locals) == 0;
  }

  /// The service of MacroVariables; a store of its own where a dialect has none.
  class Store {
   public:
    Store() : service_(macro_store_service, ig::Need::optional, "What macro programs read and write.") {
      if (!service_) own_.define(*NumberRanges::read("100-199"), *NumberRanges::read("500-999"));
    }
    MacroStore* operator->() const { return &**this; }
    MacroStore& operator*() const { return service_ ? *const_cast<MacroStore*>(service_.operator->()) : own_; }

   private:
    ig::Service<MacroStore> service_;
    mutable MacroStore own_;
  };

  Store store_;
  ig::UsedVariables used_;
  ig::ExaminedConditions examined_;
};

}  // namespace fanuc
