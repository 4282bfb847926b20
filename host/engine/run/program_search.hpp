/// The files that a run has opened, and where the program that a call names is in them or in the given folders.
#pragma once

#include <set>
#include <unordered_map>

#include "run/program_files.hpp"
#include "run/program_places.hpp"
#include "run/run_end.hpp"
#include "run/spool.hpp"

namespace isogloss {

inline std::string_view view_of(const ig_text& text) { return {text.data, text.size}; }

class ProgramSearch {
 public:
  /// A source that can be read only once is kept as it is read.
  ProgramSearch(const LinkedDialect& linked, const RunOptions& options, DiagnosticSink& sink, RunEnd& end,
                Source& source, const std::string& name);

  /// The main program's file.
  ProgramFile& main() { return files_.front(); }
  const ProgramFile& main() const { return files_.front(); }

  struct Target {
    ProgramFile* file;
    BlockPlace start;
    bool is_local = false;  ///< a part of the calling program
  };
  /// Where a call is: the block at `here` in the file `from`.
  struct Caller {
    ProgramFile& from;
    const BlockPlace& here;
  };
  /// Where the program of the request begins. False when it is nowhere; `reason` is where it was looked for, or the
  /// obstacle.
  bool find(const ig_go& request, const Caller& caller, Target& out, std::string& reason);

  /// The main program begins there, so its folder is searched first.
  void begin_at(const BlockPlace& place) { main_start_ = place; }

  /// The names of the file's lines. Reading them may end the run; `line` is the one that the run is at.
  LabelIndex& labels(ProgramFile& file, std::uint32_t line);
  /// A part of a source that can be read only once was lost: the run cannot continue there.
  void report_lost(const ProgramFile& file, std::uint32_t line);
  /// The rest of the file is needed to know where a program continues.
  void report_unreadable(const ProgramFile& file, std::uint32_t line);

  Indexer& indexer();

 private:
  bool find_in_files(const ig_go& request, const Caller& caller, const SearchedNames& names, Target& out);
  bool find_in_folders(const ig_go& request, const Caller& caller, const SearchedNames& names, Target& out,
                       std::string& reason);
  void report_searched();
  void report_hidden(const ig_go& request, const Caller& caller, const SearchedNames& names, const Target& found);
  bool find_in_neighbours(std::string_view label, const Caller& caller, Target& out, std::string& reason);
  /// A file whose name tells nothing about the program: the programs that it holds, or why they are not known.
  struct Neighbour {
    ProgramPlaces::Found found;
    std::optional<LabelIndex> labels;
    std::string obstacle;
  };
  const std::vector<Neighbour>& neighbours(std::uint32_t line);
  std::string searched_in(std::uint32_t scope, const ProgramFile& from);
  ProgramFile* open(const ProgramPlaces::Found& found, std::string& reason);
  ProgramPlaces& places();

  const LinkedDialect& linked_;
  const RunOptions& options_;
  DiagnosticSink& sink_;
  RunEnd& end_;
  std::unique_ptr<Spool> spool_;
  std::deque<ProgramFile> files_;  // the main program's first
  std::unique_ptr<Indexer> indexer_;
  std::unique_ptr<ProgramPlaces> places_;
  std::unordered_map<std::string, Target> known_;
  std::set<std::string> without_start_;  // calls that were told although their program has no such start
  BlockPlace main_start_;
  std::set<std::string, std::less<>> hiding_;         // programs that were reported to hide others
  std::optional<std::vector<Neighbour>> neighbours_;  // read once, since a program may call any number of others
  std::set<std::string, std::less<>> not_in_neighbours_;
  std::optional<std::pair<std::size_t, bool>> searched_;  // places, and whether inside them, when it was told last
};

}  // namespace isogloss
