/// What clients send, read without trust: a value of a wrong type is a missing one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/framing.hpp"

namespace isogloss::dap {

using editors::Json;

inline std::string text_of(const Json& object, const char* name) {
  if (!object.is_object()) return {};
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

inline std::optional<std::int64_t> integer_of(const Json& object, const char* name) {
  if (!object.is_object()) return std::nullopt;
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  if (found->is_number_float()) {
    constexpr double largest = 9e15;
    const double value = found->get<double>();
    return value > -largest && value < largest ? std::optional(static_cast<std::int64_t>(value)) : std::nullopt;
  }
  return found->get<std::int64_t>();
}

inline bool flag_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

inline Json list_of(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_array() ? *found : Json::array();
}

inline std::vector<std::string> texts_of(const Json& object, const char* name) {
  std::vector<std::string> out;
  for (const Json& one : list_of(object, name))
    if (one.is_string()) out.push_back(one.get<std::string>());
  return out;
}

}  // namespace isogloss::dap
