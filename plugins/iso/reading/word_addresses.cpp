#include "reading/word_addresses.hpp"

namespace iso {

WordAddresses::WordAddresses(const ig::Fields& addresses) {
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const char name = addresses.path(i).back();
    const unsigned letter = letter_index(name);
    const std::string_view unit = addresses.unit(i);
    if (letter >= 26) continue;
    const std::uint8_t counts = unit == "mm" || unit == "deg" || unit == "s" ? counts_increments
                                : unit == "mm/min"                           ? counts_feed
                                                                             : 0;
    table_[letter] = {addresses.id(i), counts != 0 || letter == letter_index('P'), counts};
    constexpr std::string_view others = "GMNO";
    const char upper = to_upper(name);
    const bool begins = addresses.id(i) != IG_NO_FIELD && others.find(upper) == std::string_view::npos;
    begins_word_[static_cast<unsigned char>(upper)] = begins_word_[static_cast<unsigned char>(upper | 0x20)] = begins;
  }
}

std::optional<char> WordAddresses::letter_of(ig_field field) const {
  for (std::size_t letter = 0; letter < table_.size(); ++letter)
    if (table_[letter].field == field) return static_cast<char>('A' + letter);
  return std::nullopt;
}

}  // namespace iso
