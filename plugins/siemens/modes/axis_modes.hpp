/// How a single word is read, whatever G90 and G91 say: X=AC(10), X=IC(5), C=DC(90), C=ACP(90), C=ACN(90).
#pragma once

#include <array>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace siemens {

class AxisModes {
 public:
  static constexpr std::array<std::string_view, 14> words{"X", "Y", "Z",  "A",  "B",  "C",  "I",
                                                          "J", "K", "I1", "J1", "K1", "AP", "RP"};
  static constexpr std::size_t ap = 12, rp = 13;  ///< the polar words

  explicit AxisModes(ig::Access access) {
    for (const std::string_view word : words)
      fields_.emplace_back(std::string("AxisMode.").append(word), access,
                           ig::About{ig::Life::block, "", "AC, IC, DC, ACP or ACN, where the word says so."});
  }
  static std::size_t index_of(std::string_view word) {
    std::size_t i = 0;
    while (i < words.size() && words[i] != word) ++i;
    return i;
  }
  std::optional<ig::Symbol> get(const ig::Block& b, std::size_t word) const { return b.get(fields_[word]); }
  void set(ig::Block& b, std::size_t word, ig::Symbol mode) const { b.set(fields_[word], mode); }
  void erase(ig::Block& b, std::size_t word) const { b.erase(fields_[word]); }

 private:
  std::vector<ig::Field<ig::Symbol>> fields_;
};

}  // namespace siemens
