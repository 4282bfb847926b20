/// The number of a tool with a step index, as TOOL CALL and FN 18 give it.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/cnc/tool_names.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// The row of a number, 5.1 or 5.12, in the table of tools; nothing for a number whose fraction is no index. A number
/// does not tell 5.10 from 5.1: it is index 1.
inline std::optional<std::int64_t> step_row(double number) {
  const double tool = std::floor(number), fraction = (number - tool) * 100, hundredths = std::round(fraction);
  if (std::fabs(fraction - hundredths) > 1e-5 || !(tool >= 0 && tool < IG_TOOL_INDEX_STEP)) return std::nullopt;
  const auto digits = static_cast<std::int64_t>(hundredths);
  if (digits < 10 || digits > 99) return std::nullopt;  // of 5.01 nobody knows what it would be
  return indexed_tool(static_cast<std::int64_t>(tool), digits % 10 == 0 ? digits / 10 : digits);
}

/// The row of index 10, 20 and so on to 90, which a program writes as 5.10; nothing for other numbers.
inline std::optional<std::int64_t> written_step_row(std::string_view written) {
  const std::size_t point = skip_digits(written, 0);
  const bool is_index = (at(written, point) == '.' || at(written, point) == ',') && point + 3 == written.size() &&
                        at(written, point + 1) >= '1' && at(written, point + 1) <= '9' && written.back() == '0';
  const double tool = is_index ? ig::read_decimal(written.substr(0, point), 0).value : IG_TOOL_INDEX_STEP;
  if (point == 0 || !(tool < IG_TOOL_INDEX_STEP)) return std::nullopt;
  return indexed_tool(static_cast<std::int64_t>(tool), (written[point + 1] - '0') * 10);
}

}  // namespace heidenhain
