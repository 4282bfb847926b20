#include "export/text_buffer.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "isogloss/engine/printable.hpp"

namespace isogloss {

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto follows = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xc0u) == 0x80u; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4 || !follows(1)) return 0;
  if (first < 0xe0) return 2;
  const unsigned second = byte(1);
  if (first < 0xf0) {
    const bool overlong = first == 0xe0 && second < 0xa0, surrogate = first == 0xed && second >= 0xa0;
    return overlong || surrogate || !follows(2) ? 0 : 3;
  }
  const bool overlong = first == 0xf0 && second < 0x90, too_large = first == 0xf4 && second >= 0x90;
  return overlong || too_large || !follows(2) || !follows(3) ? 0 : 4;
}

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

template <class Test>
std::size_t bytes_before(std::string_view text, Test ends) {
  std::size_t i = 0;
  while (i < text.size() && !ends(static_cast<unsigned char>(text[i]))) ++i;
  return i;
}

void append_escaped(std::string& out, char c) {
  constexpr char hex[] = "0123456789abcdef";
  switch (c) {
    case '"': out += "\\\""; return;
    case '\\': out += "\\\\"; return;
    case '\n': out += "\\n"; return;
    case '\r': out += "\\r"; return;
    case '\t': out += "\\t"; return;
    default: break;
  }
  const auto byte = static_cast<unsigned char>(c);
  out += "\\u00";
  out += hex[byte >> 4];
  out += hex[byte & 15];
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t plain = bytes_before(text, [](unsigned char c) { return c >= 0x80; });
    out.append(text.data(), plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const std::size_t length = utf8_length(text);
    out += length == 0 ? replacement : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string printable(std::string_view text, std::string_view kept) {
  std::string out;
  const std::string valid = valid_utf8(text);
  out.reserve(valid.size());
  for (std::string_view rest = valid; !rest.empty();) {
    const std::size_t plain = bytes_before(rest, [](unsigned char c) { return c < 0x20 || c == 0x7f || c == 0xc2; });
    out.append(rest.data(), plain);
    rest.remove_prefix(plain);
    if (rest.empty()) break;
    const auto byte = static_cast<unsigned char>(rest[0]);
    const unsigned next = rest.size() > 1 ? static_cast<unsigned char>(rest[1]) : 0;
    if (byte == 0xc2 && next < 0xa0) {
      // U+0080 to U+009F: terminals obey U+009B as they obey an escape and a bracket.
      out += fmt::format("\\x{:02x}", next);
      rest.remove_prefix(2);
      continue;
    }
    if (byte == 0xc2 || kept.find(rest[0]) != std::string_view::npos)
      out += rest[0];
    else
      out += fmt::format("\\x{:02x}", byte);
    rest.remove_prefix(1);
  }
  return out;
}

std::string json_string(std::string_view text) {
  std::string out;
  out.reserve(text.size() + 2);
  out += '"';
  std::size_t plain = 0;  // bytes at the head that stand for themselves
  while (plain < text.size()) {
    const char c = text[plain];
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f && c != '"' && c != '\\') {
      ++plain;
      continue;
    }
    const std::size_t length = utf8_length(text.substr(plain));
    if (length > 1) {
      plain += length;
      continue;
    }
    out += text.substr(0, plain);
    if (length == 1)
      append_escaped(out, c);
    else
      out += replacement;
    text.remove_prefix(plain + 1);
    plain = 0;
  }
  out += text;
  out += '"';
  return out;
}

}  // namespace isogloss
