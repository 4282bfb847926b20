// Schemas: of files of dialects and machines, of tables and of blocks from what the plugins declare; of what the
// commands write as JSON from the folder `schemas` of the installation.
#include "isogloss/engine/schema.hpp"

#include <algorithm>

#include "output_file.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view schema_ending = ".schema.json";

/// In a build tree the schemas stand beside the command, as dialects do.
fs::path schema_folder() {
  const fs::path home = folder_of_executable();
  std::error_code ignored;
  const fs::path beside = home / "schemas";
  return fs::is_directory(beside, ignored) ? beside : home.parent_path() / "share/isogloss/schemas";
}

/// Those of JSON shapes, by name.
std::vector<std::string> shapes() {
  std::vector<std::string> out;
  std::error_code error;
  for (fs::directory_iterator it(schema_folder(), error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.ends_with(schema_ending) && name != "block.schema.json")
      out.push_back(name.substr(0, name.size() - schema_ending.size()));
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

int schema_command(const Arguments& arguments) {
  CommandLine line(
      "schema",
      "Prints a schema. From what the plugins declare: dialect, the XML Schema of files of dialects and "
      "machines; tables, that of table files without a namespace; block, the JSON Schema of the block "
      "document. The others are JSON Schemas of what the commands write: motion is a line of `run --emit "
      "motions`, summary of `run --summary --json`, batch of the results.jsonl of `batch`, diagnostic of "
      "--diagnostics json, chain belongs to `dialect --json`, and the rest to the --json of the command of that name.",
      "isogloss schema dialect > dialect.xsd && xmllint --noout --schema dialect.xsd mine.xml\n  "
      "isogloss schema motion > motion.schema.json");
  CommonOptions common;
  std::string what;
  std::vector<std::string> names = {"dialect", "tables", "block"};
  for (std::string& shape : shapes()) names.push_back(std::move(shape));
  line.option("WHAT", what, "Which one").required().one_of(names);
  common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  Session session(common);
  if (what != "dialect" && what != "tables" && what != "block") {
    const std::string file = (schema_folder() / (what + std::string(schema_ending))).string();
    std::string error;
    if (const std::optional<std::string> text = read_text(file, error)) return print(*text, success);
    session.report("IG-0510", {file}, {error});
    return cannot_start;
  }
  session.library().load_all();
  const Library& library = session.library();
  return print(what == "dialect"  ? dialect_schema(library)
               : what == "tables" ? table_schema(library)
                                  : block_schema(library),
               success);
}

}  // namespace isogloss::cli
