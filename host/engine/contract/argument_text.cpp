#include "contract/argument_text.hpp"

#include <array>
#include <charconv>

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
  // Not by printf(), which writes a comma where an embedder has chosen such a locale.
  constexpr int digits = 6;
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), a.number, std::chars_format::general, digits).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::vector<std::string> argument_texts(const ig_argument* arguments, std::uint32_t count) {
  std::vector<std::string> out;
  for (std::uint32_t i = 0; i < count; ++i) out.push_back(text_of(arguments[i]));
  return out;
}

}  // namespace isogloss
