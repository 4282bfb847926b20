#include "surroundings.hpp"

namespace isogloss::cli {

void SurroundingOptions::add_to(CommandLine& line) {
  line.option("-d,--dialect", dialect,
              "Take options and dependencies from this dialect (default: the options' defaults, dependencies of " +
                  std::string(default_dialect) + ")")
      .type_name("DIALECT");
}

std::optional<Surroundings> SurroundingOptions::make(Session& session) const {
  session.library().load_all();
  Surroundings out;
  out.is_named = !dialect.empty();
  if (out.is_named) {
    out.dialect = session.reader().read(dialect, session.diagnostics());
    return out.dialect ? std::optional(std::move(out)) : std::nullopt;
  }
  // Where the default dialect is missing, the plugin's own syntaxes serve.
  DiagnosticList ignored;
  out.dialect = session.reader().read(default_dialect, ignored);
  return out;
}

}  // namespace isogloss::cli
