/// The files of the page, which the build embeds into the command: page/ and vendor/three/.
#pragma once

#include <string_view>

namespace isogloss::cli::viewing {

/// The text of a file, by its name without folder; "page.css.hash" and "loader.js.hash" are what a security policy
/// calls them. Empty: there is none.
std::string_view asset(std::string_view name);

/// The modules of the page: each stands behind those that it imports.
inline constexpr std::string_view modules[] = {"three.core.min.js",
                                               "three.module.min.js",
                                               "OrbitControls.js",
                                               "LineMaterial.js",
                                               "LineSegmentsGeometry.js",
                                               "LineSegments2.js",
                                               "data.js",
                                               "lines.js",
                                               "scene.js",
                                               "program.js",
                                               "timeline.js",
                                               "panels.js",
                                               "main.js"};

}  // namespace isogloss::cli::viewing
