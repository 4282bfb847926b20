#include <fmt/format.h>

#include "output_file.hpp"
#include "session.hpp"

namespace isogloss::cli {

int version_command(const Arguments& arguments) {
  CommandLine line("--version", "Version of the host, of the contract and of the plugins.", "isogloss --version");
  CommonOptions common;
  common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  Session session(common);
  session.library().load_all();
  std::string out = fmt::format("isogloss {}\ncontract {}.{}\n", ISOGLOSS_VERSION, IG_ABI_MAJOR, IG_ABI_MINOR);
  for (const LoadedPlugin& p : session.library().plugins())
    out += fmt::format("plugin {} {} ({})\n", p.plugin->name, p.plugin->version == nullptr ? "?" : p.plugin->version,
                       p.file.string());
  return print(out, success);
}

}  // namespace isogloss::cli
