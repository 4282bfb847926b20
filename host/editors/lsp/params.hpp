/// Parameters of requests. What is missing or of another type is the client's fault, and an error to it.
#pragma once

#include <stdexcept>

#include "lsp/text_document.hpp"
#include "protocol/framing.hpp"

namespace isogloss::editors {

class BadParams : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Null where the object has no such member, or is none.
inline const Json* find_member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

inline const Json& member_of(const Json& object, const char* key) {
  if (const Json* const found = find_member(object, key)) return *found;
  throw BadParams(std::string("The parameters lack '") + key + "'.");
}

inline std::string text_of(const Json& object, const char* key) {
  const Json& value = member_of(object, key);
  if (!value.is_string()) throw BadParams(std::string("The parameter '") + key + "' must be a text.");
  return value;
}

inline std::uint32_t count_of(const Json& object, const char* key) {
  const Json& value = member_of(object, key);
  constexpr std::int64_t most = 0x7fffffff;
  if (!value.is_number_integer() || value < 0 || value > most)
    throw BadParams(std::string("The parameter '") + key + "' must be a whole number from 0 to 2147483647.");
  return value;
}

inline Position position_from(const Json& json) { return {count_of(json, "line"), count_of(json, "character")}; }
inline Range range_from(const Json& json) {
  return {position_from(member_of(json, "start")), position_from(member_of(json, "end"))};
}

}  // namespace isogloss::editors
