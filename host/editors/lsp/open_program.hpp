/// A part program that is open in the editor, and what is known about its present text.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "lsp/analysis.hpp"
#include "lsp/text_document.hpp"

namespace isogloss::editors {

struct OpenProgram {
  std::string uri, path;
  TextDocument text;
  std::int64_t version = 0;
  std::shared_ptr<const Setup> setup;  ///< null: there is no dialect to run it
  std::vector<Diagnostic> setup_faults;
  std::optional<Analysis> analysis;  ///< of the present text; empty: it has changed
  std::optional<ScanMap> map;

  const ScanMap& scan_map() {
    if (!map) map = setup != nullptr ? scan(*setup, path, text) : ScanMap();
    return *map;
  }
  /// The text has changed.
  void forget() {
    analysis.reset();
    map.reset();
  }
};

/// What the answers to requests need beside the program itself.
struct Surroundings {
  Toolbox& toolbox;
  const Settings& settings;
  /// False: the answer is no longer wanted.
  std::function<bool()> goes_on;
  /// The text of another file: the editor's, else the disk's. Null where it cannot be read.
  std::function<std::shared_ptr<const TextDocument>(const std::string& path)> text_of;
  Columns columns = Columns::utf16;
};

/// An answer that is an error to the client: what it asks cannot be done.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Shapes of the protocol.
Json to_json(const Position& position);
Json to_json(const Range& range);
std::string uri_of(const std::string& path);
/// Empty for what is no file: URI; then `uri` itself names the text.
std::string path_of(const std::string& uri);
/// A line of a run in the program itself or in another file.
Json location_of(const OpenProgram& program, const Surroundings& around, const std::string& file, std::uint32_t line);
/// The whole line of the program without the blanks around it.
Range line_range(const TextDocument& text, std::uint32_t line);

}  // namespace isogloss::editors
