// Optional block skip: / or /1 to /9, before or after N or within a block. While the operator has the layer switched
// on, the rest of the block, from the slash, is not executed; while it is off, the slash has no effect.
#include <isogloss/cnc/block_skip.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct BlockSkipSyntax {
  static constexpr auto spec = ig::syntax("BlockSkipSyntax", "Skips the rest of a block behind /, layer by layer.")
                                   .after("TapeBoundarySyntax")
                                   .scans("/");

  BlockSkip skip;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const char digit = at(text, position + 1);
    const bool has_layer = digit >= '1' && digit <= '9';
    const std::size_t number = has_layer ? static_cast<std::size_t>(digit - '0') : 1;
    const std::size_t rest = position + (has_layer ? 2 : 1);
    const std::size_t end = block_end(text, rest);
    return skip.skip(b, number, piece(text, rest, end)) ? end : rest;
  }
};

const ig::Register<BlockSkipSyntax> block_skip_syntax;

}  // namespace
}  // namespace iso
