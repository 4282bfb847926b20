#include "diff/recorder.hpp"

#include <algorithm>
#include <filesystem>

namespace isogloss::cli::parting {

void Recorder::listen(Chain& chain) {
  chain_ = &chain;
  rows_.read_from(chain);
  chain.listen_to_rows();
  flow_ = static_cast<const ig_flow_1*>(chain.service(IG_FLOW_SERVICE));
  chain.trace = [this](std::uint32_t position, bool before) { trace(position, before); };
}

std::unique_ptr<Snapshot> Recorder::blank() {
  std::unique_ptr<Snapshot> out = out_.blank();
  out->key = {};
  out->is_initial = out->is_end = false;
  out->line = out->column = 0;
  out->file.clear();
  out->text.clear();
  out->cells.clear();
  out->stroke_cells.clear();
  out->lists.clear();
  out->matrices.clear();
  out->called.clear();
  out->rows.clear();
  out->arena.clear();
  out->reported.clear();
  out->reported.swap(reported_);
  return out;
}

void Recorder::begin(Document& initial, const SymbolTable& symbols) {
  std::unique_ptr<Snapshot> out = blank();
  out->is_initial = true;
  Open start;
  start.rows = chain_->rows_at_start;
  copy_cells(initial, symbols, *out);
  copy_rows(start, *out);
  out_.put(std::move(out));
}

bool Recorder::block(Document& document, const SymbolTable& symbols) {
  Open& o = open(document);
  if (o.called.empty() && &document == &chain_->document()) o.rows = chain_->answered_rows;
  std::unique_ptr<Snapshot> out = blank();
  out->file = o.file;
  out->line = o.line;
  out->column = o.column;
  out->text.assign(document.source.text);
  // The n-th block of its line: the columns of two programs, or of two ways to cut a line, do not agree.
  const bool goes_on = o.way == last_way_ && o.line == last_line_ && o.column > last_column_;
  ordinal_ = goes_on ? ordinal_ + 1 : 0;
  last_way_ = o.way;
  last_line_ = o.line;
  last_column_ = o.column;
  const bool is_main = order_ != nullptr && o.file == program_;
  out->key = {o.way, o.depth, is_main ? order_->rank(side_, o.line) : o.line, order_ != nullptr ? ordinal_ : o.column};
  out->called = o.called;
  copy_cells(document, symbols, *out);
  copy_lists(document, symbols, o, *out);
  copy_rows(o, *out);
  open_.erase(open_.begin() + (&o - open_.data()));
  return out_.put(std::move(out));
}

void Recorder::finish(std::string fault) {
  std::unique_ptr<Snapshot> out = blank();
  out->is_end = true;
  out->fault = std::move(fault);
  out_.put(std::move(out));
}

void Recorder::trace(std::uint32_t position, bool before) {
  auto* const document = const_cast<Document*>(Chain::breadcrumb().document);
  if (document == nullptr) return;
  Open& o = open(*document);
  const bool is_current = document == &chain_->document();
  if (before) {
    if (o.called.empty() && is_current) o.rows = chain_->answered_rows;
    rows_before_ = chain_->answered_rows.size();
    return;
  }
  o.called.push_back(static_cast<std::uint16_t>(position));
  for (std::size_t i = rows_before_; i < chain_->answered_rows.size(); ++i) o.rows.push_back(chain_->answered_rows[i]);
  for (std::size_t i = 0; i < document->lists.size(); ++i) {
    if (document->lists[i].count == o.counts[i]) continue;
    o.counts[i] = document->lists[i].count;
    o.makers[i] = static_cast<std::uint16_t>(position + 1);
    for (const std::uint64_t mask : document->lists[i].masks()) o.made[i] |= mask;
  }
}

Recorder::Open& Recorder::open(Document& document) {
  const BlockSource& source = document.source;
  for (Open& o : open_)
    if (o.line == source.line && o.column == source.column && o.file == source.file) return o;
  // What an earlier block left open has been dropped by the run, by an alarm for instance.
  constexpr std::size_t most_open = 4096;
  if (open_.size() >= most_open) open_.erase(open_.begin());
  Open& o = open_.emplace_back();
  o.file.assign(source.file);
  o.line = source.line;
  o.column = source.column;
  o.counts.resize(document.lists.size());
  o.makers.resize(document.lists.size());
  o.made.resize(document.lists.size());
  find_way(document, o);
  return o;
}

/// The calls that led to the block. Programs keep their names when their folder is another one.
void Recorder::find_way(Document& document, Open& open) const {
  const auto mix = [&open](std::uint64_t value) { open.way = (open.way ^ value) * 0x9E3779B97F4A7C15u; };
  const auto id_of = [this](std::string_view file) -> std::uint64_t {
    if (file == program_) return 1;
    const std::size_t slash = file.rfind('/');
    return std::hash<std::string_view>{}(slash == std::string_view::npos ? file : file.substr(slash + 1));
  };
  mix(id_of(open.file));
  if (flow_ == nullptr || flow_->frame == nullptr) return;
  std::string_view caller = program_;
  ig_frame f{};
  f.struct_size = sizeof f;
  for (std::uint32_t level = 0; flow_->frame(document.block(), level, &f) != 0; ++level) {
    const std::string_view file(f.file.data, f.file.size);
    if (level > 0) {
      const bool is_main = order_ != nullptr && caller == program_;
      mix(is_main ? order_->rank(side_, f.call_line) : f.call_line);
      mix(std::hash<std::string_view>{}({f.program.data, f.program.size}));
      mix(f.pass);
      open.depth = level;
    }
    caller = file;
  }
}

std::string_view Recorder::name_of(ig_symbol symbol, const SymbolTable& symbols) {
  if (symbol >= names_.size()) names_.resize(symbol + 1u);
  std::string_view& name = names_[symbol];
  if (name.data() == nullptr) name = texts_.emplace_back(symbols.text(symbol));
  return name;
}

void Recorder::copy_cells(const Document& document, const SymbolTable& symbols, Snapshot& out) {
  struct Text {
    std::size_t cell, begin, size;
  };
  std::vector<Text> texts;
  const std::vector<FieldInfo>& fields = document.layout().fields;
  const std::vector<std::uint32_t>& numbers = map_.of_field[static_cast<std::size_t>(side_)];
  for (std::uint32_t w = 0; w < document.words(); ++w) {
    const Document::Bits& bits = document.bits(w);
    for (std::uint64_t open = bits.present | (bits.taken & bits.words); open != 0; open &= open - 1) {
      const auto bit = static_cast<std::uint32_t>(__builtin_ctzll(open));
      const ig_field f = w * 64 + bit;
      if (f >= fields.size() || numbers[f] == no_field) continue;
      Cell cell{numbers[f], document.writer(f), Cell::Kind::number, document.fresh(f) || document.taken(f), 0, {}};
      switch (fields[f].type) {
        case IG_NUMBER: cell.number = document.number(f); break;
        case IG_SYMBOL:
          cell.kind = Cell::Kind::text;
          cell.text = name_of(static_cast<ig_symbol>(document.value(f).symbol), symbols);
          break;
        case IG_TEXT:
          cell.kind = Cell::Kind::text;
          texts.push_back({out.cells.size(), out.arena.size(), document.text(f).size()});
          out.arena.append(document.text(f));
          break;
        case IG_CODE: cell.kind = Cell::Kind::code; break;
        case IG_TRANSFORM: {
          cell.kind = Cell::Kind::matrix;
          cell.number = static_cast<double>(out.matrices.size());
          std::array<double, 16>& matrix = out.matrices.emplace_back();
          std::copy_n(document.frame(f).matrix, 16, matrix.begin());
          break;
        }
        default: cell.number = static_cast<double>(document.value(f).integer);
      }
      out.cells.push_back(cell);
    }
  }
  for (const Text& t : texts) out.cells[t.cell].text = std::string_view(out.arena).substr(t.begin, t.size);
}

void Recorder::copy_lists(const Document& document, const SymbolTable& symbols, const Open& open, Snapshot& out) {
  const auto side = static_cast<std::size_t>(side_);
  for (std::size_t l = 0; l < document.lists.size(); ++l) {
    const ListData& list = document.lists[l];
    if (list.count == 0) continue;
    const std::vector<FieldInfo>& fields = document.layout().lists[l].fields;
    StrokeList& strokes = out.lists.emplace_back();
    strokes.list = map_.of_list[side][l];
    strokes.maker = open.makers[l];
    for (std::uint32_t r = 0; r < list.count; ++r) {
      Stroke stroke{static_cast<std::uint32_t>(out.stroke_cells.size()), 0};
      for (std::uint32_t i = 0; i < list.stride && i < 64; ++i) {
        if ((list.present[r] >> i & 1) == 0 || map_.of_record[side][l][i] == no_field) continue;
        const ig_value value = list.values[std::size_t{r} * list.stride + i];
        Cell cell{map_.of_record[side][l][i], writer_of(open, l, i), Cell::Kind::number, true, 0, {}};
        const ig_type type = fields[i].type;
        if (type == IG_SYMBOL || type == IG_TEXT) {
          cell.kind = Cell::Kind::text;
          if (type == IG_SYMBOL) cell.text = name_of(static_cast<ig_symbol>(value.symbol), symbols);
        } else {
          cell.number = type == IG_NUMBER ? value.number : static_cast<double>(value.integer);
        }
        out.stroke_cells.push_back(cell);
      }
      stroke.end = static_cast<std::uint32_t>(out.stroke_cells.size());
      strokes.strokes.push_back(stroke);
    }
  }
}

/// Of a field of a list's records: the syntax that made the records, or a later one that adds to them.
std::uint16_t Recorder::writer_of(const Open& open, std::size_t list, std::uint32_t index) const {
  const auto side = static_cast<std::size_t>(side_);
  if ((open.made[list] >> index & 1) != 0) return open.makers[list];
  const std::uint32_t field = map_.of_record[side][list][index];
  for (auto p = open.called.rbegin(); p != open.called.rend(); ++p)
    if (*p + 1 != open.makers[list] && map_.writes[side][*p][field]) return static_cast<std::uint16_t>(*p + 1);
  return open.makers[list];
}

void Recorder::copy_rows(const Open& open, Snapshot& out) {
  for (const Chain::AnsweredRow& row : open.rows) {
    const auto is_it = [&row](const AskedRow& r) {
      return r.syntax == row.syntax && r.dependency == row.dependency && r.row == row.row;
    };
    if (row.syntax != 0 && std::none_of(out.rows.begin(), out.rows.end(), is_it))
      out.rows.push_back({row.syntax, row.dependency, row.row, rows_.read(row.dependency, row.row)});
  }
}

}  // namespace isogloss::cli::parting
