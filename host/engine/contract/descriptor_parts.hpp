/// What a descriptor's texts, names and arrays must be. A fault is thrown as text.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "export/text_buffer.hpp"
#include "isogloss.h"

namespace isogloss::checks {

// More than any real plugin has: a larger count is garbage, and reading that far would leave the array.
inline constexpr std::uint32_t most_parts = 2048;
inline constexpr std::uint32_t most_declarations = 8192;
inline constexpr std::uint32_t most_names = 256;
inline constexpr std::uint32_t most_look_ahead = 1000;
inline constexpr std::size_t longest_name = 200;
inline constexpr std::size_t longest_text = std::size_t{1} << 16;

struct Fault {
  std::string reason;
};

template <class... A>
[[noreturn]] void fault(fmt::format_string<A...> text, A&&... arguments) {
  throw Fault{fmt::format(text, std::forward<A>(arguments)...)};
}

// `what` below is a function that makes the text: thousands of parts are checked when a plugin is loaded, and hardly
// ever is one of them shown.

template <class What>
std::string_view bytes(const char* s, const What& what, std::size_t longest) {
  if (s == nullptr) fault("{} is null", what());
  if (*s == '\0') return {};  // most units and docs
  const std::size_t size = strnlen(s, longest + 1);
  if (size > longest) fault("{} is longer than {} bytes", what(), longest);
  return {s, size};
}

inline bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Is each byte printable ASCII? Sixteen bytes at a time: the texts of all plugins are checked whenever one is loaded.
inline bool is_plain(std::string_view s) {
  using Bytes [[gnu::vector_size(16)]] = unsigned char;
  using Halves [[gnu::vector_size(16)]] = std::uint64_t;
  if (s.size() < sizeof(Bytes))
    return std::none_of(s.begin(), s.end(), [](char c) { return is_control(c) || (c & 0x80) != 0; });
  Bytes found{};
  const auto look_at = [&](const char* sixteen) {
    Bytes x;
    std::memcpy(&x, sixteen, sizeof x);
    found |= reinterpret_cast<Bytes>((x < 0x20) | (x >= 0x7f));
  };
  for (std::size_t i = 0; i + sizeof found <= s.size(); i += sizeof found) look_at(s.data() + i);
  look_at(s.data() + s.size() - sizeof found);
  const auto halves = reinterpret_cast<Halves>(found);
  return (halves[0] | halves[1]) == 0;
}

/// `list`, `inspect` and diagnostics print it, so it must be UTF-8 without control characters.
template <class What>
void refuse_unprintable(std::string_view s, const What& what) {
  if (is_plain(s)) return;
  for (std::size_t i = 0; i < s.size();) {
    const auto c = static_cast<unsigned char>(s[i]);
    if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7f) fault("{} holds the control character 0x{:02X}", what(), c);
    const std::size_t length = utf8_length(s.substr(i));
    if (length == 0) fault("{} is not UTF-8: its byte {} is 0x{:02X}", what(), i, c);
    i += length;
  }
}

template <class What>
std::string_view text(const char* s, const What& what, std::size_t longest = longest_text) {
  const std::string_view all = bytes(s, what, longest);
  refuse_unprintable(all, what);
  return all;
}

/// "Owner.member", as a function.
inline auto member(std::string_view owner, const char* name) {
  return [owner, name] { return fmt::format("{}.{}", owner, name); };
}
/// "the doc of option 'x' of Owner", as a function.
template <class What>
auto of(const char* part, const What& what) {
  return [part, what] { return fmt::format("{} {}", part, what()); };
}

constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// An XML name in ASCII, without colon.
inline bool is_name(std::string_view s) {
  return !s.empty() && (is_letter(s[0]) || s[0] == '_') && std::all_of(s.begin(), s.end(), [](char c) {
    return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '.';
  });
}

template <class What>
std::string_view name(const char* s, const What& what) {
  const std::string_view id = bytes(s, what, longest_name);
  if (is_name(id)) return id;
  refuse_unprintable(id, what);
  fault("{} '{}' is not a name (a letter, then letters, digits, _ - .)", what(), id);
}

template <std::size_t N>
bool contains(const std::array<const char*, N>& names, std::string_view s) {
  return std::find(names.begin(), names.end(), s) != names.end();
}

/// Names that were seen, sorted in one piece of memory: lists of a plugin are short or sorted.
class Seen {
 public:
  /// False: it was there.
  bool insert(std::string_view name) {
    const auto place = std::lower_bound(sorted_.begin(), sorted_.end(), name);
    if (place != sorted_.end() && *place == name) return false;
    sorted_.insert(place, name);
    return true;
  }

 private:
  std::vector<std::string_view> sorted_;
};

template <class What>
void unique(Seen& seen, std::string_view id, const What& what) {
  if (!seen.insert(id)) fault("{} '{}' is declared twice", what(), id);
}

/// An array of structs has the stride of this host's struct: one that has grown needs a newer host.
template <class T, class What>
void array(const T* first, std::uint32_t count, std::uint32_t most, const What& what) {
  if (count > most) fault("{} counts {}, more than {}", what(), count, most);
  if (count > 0 && first == nullptr) fault("{} counts {} and is null", what(), count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (first[i].struct_size != sizeof(T))
      fault("{}[{}] has struct_size {}, this host's is {}", what(), i, first[i].struct_size, sizeof(T));
  }
}

template <class What>
void name_list(const char* const* names, const What& what) {
  if (names == nullptr) return;
  for (std::uint32_t i = 0; names[i] != nullptr; ++i) {
    if (i == most_names) fault("{} has no null at its end", what());
    if (text(names[i], what, longest_name).empty()) fault("{} holds an empty name", what());
  }
}

}  // namespace isogloss::checks
