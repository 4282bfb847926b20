/// The column `fields` of MachineCodes: fields of the block and the values that a row gives them. Whether the dialect
/// has the field, its type and its unit is for the host, which knows all fields.
#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>

#include <isogloss/cnc/machine_codes.hpp>

namespace iso {

using namespace ig::cnc;

/// Texts that a field of this name may hold; empty: any.
inline std::string_view choices_of(std::string_view path) {
  if (path == "SpindleSpeed.Direction") return "CW, CCW, STOP";
  if (path == "Coolant.Mode") return "OFF, FLOOD, MIST, FLOOD+MIST, THROUGH";
  return {};
}

inline bool is_choice(std::string_view choices, std::string_view value) {
  for (std::size_t at = 0; at < choices.size();) {
    const std::size_t end = std::min(choices.find(',', at), choices.size());
    if (choices.substr(at, end - at) == value) return true;
    at = end + 2;
  }
  return false;
}

/// The lowest number that the field may hold; a feed rate of 0 moves nothing.
inline std::string_view fault_of_number(std::string_view path, double number) {
  for (const std::string_view section : {"SpindleSpeed.", "PathMode.", "PathSmoothing.", "Dwell.", "ToolChange."})
    if (path.starts_with(section) && number < 0) return "is less than 0";
  return path == "Feedrate.FeedrateValue" && number <= 0 ? "is not greater than 0" : "";
}

/// P, Q240 or 2, the number of an argument.
inline bool is_given_name(std::string_view name) {
  const std::size_t digits = skip_while(name, 0, is_letter);
  return !name.empty() && digits <= 2 && skip_digits(name, digits) == name.size() && name != "0";
}

/// A unit behind a number is checked by the host and not needed afterwards.
inline std::string_view without_unit(std::string_view value) {
  const std::size_t number = value.starts_with('{') ? value.find('}') + 1 : ig::read_decimal(value, 0).end;
  const bool is_number = number > 0 && number < value.size() && value[number] == ' ';
  return is_number ? value.substr(0, number) : value;
}

/// Why the row cannot set these fields; empty where it can.
inline std::string fields_fault(std::string_view fields) {
  std::string fault;
  std::set<std::string_view> seen;
  for_each_assignment(fields, [&](std::string_view path, std::string_view written) {
    const std::string field(path);
    const std::string_view value = without_unit(written);
    const auto from = GivenValue::read(value);
    const std::string_view constant = from ? from->otherwise : value;
    const ig::Decimal number = ig::read_decimal(constant, 0);
    const std::string_view choices = choices_of(path);
    if (!fault.empty()) return;
    if (path.empty() || value.empty())
      fault = "fields is a list of fields and values, as fields=\"Coolant.Mode=FLOOD; Dwell.Time={P}\"";
    else if (!seen.insert(path).second)
      fault = field + " stands twice in fields";
    else if (value.starts_with('{') && (!from || !is_given_name(from->name)))
      fault = std::string(value) + " is no word of a program: write {P}, {Q240}, {1} for an argument, or {P:2}";
    else if (!from && !choices.empty() && !is_choice(choices, value))
      fault = field + "=" + std::string(value) + " is none of " + std::string(choices);
    else if (number.ok && number.end == constant.size() && !fault_of_number(path, number.value).empty())
      fault = field + "=" + std::string(constant) + " " + std::string(fault_of_number(path, number.value));
  });
  const bool is_empty = fault.empty() && seen.empty() && !trim(fields).empty();
  return is_empty ? "fields names no field" : fault;
}

/// "Coolant.Mode=FLOOD; Dwell.Time={P}": without further blanks and units.
inline std::string canonical_fields(std::string_view fields) {
  std::string out;
  for_each_assignment(fields, [&](std::string_view path, std::string_view value) {
    out.append(out.empty() ? "" : "; ").append(path).append("=").append(without_unit(value));
  });
  return out;
}

}  // namespace iso
