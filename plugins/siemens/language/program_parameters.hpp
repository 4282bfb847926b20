/// PROC NAME(REAL A, INT B=2, VAR REAL C): the variables of a program that a call gives values to.
#pragma once

#include "language/siemens_environment.hpp"

namespace siemens {

class ProgramParameters {
 public:
  explicit ProgramParameters(const Environment& environment) : environment_(environment) {}

  /// Defines the parameters in the bracket at `open`, with the values that the call has passed, the defaults of the
  /// declaration, or those that the user gives. Without a bracket the program has none. False, with a diagnostic, at a
  /// parameter that cannot be read; those behind it are not defined.
  bool define(ig::Block& b, std::string_view text, std::size_t open) const;

 private:
  bool parameter(ig::Block& b, std::string_view text, std::size_t& next, const Argument& argument,
                 bool is_called) const;

  const Environment& environment_;
};

}  // namespace siemens
