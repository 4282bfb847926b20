// Optional block skip: / or /1 to /9, before or after N or within a block. While the operator has the layer switched
// on, the rest of the block, from the slash, is not executed; while it is off, the slash has no effect.
#include <bitset>
#include <stdexcept>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

/// "1,3": the layers that are on. Throws std::invalid_argument.
std::bitset<10> read_layers(std::string_view list) {
  std::bitset<10> layers;
  for (const char c : list) {
    if (c == ',' || is_blank(c)) continue;
    if (c < '1' || c > '9') throw std::invalid_argument("block-skip: layers are 1 to 9, separated by commas");
    layers.set(static_cast<std::size_t>(c - '0'));
  }
  return layers;
}

struct BlockSkipSyntax {
  static constexpr auto spec = ig::syntax("BlockSkipSyntax", "Skips the rest of a block behind /, layer by layer.")
                                   .after("TapeBoundarySyntax")
                                   .scans("/");

  ig::TextOption layers{"block-skip", "", "Layers that are switched on, 1 to 9, separated by commas."};
  ig::Setting setting{"block-skip"};
  ig::Out<ig::Symbol> symbol{"BlockSkip.Symbol"};
  ig::Out<std::int64_t> layer{"BlockSkip.Layer"};
  ig::TextField body{"BlockSkip.Body", ig::write};
  ig::Name slash{"/"};
  std::bitset<10> on = read_layers(setting.text().empty() ? layers.text() : setting.text());

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const char digit = at(text, position + 1);
    const bool has_layer = digit >= '1' && digit <= '9';
    const std::size_t number = has_layer ? static_cast<std::size_t>(digit - '0') : 1;
    const std::size_t rest = position + (has_layer ? 2 : 1);
    if (!on.test(number)) return rest;
    b.set(symbol, slash);
    b.set(layer, static_cast<std::int64_t>(number));
    const std::size_t end = block_end(text, rest);
    if (const std::string_view skipped = trim(piece(text, rest, end)); !skipped.empty()) b.set_text(body, skipped);
    return end;
  }
};

const ig::Register<BlockSkipSyntax> block_skip_syntax;

}  // namespace
}  // namespace iso
