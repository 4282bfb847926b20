#include "known_codes.hpp"

#include <algorithm>

namespace isogloss {

std::vector<KnownCode> known_codes(const Library& library) {
  std::vector<KnownCode> out;
  for (const DiagnosticInfo& info : host_diagnostics()) out.push_back({info, "host"});
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->diagnostic_count; ++i) {
      const ig_diagnostic_decl& d = p.plugin->diagnostics[i];
      const auto same = std::find_if(out.begin(), out.end(), [&](const KnownCode& known) {
        return known.info.code == d.code && known.info.text == d.text;
      });
      if (same == out.end())
        out.push_back({{static_cast<Severity>(d.severity), d.code, d.text, d.explanation, d.example}, p.plugin->name});
      else
        same->plugin.append(", ").append(p.plugin->name);
    }
  return out;
}

}  // namespace isogloss
