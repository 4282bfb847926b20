/// HOLES1, HOLES2, CYCLE801 and CYCLE802: the positions at which the cycle kept by MCALL drills.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/cycle_signatures.hpp"

namespace siemens {

using namespace ig::cnc;

class HolePattern {
 public:
  explicit HolePattern(ig::Access access) {
    for (const CycleSignature& s : pattern_signatures) calls_.emplace_back(s, access);
  }

  bool stands_in(const ig::Block& b) const { return find(b) < calls_.size(); }

  /// The positions in the plane, in mm, from the nearest end of the pattern; good until the next call. Nothing where
  /// the block holds no pattern; an empty list where the pattern is not executed, which is reported.
  std::optional<std::span<const ig::Vec3>> take(ig::Block& b, const PlaneAxes& plane, const ig::Vec3& from);

  /// Reports a pattern at which no cycle drills.
  void refuse(ig::Block& b) const;

 private:
  struct Call {
    const CycleFields* fields;
    CycleFields::Values values;

    double operator[](std::string_view parameter) const { return values[fields->index_of(parameter)].value_or(0); }
    ig::Where where() const { return ig::Where::word(fields->code().code(0)); }
  };
  using Points = std::vector<Point2>;

  std::size_t find(const ig::Block& b) const {
    std::size_t i = 0;
    while (i < calls_.size() && !b.find(calls_[i].code())) ++i;
    return i;
  }
  static bool is_executed(ig::Block& b, const Call& call);
  /// A number of holes; 0 where the control would refuse it, which is reported.
  static std::size_t count(ig::Block& b, const Call& call, std::string_view parameter);
  /// Append the positions of the call to `out`; `from` is the tool.
  static void points(ig::Block& b, const Call& call, const Point2& from, Points& out);
  static void row(ig::Block& b, const Call& call, const Point2& from, Points& out);
  static void circle(ig::Block& b, const Call& call, Points& out);
  static void grid(ig::Block& b, const Call& call, const Point2& from, Points& out);
  static void list(ig::Block& b, const Call& call, Points& out);

  /// Words of a move, which a block with a pattern does not have.
  void take_words(ig::Block& b, const Call& call) const;

  std::vector<CycleFields> calls_;
  ig::Xyz words_{"Parsing", ig::take};
  Points points_;                // members, to keep their memory
  std::vector<ig::Vec3> holes_;  // in space
};

}  // namespace siemens
