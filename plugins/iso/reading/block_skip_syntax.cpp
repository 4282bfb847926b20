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
    const SkipSign sign = read_skip_sign(text, position);
    const std::size_t end = block_end(text, sign.end);
    return skip.skip(b, sign.layer, piece(text, sign.end, end)) ? end : sign.end;
  }
};

const ig::Register<BlockSkipSyntax> block_skip_syntax;

}  // namespace
}  // namespace iso
