/// How a comparison is shown: text for people, JSON, one page of HTML.
#pragma once

#include <string>
#include <vector>

#include "catalogue.hpp"
#include "diff/groups.hpp"
#include "diff/motions.hpp"

namespace isogloss::cli::parting {

std::string as_text(const Report& report);
std::string as_text(const MotionReport& report);
Json as_json(const Report& report);
Json as_json(const MotionReport& report);
/// A page that needs no other file, of all comparisons of a command.
std::string as_page(const std::vector<Json>& comparisons);

/// "part.nc:5", or "old.nc:5 | new.nc:7" where the sides have different places.
std::string place_text(const std::string& file_a, std::uint32_t line_a, const std::string& file_b,
                       std::uint32_t line_b);
/// "G83: …": the cause with the codes of the blocks in which it acts.
std::string heading(const Group& group);

}  // namespace isogloss::cli::parting
