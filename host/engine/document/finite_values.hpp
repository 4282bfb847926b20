/// Finds values that overflowed. The processor remembers an overflow by itself, so that an ordinary block costs one
/// look at its flags and at the end of its move; from the first overflow on every block is searched.
#pragma once

#include <cfenv>
#include <cmath>
#include <string>
#ifdef __SSE2_MATH__
#include <xmmintrin.h>
#endif

#include "isogloss/engine/document.hpp"

namespace isogloss {

class FiniteValues {
 public:
  explicit FiniteValues(const Layout& layout) {
    for (int i = 0; i < 3; ++i) machine_[i] = layout.id(std::string("MachineCoordinate.") + "XYZ"[i]);
    std::feclearexcept(flags);
  }

  bool is_suspect(const Document& d) {
    if (has_overflow_flag()) [[unlikely]]
      has_overflowed_ = true;
    // A value that is not present is stale: at worst the search finds nothing.
    const double size =
        std::fabs(d.number(machine_[0])) + std::fabs(d.number(machine_[1])) + std::fabs(d.number(machine_[2]));
    return has_overflowed_ || !(size < largest);
  }

  /// The path of a number that is not finite, or of a coordinate too large for its square to be finite; empty: there
  /// is none.
  std::string find_overflow(const Document& d) const {
    const Layout& layout = d.layout();
    for (const ig_field f : machine_)
      if (d.present(f) && !(std::fabs(d.number(f)) < largest)) return layout.fields[f].path;
    for (ig_field f = 0; f < d.size(); ++f)
      if (layout.fields[f].type == IG_NUMBER && !layout.fields[f].hidden && d.present(f) && !std::isfinite(d.number(f)))
        return layout.fields[f].path;
    for (std::size_t l = 0; l < d.lists.size(); ++l) {
      const ListData& list = d.lists[l];
      const std::vector<FieldInfo>& fields = layout.lists[l].fields;
      const bool has_coordinates = layout.lists[l].path == "CompoundMotion.Items";
      const auto overflows = [&](double v) { return has_coordinates ? !(std::fabs(v) < largest) : !std::isfinite(v); };
      for (std::size_t r = 0; r < list.count; ++r)
        for (std::size_t i = 0; i < fields.size(); ++i)
          if (fields[i].type == IG_NUMBER && (list.present[r] >> i & 1) != 0 &&
              overflows(list.values[r * list.stride + i].number))
            return layout.lists[l].path + "." + fields[i].path;
    }
    for (const ig_field f : layout.transforms)
      if (d.present(f))
        for (const double v : d.frame(f).matrix)
          if (!std::isfinite(v)) return layout.fields[f].path;
    return {};
  }

 private:
  /// Doubles are computed in SSE registers there, whose flags are read without a call.
  static bool has_overflow_flag() {
#ifdef __SSE2_MATH__
    return (_mm_getcsr() & (_MM_EXCEPT_OVERFLOW | _MM_EXCEPT_DIV_ZERO | _MM_EXCEPT_INVALID)) != 0;
#else
    return std::fetestexcept(flags) != 0;
#endif
  }

  static constexpr int flags = FE_OVERFLOW | FE_DIVBYZERO | FE_INVALID;
  static constexpr double largest = 1e100;

  ig_field machine_[3];
  bool has_overflowed_ = false;
};

}  // namespace isogloss
