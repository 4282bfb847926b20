#include "cycles/cycle_block.hpp"

namespace iso {

CycleBlock::CycleBlock() {
  std::string path = "Parsing.?";
  for (std::size_t i = 0; i < letters.size(); ++i) {
    path.back() = letters[i];
    alone_[i] = ig::Word(path, ig::write).id();
  }
}

std::optional<std::size_t> CycleBlock::row_of(ig::Symbol cycle) const {
  for (std::size_t row = 0; row < calls_.code_count(); ++row)
    if (calls_.name(row) == cycle) return row;
  return std::nullopt;
}

void CycleBlock::take_feed(ig::Block& b, std::size_t row) const {
  feed_.resolve(b, take(b, calls_.row(row)[CycleWords::F]));
}

void CycleBlock::erase_codes(ig::Block& b) const {
  for (std::size_t row = 0; row < calls_.code_count(); ++row) b.erase(calls_.code(row));
}

void CycleBlock::give_back(ig::Block& b, std::size_t row) const {
  erase_codes(b);
  for (std::size_t axis = 0; axis < 3; ++axis) b.move(calls_.row(row)[axis], alone_[axis]);
  take_feed(b, row);
}

}  // namespace iso
