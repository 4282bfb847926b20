#include <fmt/format.h>

#include "output_file.hpp"
#include "session.hpp"

namespace isogloss::cli {

int version_command(const Arguments& arguments) {
  const auto app =
      make_app("--version", "Version of the host, of the contract and of the plugins.", "isogloss --version");
  CommonOptions common;
  common.add_to(*app);
  if (const auto done = parse(*app, arguments)) return *done;
  Session session(common);
  session.library().load_all();
  std::string out = fmt::format("isogloss {}\ncontract {}.{}\n", ISOGLOSS_VERSION, IG_ABI_MAJOR, IG_ABI_MINOR);
  for (const LoadedPlugin& p : session.library().plugins())
    out += fmt::format("plugin {} {} ({})\n", p.plugin->name, p.plugin->version == nullptr ? "?" : p.plugin->version,
                       p.file.string());
  return print(out, success);
}

}  // namespace isogloss::cli
