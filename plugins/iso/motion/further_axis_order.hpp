/// What the code of a block does with the axes beside X Y Z A B C that the block names (G28 U0). The syntax of the code
/// gives the order, and FurtherAxesSyntax executes it at the end of the block.
#pragma once

#include <string>

#include <isogloss/sdk.hpp>

namespace iso {

/// Whether the block names axes beside X Y Z A B C that the machine has.
class NamesFurtherAxes {
 public:
  bool operator()(const ig::Block& b) const { return b.is_raised(named_); }

 private:
  ig::Signal named_{"FurtherAxes.~Named", ig::read};
};

/// A member of each of these syntaxes. The order is for the axes that the block names, or for all where it names none.
class FurtherAxisOrder {
 public:
  explicit FurtherAxisOrder(const std::string& order, ig::Access access = ig::write)
      : order_("FurtherAxes.~" + order, access) {}
  void give(ig::Block& b) const { b.raise(order_); }
  bool is_given(const ig::Block& b) const { return b.is_raised(order_); }

 private:
  ig::Signal order_;
};

/// The service iso.further-offset/1 of a table of work offsets: the origin of an axis with one letter, U V W, in mm or
/// degrees. Each function returns 1, or 0 where the table has no such row or no column for the axis.
inline constexpr const char* further_offset_service = "iso.further-offset/1";

struct FurtherOffsetTable {
  std::uint32_t struct_size;
  std::uint32_t reserved;
  void* self;
  std::int32_t (*get)(void* self, ig_text id, ig_text axis, double* origin);
  std::int32_t (*set)(void* self, ig_text id, ig_text axis, double origin);
};

}  // namespace iso
