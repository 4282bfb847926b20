/// What the server answers about an XML file of a dialect or of a machine.
#pragma once

#include "isogloss/engine/library.hpp"
#include "lsp/open_program.hpp"

namespace isogloss::editors {

struct OpenDialect {
  std::string uri, path;
  TextDocument text;
  std::int64_t version = 0;
};

/// Is this text a file of a dialect or of a machine? Other XML is none of the server's business.
bool is_dialect(std::string_view text);
Json dialect_diagnostics(const OpenDialect& dialect, const Surroundings& around);
Json dialect_completion(const OpenDialect& dialect, const Position& at, const Surroundings& around);
Json dialect_hover(const OpenDialect& dialect, const Position& at, const Surroundings& around);
Json dialect_symbols(const OpenDialect& dialect);
Json dialect_actions(const OpenDialect& dialect, const Range& range, const Json& context, const Surroundings& around);

}  // namespace isogloss::editors
