/// Values for options: at their bounds, beyond them, and between them.
#pragma once

#include <isogloss.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace isogloss::cli {

struct Candidate {
  std::string value;
  bool is_allowed = true;       ///< by the declaration
  bool may_be_refused = false;  ///< by create(): the declaration cannot say which texts mean something
};

/// At the bounds of the declaration and beyond them.
std::vector<Candidate> candidates(const ig_option_decl& option);
/// For an option that has no default.
std::string any_value(const ig_option_decl& option);
/// Inside of the declared bounds, for options that are tried together.
std::string random_value(const ig_option_decl& option, std::mt19937_64& random);
/// The element of a dialect that gives each option of the syntax such a value, another one than its default where it
/// can; empty where it has none.
std::string other_options(const ig_syntax& syntax, std::uint64_t seed);

}  // namespace isogloss::cli
