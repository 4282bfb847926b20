/// The tables through which libraries call the functions of the system, filled in anew.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <span>

namespace isogloss::cli {

/// The function of the system with this name; false: it has none.
template <class F>
bool find_function(F& function, const char* name) {
  function = reinterpret_cast<F>(dlsym(RTLD_DEFAULT, name));
  return function != nullptr;
}

struct Replacement {
  const char* name;  ///< of a function of the system
  void* function;    ///< called in its place
};

enum class Redirected { libraries, libraries_and_command };

/// Lets what is loaded at present call these functions; what is loaded later calls those of the system. Nothing is
/// undone, so it belongs into the process of a check. With `only` that library alone calls them.
void redirect(std::span<const Replacement> replacements, Redirected what, const std::filesystem::path& only = {});

}  // namespace isogloss::cli
