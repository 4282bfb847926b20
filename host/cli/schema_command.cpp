#include "isogloss/engine/schema.hpp"

#include "output_file.hpp"
#include "session.hpp"

namespace isogloss::cli {

int schema_command(const Arguments& arguments) {
  CommandLine line("schema",
                   "Prints the XML Schema of dialect files or the JSON Schema of the block document, "
                   "made from what the plugins declare.",
                   "isogloss schema dialect > dialect.xsd");
  CommonOptions common;
  std::string what;
  line.option("WHAT", what, "dialect or block").required().one_of({"dialect", "block"});
  common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  Session session(common);
  session.library().load_all();
  return print(what == "dialect" ? dialect_schema(session.library()) : block_schema(session.library()), success);
}

}  // namespace isogloss::cli
