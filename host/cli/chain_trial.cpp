#include "chain_trial.hpp"

#include "command.hpp"

namespace isogloss::cli {

bool can_begin(const LinkedDialect& linked, const ChainSettings& settings, Session& session) {
  DiagnosticList said;  // where a chain is made, the run that follows says it
  std::string why;
  try {
    const Chain chain(linked, settings, said);
    return true;
  } catch (const std::runtime_error& e) {
    why = e.what();
  }
  if (!said.has_errors()) session.report("IG-0513", {}, {why});
  for (Diagnostic& d : said.all) session.sink().add(std::move(d));
  return false;
}

int report_no_begin(const LinkedDialect& linked, const ChainSettings& settings, const std::string& path,
                    const std::runtime_error& fault, Session& session) {
  session.progress().hide();
  if (can_begin(linked, settings, session)) session.report("IG-0513", {path}, {fault.what()});
  return cannot_start;
}

}  // namespace isogloss::cli
