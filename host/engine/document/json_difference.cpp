#include "document/json_difference.hpp"

#include <algorithm>

#include "isogloss/engine/document_json.hpp"

namespace isogloss {

namespace {

std::string join(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

std::string element(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

void compare(const Json& expected, const Json& got, const std::string& path, std::string& out) {
  if (expected.is_object() && got.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      if (const auto other = got.find(key); other != got.end())
        compare(value, *other, join(path, key), out);
      else
        out += "  " + join(path, key) + ": expected " + value.dump() + ", is missing\n";
    }
    for (const auto& [key, value] : got.items())
      if (!expected.contains(key)) out += "  " + join(path, key) + ": not expected, got " + value.dump() + "\n";
  } else if (expected.is_array() && got.is_array() && expected.size() == got.size()) {
    for (std::size_t i = 0; i < expected.size(); ++i) compare(expected[i], got[i], element(path, i), out);
  } else if (expected != got) {
    out += "  " + (path.empty() ? "document" : path) + ": expected " + expected.dump() + ", got " + got.dump() + "\n";
  }
}

void collect(const Json& json, const std::string& path, std::vector<std::pair<std::string, std::string>>& out) {
  const bool is_list_of_records =
      json.is_array() && std::any_of(json.begin(), json.end(), [](const Json& e) { return e.is_object(); });
  if (json.is_object() && !json.empty()) {
    for (const auto& [key, value] : json.items()) collect(value, join(path, key), out);
  } else if (is_list_of_records) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      Json record = json[i];
      std::string place = element(path, i);
      if (record.is_object() && record.contains("Source") && record["Source"].is_string()) {
        place = path + "[" + record["Source"].get<std::string>() + "]";
        record.erase("Source");
      }
      collect(record, place, out);
    }
  } else if (!path.empty()) {
    out.emplace_back(path, json.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
}

}  // namespace

std::string json_difference(const Json& expected, const Json& got) {
  std::string out;
  compare(expected, got, "", out);
  return out;
}

std::vector<std::pair<std::string, std::string>> json_leaves(const Json& json) {
  std::vector<std::pair<std::string, std::string>> out;
  collect(json, "", out);
  return out;
}

}  // namespace isogloss
