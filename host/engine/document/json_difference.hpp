/// Two documents side by side, path by path.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace isogloss {

/// One line for each path that differs ("  Dwell.Time: expected 0.5, got 500"); empty when the documents are equal.
/// Numbers are compared by value; the order of keys does not matter.
std::string json_difference(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& got);

/// The first of those lines, with long values shortened, and how many others there are.
std::string first_differences(const nlohmann::ordered_json& expected, const nlohmann::ordered_json& got);

/// The leaves by path, in order. A list of plain values is one leaf; a record that has a Source is named by it.
std::vector<std::pair<std::string, std::string>> json_leaves(const nlohmann::ordered_json& json);

}  // namespace isogloss
