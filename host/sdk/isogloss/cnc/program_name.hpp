/// The names under which programs and sequence numbers are searched (O3 for O0003, N10 for N0010, <PART> as written),
/// and the names of the files that may hold a program.
#pragma once

#include <array>
#include <charconv>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A letter (or none, for '\0') and a whole number, padded with zeros to `digits` digits at most 20; allocates nothing.
class NumberedName {
 public:
  NumberedName(char letter, std::int64_t number, int digits = 0) {
    text_[0] = letter;
    const auto size = letter == '\0' ? 0u : 1u;
    char digits_of[24];
    const char* const end = std::to_chars(digits_of, digits_of + sizeof digits_of, number).ptr;
    char* to = text_.data() + size;
    for (int i = static_cast<int>(end - digits_of); i < digits && i < 20; ++i) *to++ = '0';
    to = std::copy(static_cast<const char*>(digits_of), end, to);
    size_ = static_cast<std::size_t>(to - text_.data());
  }
  std::string_view text() const { return {text_.data(), size_}; }

 private:
  std::array<char, 48> text_{};
  std::size_t size_ = 0;
};

/// The name for digits as they stand in the text, without leading zeros; nothing where the text is not a whole number
/// of at most 64 bits, or has a sign.
inline std::optional<NumberedName> numbered_name(char letter, std::string_view digits) {
  if (digits.starts_with('-')) return std::nullopt;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return NumberedName(letter, number);
}

/// The names, without extension, that a file of program 1234 may have: O1234 and 1234, each also with zeros to 4, 5 and
/// 8 digits. The list is valid as long as the object.
class ProgramFileNames {
 public:
  explicit ProgramFileNames(std::int64_t number) {
    for (const int digits : {4, 0, 5, 8})
      for (const char letter : {'O', '\0'}) add(NumberedName(letter, number, digits));
  }
  std::span<const ig_text> list() const { return {texts_.data(), count_}; }
  ProgramFileNames(const ProgramFileNames&) = delete;
  ProgramFileNames& operator=(const ProgramFileNames&) = delete;

 private:
  void add(const NumberedName& name) {
    for (std::size_t i = 0; i < count_; ++i)
      if (names_[i]->text() == name.text()) return;
    names_[count_] = name;
    texts_[count_] = to_text(names_[count_]->text());
    ++count_;
  }
  std::array<std::optional<NumberedName>, 8> names_;
  std::array<ig_text, 8> texts_{};
  std::size_t count_ = 0;
};

}  // namespace ig::cnc
