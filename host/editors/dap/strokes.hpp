/// What a block does, step by step: the one motion of most blocks, or the single moves of a canned cycle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/document.hpp"

namespace isogloss::dap {

/// Axes X Y Z A B C; a bit of `known` for each.
struct AxisValues {
  double at[6] = {};
  std::uint32_t known = 0;
  bool has(unsigned axis) const { return (known >> axis & 1u) != 0; }
};

struct Stroke {
  enum class Kind : std::uint8_t { rapid, feed, arc, dwell, spindle, orient };
  Kind kind = Kind::feed;
  AxisValues program;                 ///< the end; mm
  AxisValues machine;                 ///< the end; mm, degrees for A B C
  std::optional<double> feed_mm_min;  ///< absent on rapids
  double value = 0;                   ///< dwell: s; orient: degrees
  std::string_view term;              ///< spindle: its direction; as long-lived as the symbols
};

/// Reads finished blocks of one layout. It keeps no state of the run.
class StrokeReader {
 public:
  explicit StrokeReader(const Layout& layout);
  /// The steps in their order; they replace what `out` holds.
  void read(const Document& document, const SymbolTable& symbols, std::vector<Stroke>& out) const;
  std::size_t count(const Document& document) const;

 private:
  struct Fields {
    ig_field program[3], machine[6], form, is_rapid, feed, dwell, orient, direction;
  };
  template <class Values>
  static bool read_motion(const Values& values, const Fields& fields, const SymbolTable& symbols, Stroke& out);
  void read_items(const ListData& list, const SymbolTable& symbols, std::vector<Stroke>& out) const;

  Fields root_{}, item_{};
  std::size_t list_ = SIZE_MAX;
};

/// "rapid to X10 Y20 Z2", "feed to Z-10 at 600 mm/min", "dwell 0.5 s"; axes that stay where `before` was are left out.
std::string describe(const Stroke& stroke, const AxisValues& before);
/// Without digits that mean nothing: 12.5, 0.333333.
std::string number_text(double value);

}  // namespace isogloss::dap
