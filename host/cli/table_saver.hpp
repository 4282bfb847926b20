/// Tables of dependencies as a run left them, written to files that a later run can be given.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "isogloss/engine/exporter.hpp"
#include "session.hpp"

namespace isogloss::cli {

/// "MacroVariables=kept.xml": the dependency's name in the dialect, and the file.
using TableRequest = std::pair<std::string, std::string>;
/// Empty, and reported, where a text is not such a request.
std::optional<std::vector<TableRequest>> read_table_requests(const std::vector<std::string>& texts, Session& session);

/// Writes the tables at the end of a run; failures are reported.
std::unique_ptr<Exporter> make_table_saver(const std::vector<TableRequest>& requests, Session& session);

}  // namespace isogloss::cli
