/// The names that a program and a sequence number have in searches: O3 for O0003, N10 for N0010, <PART> as written; and
/// the names of the files in which a program may lie.
#pragma once

#include <array>
#include <charconv>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A letter and a whole number; no allocation.
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

/// The name of digits as they stand in the text; leading zeros count for nothing.
inline std::optional<NumberedName> numbered_name(char letter, std::string_view digits) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return NumberedName(letter, number);
}

/// O1234, 1234, and both with zeros to 4, 5 and 8 digits: what a file of program 1234 is called, without extension.
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
