/// Optional block skip: the layers 1 to 9 that the operator has switched on (the option or the setting `block-skip`),
/// and the section BlockSkip of a block that is skipped.
#pragma once

#include <bitset>
#include <stdexcept>

#include "isogloss/cnc/scan.hpp"

namespace ig::cnc {

/// "1,3": the layers that are on. Throws std::invalid_argument.
inline std::bitset<10> read_skip_layers(std::string_view list) {
  std::bitset<10> layers;
  for (const char c : list) {
    if (c == ',' || is_blank(c)) continue;
    if (c < '1' || c > '9') throw std::invalid_argument("block-skip: layers are 1 to 9, separated by commas");
    layers.set(static_cast<std::size_t>(c - '0'));
  }
  return layers;
}

/// The sign of block skip, / or /1 to /9: its layer, and where it ends.
struct SkipSign {
  std::size_t layer = 1, end = 0;
};

/// The sign at `position`, where a slash stands.
inline SkipSign read_skip_sign(std::string_view text, std::size_t position) {
  const char digit = at(text, position + 1);
  if (digit < '1' || digit > '9') return {1, position + 1};
  return {static_cast<std::size_t>(digit - '0'), position + 2};
}

/// The layers that are on. A member of the scanners that read beyond a skip sign.
class SkipLayers {
 public:
  /// Is the layer, 1 to 9, on?
  bool is_on(std::size_t layer) const { return on_.test(layer); }

  /// The position from which a sign of a layer that is on skips the rest of the block; its end where none does. A sign
  /// in brackets is none.
  std::size_t executed_end(std::string_view text, std::size_t position) const {
    const std::size_t end = block_end(text, position);
    for (std::size_t i = position; i < end;) {
      const char c = text[i];
      if (c == '(' || c == '[') {
        i = skip_bracketed(text, i);
      } else if (c == '/') {
        const SkipSign sign = read_skip_sign(text, i);
        if (is_on(sign.layer)) return i;
        i = sign.end;
      } else {
        ++i;
      }
    }
    return end;
  }

 private:
  TextOption layers_{"block-skip", "", "Layers that are switched on, 1 to 9, separated by commas."};
  Setting setting_{"block-skip"};
  std::bitset<10> on_ = read_skip_layers(setting_.text().empty() ? layers_.text() : setting_.text());
};

/// A member of the scanner that reads the skip sign.
class BlockSkip {
 public:
  /// Skips the block from the sign on where the layer, 1 to 9, is on; `rest` is the text after the sign. False where
  /// the layer is off: the sign has no effect.
  bool skip(Block& b, std::size_t layer, std::string_view rest) const {
    if (!layers_.is_on(layer)) return false;
    b.set(symbol_, slash_);
    b.set(layer_, static_cast<std::int64_t>(layer));
    if (const std::string_view skipped = trim(rest); !skipped.empty()) b.set_text(body_, skipped);
    return true;
  }

 private:
  SkipLayers layers_;
  Out<Symbol> symbol_{"BlockSkip.Symbol"};
  Out<std::int64_t> layer_{"BlockSkip.Layer"};
  TextField body_{"BlockSkip.Body", write};
  Name slash_{"/"};
};

}  // namespace ig::cnc
