#include "isogloss/engine/diagnostic.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace isogloss {

bool DiagnosticList::has_errors() const {
  return std::any_of(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::string_view to_string(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::warning: return "warning";
    case Severity::error: break;
  }
  return "error";
}

std::string fill_in(std::string_view text, const std::vector<std::string>& arguments) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool slot =
        text[i] == '{' && i + 2 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9' && text[i + 2] == '}';
    if (!slot) {
      out += text[i];
      continue;
    }
    const auto index = static_cast<std::size_t>(text[i + 1] - '0');
    if (index < arguments.size()) out += arguments[index];
    i += 2;
  }
  return out;
}

Diagnostic host_diagnostic(std::string_view code, Location where, std::initializer_list<std::string> arguments,
                           std::string hint) {
  for (const DiagnosticInfo& info : host_diagnostics())
    if (info.code == code)
      return {info.severity, std::string(code), fill_in(info.text, arguments), std::move(where), 0, std::move(hint)};
  throw std::logic_error("no host diagnostic " + std::string(code));
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char c : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (c == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < names.size() && i < most; ++i) out += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? out + " and " + std::to_string(names.size() - most) + " more" : out;
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& names) {
  // Lists of any length come from files. The names examined in the first milliseconds are enough for a hint.
  std::size_t comparisons_left = 10'000'000;
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : names) {
    const std::size_t size_difference =
        std::max(name.size(), candidate.size()) - std::min(name.size(), candidate.size());
    if (size_difference >= best_distance) continue;  // the distance is at least that
    const std::size_t cost = (name.size() + 1) * (candidate.size() + 1);
    if (cost > comparisons_left) break;
    comparisons_left -= cost;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = &candidate;
      best_distance = distance;
    }
  }
  return best != nullptr ? *best : std::string();
}

}  // namespace isogloss
