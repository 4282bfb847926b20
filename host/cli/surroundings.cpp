#include "surroundings.hpp"

namespace isogloss::cli {

void SurroundingOptions::add_to(CommandLine& line) {
  line.option("-d,--dialect", dialect,
              "Take options and dependencies from this dialect (default: the options' defaults, dependencies of " +
                  std::string(default_dialect) + ")")
      .type_name("DIALECT");
  line.option("-m,--machine", machine, "Take options and dependencies from this machine").type_name("MACHINE");
}

std::optional<Surroundings> SurroundingOptions::make(Session& session) const {
  session.library().load_all();
  Surroundings out;
  const std::optional<std::string> named = session.dialect_or_machine(dialect, machine);
  if (!named) return std::nullopt;
  out.is_named = !named->empty();
  if (out.is_named) {
    out.dialect = session.read(*named);
    return out.dialect ? std::optional(std::move(out)) : std::nullopt;
  }
  // Where the default dialect is missing, the plugin's own syntaxes serve.
  DiagnosticList ignored;
  out.dialect = session.reader().read(default_dialect, ignored);
  return out;
}

}  // namespace isogloss::cli
