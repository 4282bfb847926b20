#include "document/json_difference.hpp"

#include <algorithm>

#include "isogloss/engine/document_json.hpp"

namespace isogloss {

namespace {

std::string join(const std::string& path, const std::string& key) { return path.empty() ? key : path + "." + key; }

std::string element(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

/// A path that differs: the value there on each side; null: that side has none.
struct Differing {
  std::string path;
  const Json *expected, *got;
};

bool holds_records(const Json& list) {
  return std::any_of(list.begin(), list.end(), [](const Json& one) { return one.is_structured(); });
}

void compare(const Json& expected, const Json& got, const std::string& path, std::vector<Differing>& out) {
  if (expected.is_object() && got.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      if (const auto other = got.find(key); other != got.end())
        compare(value, *other, join(path, key), out);
      else
        out.push_back({join(path, key), &value, nullptr});
    }
    for (const auto& [key, value] : got.items())
      if (!expected.contains(key)) out.push_back({join(path, key), nullptr, &value});
  } else if (expected.is_array() && got.is_array() &&
             (expected.size() == got.size() || holds_records(expected) || holds_records(got))) {
    for (std::size_t i = 0; i < std::max(expected.size(), got.size()); ++i)
      if (i < expected.size() && i < got.size())
        compare(expected[i], got[i], element(path, i), out);
      else
        out.push_back(
            {element(path, i), i < expected.size() ? &expected[i] : nullptr, i < got.size() ? &got[i] : nullptr});
  } else if (expected != got) {
    out.push_back({path.empty() ? "document" : path, &expected, &got});
  }
}

std::string text_of(const Json& value, std::size_t longest) {
  std::string out = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (out.size() <= longest) return out;
  std::size_t size = longest;
  while (size > 0 && (static_cast<unsigned char>(out[size]) & 0xc0) == 0x80) --size;  // no half of a character
  return out.substr(0, size) + "…";
}

std::string text_of(const Differing& d, std::size_t longest = std::string::npos) {
  if (d.got == nullptr) return "  " + d.path + ": expected " + text_of(*d.expected, longest) + ", is missing\n";
  if (d.expected == nullptr) return "  " + d.path + ": not expected, got " + text_of(*d.got, longest) + "\n";
  return "  " + d.path + ": expected " + text_of(*d.expected, longest) + ", got " + text_of(*d.got, longest) + "\n";
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
  std::vector<Differing> all;
  compare(expected, got, "", all);
  std::string out;
  for (const Differing& d : all) out += text_of(d);
  return out;
}

std::string first_differences(const Json& expected, const Json& got) {
  constexpr std::size_t most = 5, longest = 160;
  std::vector<Differing> all;
  compare(expected, got, "", all);
  std::string out;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) out += text_of(all[i], longest);
  if (all.size() > most) out += "  … and " + std::to_string(all.size() - most) + " more paths\n";
  return out;
}

std::vector<std::pair<std::string, std::string>> json_leaves(const Json& json) {
  std::vector<std::pair<std::string, std::string>> out;
  collect(json, "", out);
  return out;
}

}  // namespace isogloss
