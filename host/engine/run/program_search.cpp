#include "run/program_search.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace isogloss {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t held_in_memory = 64 * 1024;  // files up to this size need no descriptor of their own

/// A small file, read once.
class HeldFile : public Source {
 public:
  explicit HeldFile(Source& from) {
    char buffer[4096];
    while (const std::size_t n = from.read(buffer, sizeof buffer)) text_.append(buffer, n);
    failure_ = from.failure();
  }
  std::string failure() const override { return failure_; }
  std::size_t read(char*, std::size_t) override { return 0; }
  bool has_places() const override { return true; }
  std::size_t read_at(std::uint64_t offset, char* buffer, std::size_t size) override {
    return offset < text_.size() ? text_.copy(buffer, size, offset) : 0;
  }

 private:
  std::string text_, failure_;
};

}  // namespace

ProgramSearch::ProgramSearch(const LinkedDialect& linked, const RunOptions& options, DiagnosticSink& sink, RunEnd& end,
                             Source& source, const std::string& name)
    : linked_(linked), options_(options), sink_(sink), end_(end) {
  if (!source.has_places()) spool_ = std::make_unique<Spool>(source);
  ProgramFile& file = files_.emplace_back();
  file.name = name;
  file.source = spool_ != nullptr ? spool_.get() : &source;
}

// ---- search

bool ProgramSearch::find(const ig_go& request, const Caller& caller, Target& out, std::string& reason) {
  const std::string_view label = view_of(request.label), start = view_of(request.start);
  const std::uint32_t line = caller.here.line;
  if ((request.scope & IG_IN_PROGRAM) != 0)
    if (const auto at = labels(caller.from, line).find(label, caller.here, IG_SEARCH_AROUND)) {
      out = {&caller.from, *at, true};
      return true;
    }
  std::string key =
      std::to_string(request.scope) + ':' + caller.from.name + ':' + std::string(start) + ':' + std::string(label);
  for (std::uint32_t i = 0; i < request.file_count; ++i) key.append(1, ':').append(view_of(request.files[i]));
  if (const auto known = known_.find(key); known != known_.end()) {
    out = known->second;
    return true;
  }
  const SearchedNames names({request.files, request.file_count});
  bool found = (request.scope & IG_IN_FILES) != 0 && find_in_files(request, caller, names, out);
  if (!found && (request.scope & IG_IN_FOLDERS) != 0) {
    found = find_in_folders(request, caller, names, out, reason);
    report_searched();
  }
  if (!found) {
    if (reason.empty()) reason = searched_in(request.scope, caller.from);
    return false;
  }
  if (!start.empty()) {
    const auto at = labels(*out.file, line).find(start, out.start, IG_SEARCH_TOP);
    if (!at) {
      if (options_.called && without_start_.insert(key).second) options_.called(label, out.file->name);
      reason = std::string(label) + " has no " + std::string(start);
      return false;
    }
    out.start = *at;
  }
  known_.emplace(key, out);
  if (options_.called) options_.called(label, out.file->name);
  return true;
}

/// A place that is not there yet counts, too.
void ProgramSearch::report_searched() {
  if (!options_.searched) return;
  std::vector<std::string> looked_in = places().looked_in();
  const std::pair now(looked_in.size(), neighbours_.has_value());
  if (std::exchange(searched_, now) == now) return;
  if (!places().asked().empty()) options_.searched(places().asked(), false);
  std::vector<std::string> all = options_.program_places;
  for (std::string& folder : looked_in)
    if (std::find(all.begin(), all.end(), folder == "." ? std::string() : folder) == all.end())
      all.push_back(std::move(folder));
  options_.searched(all, neighbours_.has_value());
}

