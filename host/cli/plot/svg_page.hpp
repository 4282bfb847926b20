/// A page with four views of a path, as SVG.
#pragma once

#include <string>

#include "path_run.hpp"

namespace isogloss::cli::plotting {

std::string svg_page(const std::string& program, const PathRun& run);

/// "2 h 5 min", "3 min 12 s", "4.2 s".
std::string duration(double seconds);

}  // namespace isogloss::cli::plotting
