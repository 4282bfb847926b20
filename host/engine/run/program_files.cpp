#include "run/program_files.hpp"

#include <algorithm>

#include "run/program_places.hpp"

namespace isogloss {

namespace {

std::uint64_t hash_of(std::string_view name) { return std::hash<std::string_view>{}(name); }

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

}  // namespace

// ---- labels

void LabelIndex::add(std::string_view name, ig_label_kind kind, const BlockPlace& at) {
  (kind == IG_LABEL_PROGRAM ? programs_ : labels_).push_back({hash_of(name), at});
}

void LabelIndex::add_folder(std::string_view folder) {
  if (!programs_.empty()) folders_[programs_.size() - 1] = in_small_letters(folder);
}

void LabelIndex::close() {
  std::sort(labels_.begin(), labels_.end());
  labels_.shrink_to_fit();
}

std::optional<BlockPlace> LabelIndex::program(std::string_view name) const {
  const std::uint64_t wanted = hash_of(name);
  for (const Entry& e : programs_)
    if (e.name == wanted) return e.at;
  return std::nullopt;
}

std::optional<BlockPlace> LabelIndex::program(std::string_view name,
                                              const std::function<int(const std::string&)>& rank) const {
  static const std::string none;
  const std::uint64_t wanted = hash_of(name);
  std::optional<BlockPlace> best;
  int best_rank = 0;
  for (std::size_t i = 0; i < programs_.size(); ++i) {
    if (programs_[i].name != wanted) continue;
    const auto folder = folders_.find(i);
    const int its_rank = rank(folder == folders_.end() ? none : folder->second);
    if (its_rank < 0 || (best && its_rank >= best_rank)) continue;
    best = programs_[i].at;
    best_rank = its_rank;
  }
  return best;
}

const std::string& LabelIndex::folder_at(const BlockPlace& place) const {
  static const std::string none;
  const auto next = std::upper_bound(programs_.begin(), programs_.end(), place,
                                     [](const BlockPlace& at, const Entry& e) { return at < e.at; });
  const auto index = next == programs_.begin() ? 0 : std::distance(programs_.begin(), next) - 1;
  const auto folder = folders_.find(static_cast<std::size_t>(index));
  return folder == folders_.end() ? none : folder->second;
}

std::optional<BlockPlace> LabelIndex::find(std::string_view name, const BlockPlace& from, ig_search search) const {
  const auto next = std::upper_bound(programs_.begin(), programs_.end(), from,
                                     [](const BlockPlace& place, const Entry& e) { return place < e.at; });
  const BlockPlace begin = next == programs_.begin() ? BlockPlace{0, 0, 0} : std::prev(next)->at;
  const std::uint64_t wanted = hash_of(name);
  const auto not_before = [&](const BlockPlace& place) {
    return std::lower_bound(labels_.begin(), labels_.end(), Entry{wanted, place});
  };
  const auto first = not_before(begin);
  const auto last = next == programs_.end() ? not_before({UINT64_MAX, UINT32_MAX, UINT32_MAX}) : not_before(next->at);
  if (first == last) return std::nullopt;
  if (search == IG_SEARCH_TOP) return first->at;
  const auto here = not_before(from);  // a block may jump to itself, but only when no other block has the name
  if (search == IG_SEARCH_BACKWARD) return here == first ? std::nullopt : std::optional(std::prev(here)->at);
  const auto behind = here != last && here->at == from ? here + 1 : here;
  if (behind != last) return behind->at;
  return search == IG_SEARCH_FORWARD ? std::nullopt : std::optional(first->at);
}

std::vector<BlockPlace> LabelIndex::programs_behind(const BlockPlace& place) const {
  std::vector<BlockPlace> out;
  for (const Entry& e : programs_)
    if (place < e.at) out.push_back(e.at);
  return out;
}

// ---- index

Indexer::Indexer(const LinkedDialect& linked, const ChainSettings& settings, std::size_t maximum_line_bytes)
    : chain_(
          linked,
          [&] {
            ChainSettings own = settings;
            own.mode = Mode::fast;
            return own;
          }(),
          ignored_),
      maximum_(maximum_line_bytes),
      segmenter_(linked.dialect.segmenter) {
  chain_.collect_labels();
  chain_.flow = this;
}

void Indexer::label(std::string_view name, ig_label_kind kind) {
  if (kind == IG_LABEL_PROGRAM && name.ends_with('/')) {
    if (labels_ != nullptr) labels_->add_folder(name.substr(0, name.size() - 1));
    return;
  }
  if (labels_ != nullptr) labels_->add(name, kind, at_);
  if (kind == IG_LABEL_PROGRAM) program_.assign(name);
}

/// No name of one file is known in the next.
void Indexer::start() {
  Document& d = chain_.document();
  for (ig_field f = 0; f < d.size(); ++f) d.erase(f);
  chain_.start();
}

std::unique_ptr<LabelIndex> Indexer::index(ProgramFile& file) {
  auto out = std::make_unique<LabelIndex>();
  labels_ = out.get();
  start();
  Cursor cursor(*file.source, maximum_, segmenter_);
  bool ended = false;
  for (Line line; !ended && cursor.next(line);) {
    std::size_t column = 0;
    do {
      const std::string_view rest = line.text.substr(column);
      if (is_blank(rest)) break;
      at_ = {line.offset, static_cast<std::uint32_t>(column), line.number};
      chain_.begin_block({file.name, line.number, static_cast<std::uint32_t>(column), rest, line.lines > 1});
      column += std::max<std::size_t>(chain_.scan(), 1);
      ended = chain_.ends_file;
    } while (!ended && column < line.text.size());
    ignored_.all.clear();
  }
  labels_ = nullptr;
  out->close();
  return out;
}

std::size_t Indexer::block_end(std::string_view text) {
  chain_.begin_block({{}, 0, 0, text, !segmenter_.continuation.empty()});
  const std::size_t end = chain_.scan();
  ignored_.all.clear();
  return end;
}

std::string Indexer::program_name(const std::string& text) {
  program_.clear();
  start();
  block_end(text);
  return program_;
}

}  // namespace isogloss
