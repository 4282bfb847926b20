/// What the program holds in place of a code: other languages pass their functions on as ISO codes.
#pragma once

#include <isogloss/sdk.hpp>

namespace iso {

/// The text at which the code stands, up to a bracket (M128 for G43.4, CYCLE800 for G53.1); the code's own name where
/// it has no place in the text.
inline std::string_view as_written(const ig::Block& b, ig_field code, ig::Symbol name) {
  const std::string_view source = b.source();
  ig_word place{};
  const bool is_there = b.word(code, place);
  if (!is_there || place.begin >= place.end || place.end > source.size()) return b.text(name);
  const std::string_view text = source.substr(place.begin, std::size_t{place.end} - place.begin);
  return text.substr(0, text.find('('));
}

}  // namespace iso
