/// Is a plugin's descriptor fit to be used? Asked once when a plugin is loaded, so that everything after may rely on
/// it: sizes, pointers, counts, names, types, defaults.
#pragma once

#include <optional>
#include <string>

#include "isogloss.h"

namespace isogloss {

/// The first fault found, as a sentence that names the part; empty when there is none. The major version is the
/// caller's to check; a newer minor one is no fault. Pointers that are wild, not null, cannot be told from good ones.
std::optional<std::string> descriptor_fault(const ig_plugin& plugin);

}  // namespace isogloss
