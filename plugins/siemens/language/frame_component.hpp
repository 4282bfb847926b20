/// One component of a FRAME variable: F[X,TR], and F[2,X,RT] of an array.
#pragma once

#include <optional>
#include <string>

#include "frames/frame_value.hpp"
#include "language/variable_store.hpp"

namespace siemens {

struct FrameComponent {
  std::string variable;  ///< F, or F[2]
  FrameLink link;
  std::size_t axis;
  FrameValue frame;  ///< the present value of the variable

  /// Nothing where the name is no component of a FRAME variable.
  static std::optional<FrameComponent> of(VariableStore& store, const std::string& name);
  /// The text of the frame with another value there; nothing where a frame cannot have that value.
  std::optional<std::string> changed(double value) const;
};

}  // namespace siemens
