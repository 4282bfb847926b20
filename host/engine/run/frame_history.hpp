/// Which functions of the program make up each transform: a frame instruction that acts within the one before it adds a
/// part, any other one replaces them all.
#pragma once

#include <functional>

#include "isogloss/engine/explain.hpp"

namespace isogloss {

/// A plugin tells that a transform of this block acts within the one before it by raising the switch "SECTION.~Adds".
class FrameHistory {
 public:
  struct Part {
    Frame frame;
    std::string label;  ///< the first name of the section in the block that wrote it
    ProgramLine since;
  };
  /// The first name that a section has in the block; empty: none.
  using Label = std::function<std::string(std::string_view section)>;
  explicit FrameHistory(const Layout& layout);

  /// Each block of the run in turn, as it is at its end.
  void look(const Document& document, const Label& label);
  /// In the order in which they act on a program point: the last one that was added is the first. Fewer than two: the
  /// transform comes from one function.
  const std::vector<Part>& parts(ig_field transform) const;

 private:
  struct Section {
    ig_field transform = IG_NO_FIELD, adds = IG_NO_FIELD;
    std::string name;
    Frame frame;  // the product of the parts
    std::vector<Part> parts;
  };

  std::vector<Section> sections_;
};

}  // namespace isogloss
