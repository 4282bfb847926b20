/// The addresses of words in a dialect: the field that each letter sets, and which letters begin a word. Made once,
/// when the chain is created.
#pragma once

#include <optional>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

class WordAddresses {
 public:
  enum Counts : std::uint8_t { counts_increments = 1, counts_feed = 2 };
  struct Address {
    ig_field field = IG_NO_FIELD;
    bool may_lack_point = false;     ///< P, too: seconds or milliseconds on some controls
    std::uint8_t without_point = 0;  ///< what a number without a point counts
  };

  explicit WordAddresses(const ig::Fields& addresses);

  /// By letter_index(), less than 26.
  const Address& operator[](unsigned letter) const { return table_[letter]; }
  /// False for codes, sequence numbers and program numbers, which belong to earlier scanners.
  bool begins_word(char c) const { return begins_word_[static_cast<unsigned char>(c)]; }
  /// The letter that sets the field; nothing for a field of no address.
  std::optional<char> letter_of(ig_field field) const;

 private:
  std::array<Address, 26> table_{};
  std::array<bool, 256> begins_word_{};
};

}  // namespace iso
