#include "contract/argument_text.hpp"

#include <cstdio>

namespace isogloss {

namespace {

std::string text_of(const ig_argument& a) {
  // A program's text may be a megabyte long; a message shows its beginning.
  constexpr std::size_t longest = 120;
  if (a.is_text != 0) {
    if (a.text.size <= longest) return std::string(a.text.data, a.text.size);
    std::size_t end = longest;  // of a character, not inside it
    while (end > 0 && (static_cast<unsigned char>(a.text.data[end]) & 0xc0) == 0x80) --end;
    return std::string(a.text.data, end) + " …";
  }
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", a.number);
  return buffer;
}

}  // namespace

std::vector<std::string> argument_texts(const ig_argument* arguments, std::uint32_t count) {
  std::vector<std::string> out;
  for (std::uint32_t i = 0; i < count; ++i) out.push_back(text_of(arguments[i]));
  return out;
}

}  // namespace isogloss
