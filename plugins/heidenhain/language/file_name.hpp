/// The name of a file in a statement: TNC:\FOLDER\NAME.H, in quotes or not, or the text of a string parameter.
#pragma once

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// The name that stands from `position` to the end of the text, empty where there is none. Nothing, and reported, for a
/// string parameter without a text.
inline std::optional<std::string_view> file_name_at(ig::Block& b, const Values& values, std::string_view text,
                                                    std::size_t position) {
  const std::string_view rest = trim(text.substr(std::min(position, text.size())));
  std::size_t end = position;
  if (Values::text_parameter_at(text, position, end) && trim(text.substr(end)).empty()) {
    const auto held = values.text(b, text, position, end);
    return held ? std::optional(trim(*held)) : std::nullopt;
  }
  if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"') return trim(rest.substr(1, rest.size() - 2));
  return rest;
}

}  // namespace heidenhain
