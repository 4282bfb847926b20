#include "import/control_text.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>

#include "export/text_buffer.hpp"

namespace isogloss {

namespace {

void append_utf8(std::string& out, std::uint32_t c) {
  const auto put = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | c >> 6);
  } else if (c < 0x10000) {
    put(0xe0 | c >> 12);
    put(0x80 | (c >> 6 & 0x3f));
  } else {
    put(0xf0 | c >> 18);
    put(0x80 | (c >> 12 & 0x3f));
    put(0x80 | (c >> 6 & 0x3f));
  }
  put(0x80 | (c & 0x3f));
}

std::string from_utf16(std::string_view bytes, bool is_little) {
  constexpr std::uint32_t unknown = 0xfffd;
  const auto unit = [&](std::size_t i) -> std::uint32_t {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return is_little ? first | second << 8 : first << 8 | second;
  };
  std::string out;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const std::uint32_t c = unit(i);
    const bool is_high = c >= 0xd800 && c < 0xdc00;
    const std::uint32_t next = is_high && i + 3 < bytes.size() ? unit(i + 2) : 0;
    if (next >= 0xdc00 && next < 0xe000) {
      append_utf8(out, 0x10000 + ((c - 0xd800) << 10) + (next - 0xdc00));
      i += 2;
    } else {
      append_utf8(out, c >= 0xd800 && c < 0xe000 ? unknown : c);
    }
  }
  return out;
}

std::string from_latin1(std::string_view bytes) {
  std::string out;
  for (const char c : bytes) append_utf8(out, static_cast<unsigned char>(c));
  return out;
}

/// Without the codes of tape punches and serial lines: DC1 to DC4 and DEL, NUL and a doubled CR at the ends of lines,
/// and the byte 1A at the end of the file.
std::string without_line_codes(std::string bytes) {
  std::erase_if(bytes, [](char c) { return (c >= '\x11' && c <= '\x14') || c == '\x7f'; });
  const auto is_line_end = [](char c) { return c == '\r' || c == '\n'; };
  std::string out;
  out.reserve(bytes.size());
  for (std::size_t i = 0, next = 0; i < bytes.size(); i = next) {
    const char c = bytes[i];
    next = c == '\0' || c == '\r' ? std::min(bytes.find_first_not_of(c, i), bytes.size()) : i + 1;
    const bool is_at_end = next == bytes.size() || is_line_end(bytes[next]);
    if (c == '\0' && (out.empty() || is_line_end(out.back()) || is_at_end)) continue;
    const bool is_doubled = c == '\r' && next < bytes.size() && bytes[next] == '\n';
    out.append(is_doubled ? 1 : next - i, c);
  }
  const std::size_t end_of_data = out.find_last_not_of("\x1a\r\n \t") + 1;
  out.resize(std::min(out.find('\x1a', end_of_data), out.size()));
  return out;
}

}  // namespace

std::optional<std::string> text_of_control(std::string bytes, std::string& reason) {
  const std::string_view all = bytes;
  if (all.starts_with("\xff\xfe") || all.starts_with("\xfe\xff")) bytes = from_utf16(all, all[0] == '\xff');
  bytes = without_line_codes(std::move(bytes));
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
  if (bytes.starts_with("PK\x03\x04")) {
    reason = "it is a zip archive, which is not read: unpack it, and import the files in it";
    return std::nullopt;
  }
  if (bytes.find('\0') != std::string::npos) {
    reason = "it is no text, since it holds NUL bytes: let the control write it as text";
    return std::nullopt;
  }
  if (valid_utf8(bytes) != bytes) bytes = from_latin1(bytes);
  return bytes;
}

}  // namespace isogloss
