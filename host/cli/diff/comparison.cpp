#include "diff/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diff/values.hpp"

namespace isogloss::cli::parting {

Comparison::Comparison(const FieldMap& map, const SideOf& a, const SideOf& b, const ComparisonOptions& options)
    : map_(map), sides_{&a, &b}, options_(options), evidence_(a, b) {
  report_.name_a = a.name;
  report_.name_b = b.name;
  for (std::size_t side = 0; side < 2; ++side) {
    cells_[side].resize(map.fields.size());
    stamps_[side].resize(map.fields.size());
  }
  cause_.assign(map.fields.size(), none);
  cause_before_ = cause_;
  ranks_.resize(map.fields.size());
}

void Comparison::index(std::size_t side, const Snapshot& block) {
  ++stamp_[side];
  for (const Cell& cell : block.cells) {
    cells_[side][cell.field] = &cell;
    stamps_[side][cell.field] = stamp_[side];
  }
}

Comparison::Pair Comparison::add(Pair blocks) {
  ++number_;
  parts_ = false;
  for (std::size_t side = 0; side < 2; ++side) {
    if (blocks[side] == nullptr) continue;
    if (blocks[side]->is_initial)
      evidence_.set_rows_at_start(static_cast<int>(side), blocks[side]->rows);
    else
      ++(side == 0 ? report_.blocks_a : report_.blocks_b);
    index(side, *blocks[side]);
  }
  if (blocks[0] != nullptr && blocks[1] != nullptr)
    compare(*blocks[0], *blocks[1]);
  else
    add_alone(blocks[0] != nullptr ? 0 : 1, *blocks[blocks[0] != nullptr ? 0 : 1]);
  if (parts_) ++report_.parted;
  Pair old;
  for (std::size_t side = 0; side < 2; ++side)
    if (blocks[side] != nullptr) {
      old[side] = std::move(last_[side]);
      last_[side] = std::move(blocks[side]);
    }
  return old;
}

void Comparison::compare(const Snapshot& a, const Snapshot& b) {
  texts_differ_ = options_.are_two_programs && a.text != b.text;
  const Probe& probe = options_.probe;
  if (probe.line_a != 0 && a.line == probe.line_a && a.file == probe.file_a) report_.is_probed = true;
  differences_.clear();
  collect(a, b);
  collect_strokes(a, b);
  if (!differences_.empty() || !open_.empty()) find_causes(a, b);
  compare_reports(a, b);
}

void Comparison::collect(const Snapshot& a, const Snapshot& b) {
  for (const Cell& cell : a.cells)
    if (const Cell* const other = at(1, cell.field); !are_same(&cell, a, other, b))
      add_difference({cell.field, &cell, other}, a, b);
  for (const Cell& cell : b.cells)
    if (at(0, cell.field) == nullptr) add_difference({cell.field, nullptr, &cell}, a, b);
}

void Comparison::add_difference(Difference d, const Snapshot& a, const Snapshot& b) {
  if (d.stroke < 0) {
    if (d.a != nullptr && d.a->is_fresh) d.writer_a = d.a->writer;
    if (d.b != nullptr && d.b->is_fresh) d.writer_b = d.b->writer;
    const bool is_fresh = (d.a != nullptr && d.a->is_fresh) || (d.b != nullptr && d.b->is_fresh);
    d.needs_cause = is_fresh || cause_[d.field] == none;
    if (d.needs_cause && !is_fresh) {  // one side has dropped the value
      d.writer_a = last_writer(0, d.field, a);
      d.writer_b = last_writer(1, d.field, b);
    }
  }
  const std::size_t length_a = sides_[0]->linked->chain.size(), length_b = sides_[1]->linked->chain.size();
  if (d.writer_a != 0)
    d.rank = 1 + d.writer_a;
  else if (d.writer_b != 0)
    d.rank = static_cast<std::uint32_t>(1 + d.writer_b * length_a / std::max<std::size_t>(length_b, 1));
  differences_.push_back(d);
}

/// The last syntax called in this block that writes such a field: it may also be the one that erased it.
std::uint16_t Comparison::last_writer(std::size_t side, std::uint32_t field, const Snapshot& block) const {
  const auto writer = std::find_if(block.called.rbegin(), block.called.rend(),
                                   [&](std::uint16_t position) { return map_.writes[side][position][field]; });
  return writer == block.called.rend() ? std::uint16_t{0} : static_cast<std::uint16_t>(*writer + 1);
}

void Comparison::collect_strokes(const Snapshot& a, const Snapshot& b) {
  const auto find = [](const Snapshot& block, std::uint32_t list) -> const StrokeList* {
    for (const StrokeList& l : block.lists)
      if (l.list == list) return &l;
    return nullptr;
  };
  static const StrokeList empty;
  const auto compare_list = [&](const StrokeList* one, const StrokeList* other, std::uint32_t list) {
    for (const Match& pair : match_strokes(one != nullptr ? *one : empty, a, other != nullptr ? *other : empty, b))
      collect_stroke(pair, one, a, other, b, list);
  };
  for (const StrokeList& l : a.lists) compare_list(&l, find(b, l.list), l.list);
  for (const StrokeList& l : b.lists)
    if (find(a, l.list) == nullptr) compare_list(nullptr, &l, l.list);
}

void Comparison::collect_stroke(const Match& pair, const StrokeList* a, const Snapshot& in_a, const StrokeList* b,
                                const Snapshot& in_b, std::uint32_t list) {
  const auto cells = [](const StrokeList* strokes, int i, const Snapshot& in) -> std::span<const Cell> {
    if (i < 0 || strokes == nullptr) return {};
    const Stroke& s = strokes->strokes[static_cast<std::size_t>(i)];
    return {in.stroke_cells.data() + s.begin, s.end - s.begin};
  };
  const std::uint16_t maker_a = a != nullptr ? a->maker : std::uint16_t{0},
                      maker_b = b != nullptr ? b->maker : std::uint16_t{0};
  const auto add = [&](std::uint32_t field, const Cell* one, const Cell* other) {
    Difference d{field, one, other};
    d.stroke = pair.a >= 0 ? pair.a : pair.b;
    const bool is_stroke = field == map_.list_field[list];
    d.writer_a = one == nullptr ? std::uint16_t{0} : is_stroke ? maker_a : one->writer;
    d.writer_b = other == nullptr ? std::uint16_t{0} : is_stroke ? maker_b : other->writer;
    add_difference(d, in_a, in_b);
  };
  const std::span<const Cell> one = cells(a, pair.a, in_a), other = cells(b, pair.b, in_b);
  if (pair.a < 0 || pair.b < 0) {
    if (const std::uint32_t field = map_.list_field[list]; field != no_field)
      add(field, one.empty() ? nullptr : one.data(), other.empty() ? nullptr : other.data());
    return;
  }
  const auto find = [](std::span<const Cell> in, std::uint32_t field) -> const Cell* {
    for (const Cell& c : in)
      if (c.field == field) return &c;
    return nullptr;
  };
  for (const Cell& c : one)
    if (const Cell* const same = find(other, c.field); !are_same(&c, in_a, same, in_b)) add(c.field, &c, same);
  for (const Cell& c : other)
    if (find(one, c.field) == nullptr) add(c.field, nullptr, &c);
}

/// A block that only one side runs: what it changes is the cause of what differs afterwards.
void Comparison::add_alone(std::size_t side, const Snapshot& block) {
  texts_differ_ = false;
  Group group;
  group.kind = Group::Kind::blocks;
  group.cause = options_.are_two_programs ? fmt::format("lines that only {} has", sides_[side]->name)
                                          : fmt::format("blocks that only {} runs", sides_[side]->name);
  const int number = group_of(fmt::format("alone{}", side), std::move(group));
  const Snapshot *const a = side == 0 ? &block : nullptr, *const b = side == 1 ? &block : nullptr;
  count(number, nullptr, true, a, b);
  for (const Cell& cell : block.cells) {
    if (!cell.is_fresh) continue;
    const Cell* const other = at(1 - side, cell.field);
    const bool is_same =
        other != nullptr && last_[1 - side] != nullptr && are_same(&cell, block, other, *last_[1 - side]);
    if (!is_same && cause_[cell.field] == none) open_.push_back(cell.field);
    cause_[cell.field] = is_same ? none : number;
  }
  std::erase_if(open_, [this](std::uint32_t field) { return cause_[field] == none; });
  const Snapshot nothing;
  for (const Diagnostic& d : block.reported)
    add_report(side, d, nullptr, side == 0 ? block : nothing, side == 1 ? block : nothing);
}

}  // namespace isogloss::cli::parting
