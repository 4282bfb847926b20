#include "run/program_files.hpp"

#include <algorithm>
#include <set>

namespace isogloss {

namespace fs = std::filesystem;

namespace {

std::uint64_t hash_of(std::string_view name) { return std::hash<std::string_view>{}(name); }

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

}  // namespace

// ---- labels

void LabelIndex::add(std::string_view name, ig_label_kind kind, const Place& at) {
  (kind == IG_LABEL_PROGRAM ? programs_ : labels_).push_back({hash_of(name), at});
}

void LabelIndex::close() {
  std::sort(labels_.begin(), labels_.end());
  labels_.shrink_to_fit();
}

std::optional<Place> LabelIndex::program(std::string_view name) const {
  const std::uint64_t wanted = hash_of(name);
  for (const Entry& e : programs_)
    if (e.name == wanted) return e.at;
  return std::nullopt;
}

std::optional<Place> LabelIndex::find(std::string_view name, const Place& from, ig_search search) const {
  const auto next = std::upper_bound(programs_.begin(), programs_.end(), from,
                                     [](const Place& place, const Entry& e) { return place < e.at; });
  const Place begin = next == programs_.begin() ? Place{0, 0, 0} : std::prev(next)->at;
  const std::uint64_t wanted = hash_of(name);
  const auto not_before = [&](const Place& place) {
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

std::vector<Place> LabelIndex::programs_behind(const Place& place) const {
  std::vector<Place> out;
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

// ---- places

ProgramPlaces::ProgramPlaces(const std::vector<std::string>& places, const std::vector<std::string>& extensions) {
  for (const std::string& place : places) {
    std::error_code code;
    Folder folder;
    folder.shown = place.empty() ? "." : place;
    folder.resolved = fs::canonical(folder.shown, code);
    if (code) continue;
    folder.is_library = !fs::is_directory(folder.resolved, code);
    folders_.push_back(std::move(folder));
  }
  extensions_.emplace_back();
  for (const std::string& e : extensions) extensions_.push_back(lower(e));
}

void ProgramPlaces::list(Folder& folder) const {
  folder.is_listed = true;
  std::error_code code;
  for (fs::directory_iterator i(folder.resolved, code), end; !code && i != end; i.increment(code)) {
    const std::string name = i->path().filename().string();
    const std::string extension = lower(i->path().extension().string());
    if (std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end())
      folder.files[lower(i->path().stem().string())].push_back(name);
    if (!extension.empty()) folder.files[lower(name)].push_back(name);
  }
  const auto rank = [&](const std::string& name) {
    const std::string extension = lower(fs::path(name).extension().string());
    return std::find(extensions_.begin(), extensions_.end(), extension) - extensions_.begin();
  };
  for (auto& [stem, names] : folder.files)
    std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
      return std::pair(rank(a), a) < std::pair(rank(b), b);
    });
}

bool ProgramPlaces::find(std::span<const ig_text> stems, const std::function<bool(const Found&)>& take,
                         std::string& reason) {
  for (Folder& folder : folders_) {
    if (folder.is_library) {
      if (take({folder.resolved, folder.shown, true})) return true;
      continue;
    }
    if (!folder.is_listed) list(folder);
    for (const ig_text& stem : stems) {
      const auto named = folder.files.find(lower({stem.data, stem.size}));
      if (named == folder.files.end()) continue;
      for (const std::string& name : named->second) {
        std::error_code code;
        const fs::path resolved = fs::canonical(folder.resolved / name, code);
        const std::string shown = folder.shown == "." ? name : (fs::path(folder.shown) / name).string();
        if (code)
          reason = shown + " cannot be read: " + code.message();
        else if (resolved.parent_path() != folder.resolved)
          reason = shown + " is a link that leads out of its folder";
        else if (fs::is_directory(resolved, code))
          reason = shown + " is a folder";
        else if (take({resolved, shown, false}))
          return true;
      }
    }
  }
  return false;
}

bool ProgramPlaces::find_inside(const std::function<bool(const Found&)>& take) {
  constexpr std::size_t most_files = 256;
  for (Folder& folder : folders_) {
    if (folder.is_library) continue;
    if (!folder.is_listed) list(folder);
    std::set<std::string> names;
    for (const auto& [stem, files] : folder.files)
      for (const std::string& name : files)
        if (const std::string e = lower(fs::path(name).extension().string());
            std::find(extensions_.begin(), extensions_.end(), e) != extensions_.end())
          names.insert(name);
    if (names.size() > most_files) continue;
    for (const std::string& name : names) {
      std::error_code code;
      const fs::path resolved = fs::canonical(folder.resolved / name, code);
      if (code || resolved.parent_path() != folder.resolved || !fs::is_regular_file(resolved, code)) continue;
      const std::uintmax_t size = fs::file_size(resolved, code);
      if (code || size > inside_bytes_left_ || inside_files_left_ == 0) continue;
      inside_bytes_left_ -= size;
      --inside_files_left_;
      const std::string shown = folder.shown == "." ? name : (fs::path(folder.shown) / name).string();
      if (take({resolved, shown, true})) return true;
    }
  }
  return false;
}

std::string ProgramPlaces::describe() const {
  std::string out;
  for (const Folder& folder : folders_)
    out += (out.empty() ? "" : ", ") + std::string(folder.is_library ? "file " : "folder ") + folder.shown;
  return out;
}

}  // namespace isogloss
