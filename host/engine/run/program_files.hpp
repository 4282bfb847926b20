/// The files that a run goes through: the names of their lines, and where a called program may be.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <span>

#include "contract/flow_host.hpp"
#include "run/cursor.hpp"

namespace isogloss {

/// Where a block begins. Ordered as the blocks stand in their file.
struct Place {
  std::uint64_t offset = 0;  ///< of the line
  std::uint32_t column = 0;  ///< a line may hold several blocks
  std::uint32_t line = 1;
  friend bool operator==(const Place& a, const Place& b) { return a.offset == b.offset && a.column == b.column; }
  friend bool operator<(const Place& a, const Place& b) {
    return a.offset != b.offset ? a.offset < b.offset : a.column < b.column;
  }
};

/// The names of a file's lines, as hashes: what is kept of a line is where it is.
class LabelIndex {
 public:
  /// Labels come in the order of their places.
  void add(std::string_view name, ig_label_kind kind, const Place& at);
  void close();

  std::optional<Place> program(std::string_view name) const;
  bool has_programs() const { return !programs_.empty(); }
  /// The label of the program that `from` stands in.
  std::optional<Place> find(std::string_view name, const Place& from, ig_search search) const;
  /// The programs that begin after a place, in order.
  std::vector<Place> programs_behind(const Place& place) const;

 private:
  struct Entry {
    std::uint64_t name;
    Place at;
    friend bool operator<(const Entry& a, const Entry& b) { return a.name != b.name ? a.name < b.name : a.at < b.at; }
  };
  std::vector<Entry> labels_;    // by name, then place
  std::vector<Entry> programs_;  // by place
};

struct ProgramFile {
  std::string name;  ///< as diagnostics and events show it
  std::filesystem::path path;
  std::unique_ptr<Source> owned;
  Source* source = nullptr;  ///< has places
  std::unique_ptr<LabelIndex> labels{};
};

/// A separate chain whose scanners report the names of lines; it builds nothing and reports no diagnostics.
class Indexer : public FlowHost {
 public:
  Indexer(const LinkedDialect& linked, const ChainSettings& settings, std::size_t maximum_line_bytes);
  std::unique_ptr<LabelIndex> index(ProgramFile& file);
  /// Where the block that begins with this text ends.
  std::size_t block_end(std::string_view text);
  /// The program label that this text is, in the one form that labels have; empty: none.
  std::string program_name(const std::string& text);

  void label(std::string_view name, ig_label_kind kind) override;
  std::int32_t go(const Document&, ig_go&) override { return IG_GO_DONE; }
  bool frame(std::uint32_t, ig_frame&) const override { return false; }
  ig_place here() const override { return {0, at_.offset, at_.line, at_.column}; }
  bool is_file(std::string_view, std::string_view) const override { return false; }

 private:
  void start();

  DiagnosticList ignored_;
  Chain chain_;
  std::size_t maximum_;
  const Segmenter& segmenter_;
  Place at_;
  LabelIndex* labels_ = nullptr;
  std::string program_;
};

/// Finds files of programs by name. Only what lies in the given folders itself is found: no path, no link that leads
/// elsewhere.
class ProgramPlaces {
 public:
  ProgramPlaces(const std::vector<std::string>& places, const std::vector<std::string>& extensions);
  struct Found {
    std::filesystem::path file;  ///< resolved
    std::string name;            ///< as it is shown
    bool is_library = false;     ///< a file of several programs: used only when it holds the label
  };
  /// Calls `take` with each file that may hold the program, the best first, until it returns true. An obstacle is
  /// written to `reason`.
  bool find(std::span<const ig_text> stems, const std::function<bool(const Found&)>& take, std::string& reason);
  /// Every file of the folders that may hold programs, whatever its name; of a folder of more than 256 none. All calls
  /// together read 64 MiB of 4096 files at most: a program may ask for any number of others.
  bool find_inside(const std::function<bool(const Found&)>& take);
  std::string describe() const;  ///< "folder a, file b"

 private:
  struct Folder {
    std::string shown;
    std::filesystem::path resolved;
    bool is_listed = false, is_library = false;
    std::map<std::string, std::vector<std::string>, std::less<>> files;  // by stem in lower case
  };
  void list(Folder& folder) const;
  std::uintmax_t inside_bytes_left_ = std::uintmax_t{64} << 20;
  std::size_t inside_files_left_ = 4096;
  std::vector<Folder> folders_;
  std::vector<std::string> extensions_;
};

}  // namespace isogloss
