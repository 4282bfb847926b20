/// Rows of ToolOffsetTable that an importer gives: their keys, and the size of the table.
#pragma once

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace tables {

class ToolRows {
 public:
  explicit ToolRows(ig::Import& file) : file_(file) {}

  static constexpr std::int64_t most_tools = 99'999, most_indices = 99;

  /// "5", "T5" and "005" are 5, "5.1" is index 1 of tool 5; empty where the text is no row of the table.
  static std::string key_of(std::string_view text) {
    if (text.starts_with('T') || text.starts_with('t')) text.remove_prefix(1);
    const std::size_t point = text.find('.');
    const std::int64_t tool = digits(text.substr(0, point), most_tools);
    if (tool < 1) return {};
    if (point == std::string_view::npos) return std::to_string(tool);
    const std::int64_t index = digits(text.substr(point + 1), most_indices);
    if (index < 0) return {};
    return index == 0 ? std::to_string(tool) : std::to_string(tool) + "." + std::to_string(index);
  }

  /// The cells that follow belong to this row. A second row with the same key is reported; its cells win.
  void begin(const std::string& key, std::size_t begin, std::size_t end) {
    if (!keys_.insert(key).second) file_.report(ig::diag("TAB-0105"), begin, end, key);
    add(key, begin);
  }
  /// A row to which a tool of another number belongs.
  void add(const std::string& key, std::size_t place) {
    is_large_ = is_large_ || digits(key.substr(0, key.find('.')), most_tools) > most_shipped;
    file_.row("ToolOffsetTable", key, place);
  }
  /// All importers raise the size alike, so that the tables of two files agree.
  void finish() {
    if (is_large_) file_.option("ToolOffsetTable", "size", std::to_string(most_tools), file_.text().size());
  }

 private:
  static constexpr std::int64_t most_shipped = 400;

  /// -1 where the text is no whole number up to `most`.
  static std::int64_t digits(std::string_view text, std::int64_t most) {
    std::int64_t n = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, n);
    return error == std::errc{} && stop == end && n >= 0 && n <= most ? n : -1;
  }

  ig::Import& file_;
  std::set<std::string> keys_;
  bool is_large_ = false;
};

}  // namespace tables
