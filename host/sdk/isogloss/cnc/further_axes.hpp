/// Axes beside X Y Z A B C (U, Q1, SP1): their words and their positions. No motion carries them; the block document
/// does. The machine's table of axes declares them, at most six.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/cnc/axis_names.hpp"
#include "isogloss/sdk.hpp"

namespace ig::cnc {

inline constexpr std::uint32_t first_further_axis = 6, most_further_axes = 6;
constexpr bool is_further_axis(std::uint32_t axis) {
  return axis >= first_further_axis && axis < first_further_axis + most_further_axes;
}

/// A member of the scanners, which write the words, and of FurtherAxesSyntax, which takes them: the word of each
/// further axis in the unit of the program, and how it is read. The functions ask for further axes alone.
class FurtherAxisWords {
 public:
  FurtherAxisWords(Access words, Access modes) {
    for (std::uint32_t i = 1; i <= most_further_axes; ++i) {
      words_.emplace_back("Parsing.FurtherAxis" + std::to_string(i), words,
                          About{Life::word, "", "The word of a further axis, in the unit of the program."});
      modes_.emplace_back("AxisMode.FurtherAxis" + std::to_string(i), modes,
                          About{Life::block, "", "AC, IC, DC, ACP or ACN, where the word says so."});
    }
  }
  const Field<double>& word(std::uint32_t axis) const { return words_[axis - first_further_axis]; }
  const Field<Symbol>& mode(std::uint32_t axis) const { return modes_[axis - first_further_axis]; }

 private:
  std::vector<Field<double>> words_;
  std::vector<Field<Symbol>> modes_;
};

/// Where the further axes stand: FurtherAxes.Name1 and Position1, and so on, in mm or degrees.
class FurtherAxisPositions {
 public:
  explicit FurtherAxisPositions(Access access) {
    for (std::uint32_t i = 1; i <= most_further_axes; ++i) {
      names_.emplace_back("FurtherAxes.Name" + std::to_string(i), access,
                          About{Life::modal, "", "What the machine calls this further axis."});
      positions_.emplace_back("FurtherAxes.Position" + std::to_string(i), access,
                              About{Life::modal, "mm, deg", "Where it stands, in machine coordinates."});
    }
  }
  const Field<Symbol>& name(std::uint32_t axis) const { return names_[axis - first_further_axis]; }
  const Field<double>& position(std::uint32_t axis) const { return positions_[axis - first_further_axis]; }

 private:
  std::vector<Field<Symbol>> names_;
  std::vector<Field<double>> positions_;
};

}  // namespace ig::cnc
