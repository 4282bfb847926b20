/// The summary of a run for people, one "name: value" a line, and for programs.
#pragma once

#include <string>

#include "isogloss/engine/diagnostic_writer.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss::cli {

std::string summary_text(const std::string& program, const std::string& dialect, const Summary& summary,
                         const DiagnosticWriter& diagnostics);
/// The same as one line of JSON: schemas/summary.schema.json.
std::string summary_json(const std::string& program, const std::string& dialect, const Summary& summary,
                         const DiagnosticWriter& diagnostics);

}  // namespace isogloss::cli