/// In a file of several programs the one that the search order of the folders names first; of a dialect without such
/// an order, the first.
bool ProgramSearch::find_in_files(const ig_go& request, const Caller& caller, const SearchedNames& names, Target& out) {
  const std::string_view label = view_of(request.label);
  const bool has_order = !linked_.dialect.search_order.empty();
  const auto rank = [&](const std::string& folder) {
    if (!names.own_folders.empty()) {
      const bool is_own =
          std::find(names.own_folders.begin(), names.own_folders.end(), folder) != names.own_folders.end();
      return is_own ? 0 : folder.empty() && !places().has_own_folder(names) ? 1 : -1;
    }
    if (folder.empty() || folder == labels(main(), caller.here.line).folder_at(main_start_)) return 0;
    const int place = places().rank_of(folder, names);
    return place > 0 ? place : std::numeric_limits<int>::max();
  };
  const auto in_file = [&](ProgramFile& file) {
    if (has_order && file.is_of_folder) return false;  // a file of a folder has the folder's place in the order
    const LabelIndex& index = labels(file, caller.here.line);
    const auto at = has_order ? index.program(label, rank) : index.program(label);
    if (at) out = {&file, *at, false};
    return at.has_value();
  };
  bool found = in_file(caller.from);
  for (std::size_t i = 0; !found && i < files_.size(); ++i) found = in_file(files_[i]);
  return found;
}

std::string ProgramSearch::searched_in(std::uint32_t scope, const ProgramFile& from) {
  std::string where;
  if ((scope & IG_IN_PROGRAM) != 0) where = "this program";
  if ((scope & IG_IN_FILES) != 0) where = "the file " + from.name;
  if ((scope & IG_IN_FOLDERS) != 0) {
    const std::string folders = places().describe();
    if (!folders.empty()) where += (where.empty() ? "" : ", ") + folders;
  }
  return where.empty() ? "no folder was given" : "looked in " + where;
}

bool ProgramSearch::find_in_folders(const ig_go& request, const Caller& caller, const SearchedNames& names, Target& out,
                                    std::string& reason) {
  const std::string_view label = view_of(request.label);
  const auto take = [&](const ProgramPlaces::Found& found) {
    ProgramFile* const file = open(found, reason);
    if (file == nullptr) return false;
    const LabelIndex& index = labels(*file, caller.here.line);
    const auto at = index.program(label);
    if (!at && found.is_library) return false;
    if (!at && index.has_programs())
      sink_.add(host_diagnostic("IG-0420", {caller.from.name, caller.here.line, caller.here.column + 1},
                                {file->name, std::string(label)}));
    out = {file, at.value_or(BlockPlace{}), false};
    return true;
  };
  if (places().find(names, take, reason)) {
    report_hidden(request, caller, names, out);
    return true;
  }
  if (places().has_own_folder(names)) return false;
  for (ProgramFile& file : files_)  // one file of a folder may hold helpers beside the program it is named after
    if (const auto at = file.is_of_folder ? labels(file, caller.here.line).program(label) : std::nullopt) {
      out = {&file, *at, false};
      return true;
    }
  return find_in_neighbours(label, caller, out, reason);
}

void ProgramSearch::report_hidden(const ig_go& request, const Caller& caller, const SearchedNames& names,
                                  const Target& found) {
  if (found.file == nullptr || !hiding_.emplace(view_of(request.label)).second) return;
  const std::vector<std::string> hidden = places().hidden(names);
  if (!hidden.empty())
    sink_.add(host_diagnostic(
        "IG-0135", {caller.from.name, caller.here.line, caller.here.column + 1},
        {std::string(view_of(request.label)), found.file->name, hidden.front(), std::to_string(hidden.size())}));
}

