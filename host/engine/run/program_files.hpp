/// The files that a run goes through, and the names of their lines.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>

#include "contract/flow_host.hpp"
#include "run/cursor.hpp"

namespace isogloss {

/// Where a block begins. Ordered as the blocks stand in their file.
struct BlockPlace {
  std::uint64_t offset = 0;  ///< of the line
  std::uint32_t column = 0;  ///< a line may hold several blocks
  std::uint32_t line = 1;
  friend bool operator==(const BlockPlace& a, const BlockPlace& b) {
    return a.offset == b.offset && a.column == b.column;
  }
  friend bool operator<(const BlockPlace& a, const BlockPlace& b) {
    return a.offset != b.offset ? a.offset < b.offset : a.column < b.column;
  }
};

/// The names of a file's lines, as hashes: what is kept of a line is where it is.
class LabelIndex {
 public:
  /// Labels come in the order of their places.
  void add(std::string_view name, ig_label_kind kind, const BlockPlace& at);
  /// The folder of the program that was added last.
  void add_folder(std::string_view folder);
  void close();

  std::optional<BlockPlace> program(std::string_view name) const;
  /// Of several programs of that name, the one whose folder has the lowest rank; a rank below 0 excludes it.
  std::optional<BlockPlace> program(std::string_view name,
                                    const std::function<int(const std::string& folder)>& rank) const;
  /// The folder of the program that stands at a place; empty where the file names none.
  const std::string& folder_at(const BlockPlace& place) const;
  bool has_programs() const { return !programs_.empty(); }
  /// Forgets the labels within the programs.
  void keep_programs() { labels_ = {}; }
  /// The label of the program that `from` stands in.
  std::optional<BlockPlace> find(std::string_view name, const BlockPlace& from, ig_search search) const;
  /// The programs that begin after a place, in order.
  std::vector<BlockPlace> programs_behind(const BlockPlace& place) const;

 private:
  struct Entry {
    std::uint64_t name;
    BlockPlace at;
    friend bool operator<(const Entry& a, const Entry& b) { return a.name != b.name ? a.name < b.name : a.at < b.at; }
  };
  std::vector<Entry> labels_;                     // by name, then place
  std::vector<Entry> programs_;                   // by place
  std::map<std::uint64_t, std::string> folders_;  // by the index of the program; in small letters
};

struct ProgramFile {
  std::string name;  ///< as diagnostics and events show it
  std::filesystem::path path;
  std::unique_ptr<Source> owned;
  Source* source = nullptr;   ///< has places
  bool is_of_folder = false;  ///< found by its name in a folder
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
  BlockPlace at_;
  LabelIndex* labels_ = nullptr;
  std::string program_;
};

}  // namespace isogloss
