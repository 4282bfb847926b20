/// On which lines of which files a debugger may stop.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/stepping.hpp"

namespace isogloss::dap {

/// Reads a file when it is asked for it first. Any thread.
class StatementLines {
 public:
  /// All outlive it. `text` is that of the main program at `path`.
  StatementLines(const LinkedDialect& linked, const RunOptions& options, const std::string& path,
                 const std::string& text);
  /// The line on which the statement begins that stands on this line; empty: there is none. A file that cannot be read
  /// has a statement on each line.
  std::optional<std::uint32_t> statement_at(const std::string& file, std::uint32_t line);
  bool is_statement(std::string_view file, std::uint32_t line);
  /// The statements from one line to another one.
  std::vector<std::uint32_t> between(const std::string& file, std::uint32_t first, std::uint32_t last);

 private:
  struct File {
    bool is_read = false;
    std::vector<BlockLine> lines;
  };
  const File& file(const std::string& path);

  const LinkedDialect& linked_;
  const RunOptions& options_;
  const std::string path_;
  const std::string& text_;
  std::mutex mutex_;
  std::map<std::string, File> files_;             // by canonical path
  std::map<std::string_view, const File*> seen_;  // by the names that runs use
  std::vector<std::unique_ptr<std::string>> names_;
};

}  // namespace isogloss::dap