/// A file of another name may hold the program. Where several do, it is not known which one the control has.
bool ProgramSearch::find_in_neighbours(std::string_view label, const Caller& caller, Target& out, std::string& reason) {
  if (not_in_neighbours_.contains(label)) return false;
  const Neighbour* only = nullptr;
  for (const Neighbour& one : neighbours(caller.here.line)) {
    if (!one.obstacle.empty()) reason = one.obstacle;
    if (!one.labels || !one.labels->program(label)) continue;
    if (only != nullptr) {
      reason = "it is in " + only->found.name + " and in " + one.found.name + ": name one file with --subprograms";
      return false;
    }
    only = &one;
  }
  if (only == nullptr) {
    not_in_neighbours_.emplace(label);
    return false;
  }
  ProgramFile* const file = open(only->found, reason);
  const auto at = file == nullptr ? std::nullopt : labels(*file, caller.here.line).program(label);
  if (!at) return false;
  sink_.add(host_diagnostic("IG-0451", {caller.from.name, caller.here.line, caller.here.column + 1},
                            {std::string(label), file->name}));
  out = {file, *at, false};
  return true;
}

const std::vector<ProgramSearch::Neighbour>& ProgramSearch::neighbours(std::uint32_t line) {
  if (neighbours_) return *neighbours_;
  neighbours_.emplace();
  for (const ProgramPlaces::Found& found : places().inside()) {
    Neighbour& one = neighbours_->emplace_back(Neighbour{found, std::nullopt, {}});
    const std::size_t known = files_.size();
    ProgramFile* const file = open(found, one.obstacle);
    if (file == nullptr) continue;
    one.labels = labels(*file, line);
    one.labels->keep_programs();
    if (files_.size() > known) files_.pop_back();
  }
  return *neighbours_;
}

ProgramFile* ProgramSearch::open(const ProgramPlaces::Found& found, std::string& reason) {
  std::error_code code;
  if (files_[0].path.empty() && files_[0].name != "-") files_[0].path = fs::canonical(files_[0].name, code);
  for (ProgramFile& file : files_)
    if (file.path == found.file) return &file;
  if (!fs::is_regular_file(found.file, code)) {
    reason = found.name + " is not a regular file";
    return nullptr;
  }
  std::string error;
  std::unique_ptr<Source> source = open_file(found.file.string(), error);
  if (source == nullptr) {
    reason = found.name + " cannot be read: " + error;
    return nullptr;
  }
  if (fs::file_size(found.file, code) <= held_in_memory) source = std::make_unique<HeldFile>(*source);
  ProgramFile& file = files_.emplace_back();
  file.name = found.name;
  file.path = found.file;
  file.is_of_folder = !found.is_library;
  file.source = source.get();
  file.owned = std::move(source);
  return &file;
}

// ---- what the search needs, made when it is first needed

LabelIndex& ProgramSearch::labels(ProgramFile& file, std::uint32_t line) {
  if (file.labels == nullptr) {
    const Chain::Interlude interlude;
    file.labels = indexer().index(file);
    if (file.source->is_lost()) report_lost(file, line);
    if (!file.source->failure().empty()) report_unreadable(file, 0);
  }
  return *file.labels;
}

void ProgramSearch::report_lost(const ProgramFile& file, std::uint32_t line) {
  end_.report_first(host_diagnostic("IG-0421", {file.name, line, 0}, {file.name}));
}

void ProgramSearch::report_unreadable(const ProgramFile& file, std::uint32_t line) {
  end_.report_first(host_diagnostic("IG-0431", {file.name, line, 0}, {file.source->failure()}));
}

Indexer& ProgramSearch::indexer() {
  if (indexer_ == nullptr) indexer_ = std::make_unique<Indexer>(linked_, options_.chain, options_.maximum_line_bytes);
  return *indexer_;
}

ProgramPlaces& ProgramSearch::places() {
  if (places_ == nullptr) {
    std::vector<std::string> extensions = linked_.dialect.extensions;
    extensions.push_back(fs::path(files_[0].name).extension().string());
    std::error_code code;
    const fs::path main = files_[0].name == "-" ? fs::path() : fs::canonical(files_[0].name, code);
    places_ = std::make_unique<ProgramPlaces>(options_.program_places, extensions, linked_.dialect.search_order,
                                              main.parent_path());
  }
  return *places_;
}

}  // namespace isogloss
