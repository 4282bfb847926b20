/// Axis words that a syntax rewrites in place, wherever they are: in the block itself or with a code.
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <string_view>
#include <vector>

#include <isogloss/sdk.hpp>

namespace iso {

/// The words of an option, each with its axis: the place of the last letter of its path in `names`.
class WordsOfAxes {
 public:
  WordsOfAxes(const ig::Fields& words, std::string_view names) : words_(words.ids(), words.ids() + words.size()) {
    for (std::size_t i = 0; i < words.size(); ++i) axes_.push_back(names.find(words.path(i).back()));
  }

  /// `new_value(axis, value)` gives the new value of a word of the block, or nothing where it stays. True when a word
  /// was rewritten.
  template <class NewValue>
  bool rewrite(ig::Block& b, const NewValue& new_value) const {
    bool any = false;
    for (std::size_t first = 0; first < words_.size(); first += 32) {
      ig_value v[32];
      const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(32, words_.size() - first));
      for (std::uint32_t named = b.get_many(words_.data() + first, count, v); named != 0; named &= named - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(named));
        const std::size_t axis = axes_[first + i];
        if (axis == std::string_view::npos) continue;
        const std::optional<double> value = new_value(axis, v[i].number);
        if (!value) continue;
        b.rewrite(words_[first + i], *value);
        any = true;
      }
    }
    return any;
  }

 private:
  std::vector<ig_field> words_;
  std::vector<std::size_t> axes_;
};

}  // namespace iso
