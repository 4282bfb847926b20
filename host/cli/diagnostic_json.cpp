#include "diagnostic_json.hpp"

namespace isogloss::cli {

Json describe(const Diagnostic& d) {
  Json out{{"Severity", to_string(d.severity)}, {"Code", d.code}, {"Message", d.message}};
  if (!d.where.file.empty()) out["File"] = d.where.file;
  if (d.where.line != 0) out["Line"] = d.where.line;
  if (d.where.column != 0) out["Column"] = d.where.column;
  if (d.end_column != 0) out["EndColumn"] = d.end_column;
  if (!d.hint.empty()) out["Hint"] = d.hint;
  return out;
}

}  // namespace isogloss::cli
