#include "explain/explain_code.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "known_codes.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace {

std::optional<KnownCode> find_code(const std::string& code, Library& library) {
  const auto find = [&]() -> std::optional<KnownCode> {
    for (const KnownCode& known : known_codes(library))
      if (known.info.code == code) return known;
    return std::nullopt;
  };
  if (auto of_the_host = find()) return of_the_host;
  library.load_all();
  return find();
}

/// The text of a diagnostic without its numbered places, which a program fills: "stopped after … errors".
std::string without_places(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '{' ? text.find('}', i) : std::string_view::npos;
    const std::string_view number = end == std::string_view::npos ? "" : text.substr(i + 1, end - i - 1);
    const bool is_place =
        !number.empty() && std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_place) {
      out += text[i];
      continue;
    }
    out += "…";
    i = end;
  }
  return out;
}

/// On the line of its heading where it is one line, else below it.
std::string example_text(std::string_view example) {
  if (example.find('\n') == std::string_view::npos) return fmt::format("Example: {}\n", printable(example));
  std::string out = "Example:\n";
  while (!example.empty()) {
    const std::string_view line = example.substr(0, example.find('\n'));
    example.remove_prefix(std::min(line.size() + 1, example.size()));
    out += "  " + printable(line) + "\n";
  }
  return out;
}

}  // namespace

bool is_code(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  const std::string_view prefix = text.substr(0, text.find('-'));
  const std::string_view number = text.substr(std::min(prefix.size() + 1, text.size()));
  return !prefix.empty() && is_capital(prefix.front()) && !number.empty() &&
         std::all_of(prefix.begin(), prefix.end(), [&](char c) { return is_capital(c) || is_digit(c); }) &&
         std::all_of(number.begin(), number.end(), is_digit);
}

int explain_code(const std::string& code, bool json, Session& session) {
  const std::optional<KnownCode> found = find_code(code, session.library());
  if (!found) {
    session.report("IG-0516", {}, {code}, "isogloss list diagnostics names them");
    return cannot_start;
  }
  if (json)
    return print(pretty({{"Code", found->info.code},
                         {"Severity", to_string(found->info.severity)},
                         {"Plugin", found->plugin},
                         {"Text", found->info.text},
                         {"Explanation", found->info.explanation},
                         {"Example", found->info.example}}),
                 success);
  return print(
      fmt::format("{} ({}, {})\n  {}\n\n{}\n\n{}", found->info.code, to_string(found->info.severity), found->plugin,
                  without_places(found->info.text), found->info.explanation, example_text(found->info.example)),
      success);
}

}  // namespace isogloss::cli
