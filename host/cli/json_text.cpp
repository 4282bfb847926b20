#include "json_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace isogloss::cli {

namespace {

bool is_plain_list(const Json& value) {
  return value.is_array() && std::none_of(value.begin(), value.end(), [](const Json& e) { return e.is_structured(); });
}

std::string plain(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (!is_plain_list(value)) return value.dump();
  std::string out;
  for (const Json& e : value) out += (out.empty() ? "" : " ") + plain(e);
  return out;
}

std::string lines(const Json& object, const std::string& indentation);

/// One line a record; what it holds besides plain values stands below.
std::string records_as_text(const Json& records, const std::string& indentation) {
  std::string out;
  for (const Json& record : records) {
    std::string line;
    Json below = Json::object();
    for (const auto& [name, cell] : record.items()) {
      if (cell.is_structured() && cell.empty()) continue;
      if (cell.is_structured() && !is_plain_list(cell)) {
        below[name] = cell;
        continue;
      }
      line += line.empty() ? plain(cell) : fmt::format("  {} {}", name, plain(cell));
    }
    out += indentation + line + "\n" + lines(below, indentation + "  ");
  }
  return out;
}

std::string lines(const Json& object, const std::string& indentation) {
  std::string out;
  for (const auto& [key, value] : object.items()) {
    if (value.is_structured() && value.empty()) continue;
    if (value.is_object())
      out += indentation + key + ":\n" + lines(value, indentation + "  ");
    else if (value.is_array() && !is_plain_list(value))
      out += indentation + key + ":\n" + records_as_text(value, indentation + "  ");
    else
      out += fmt::format("{}{}: {}\n", indentation, key, plain(value));
  }
  return out;
}

}  // namespace

std::string as_lines(const Json& object) { return lines(object, ""); }

std::string pretty(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace isogloss::cli
