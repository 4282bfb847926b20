// Length 1 with its adapter and wear, the radius with its wear, and the names of tools.
#include "archive/tool_rows.hpp"

#include <charconv>
#include <cmath>
#include <set>

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr std::int64_t most_tools = 32'000, most_rows = 99'999;

const char* kind_of(std::string_view name) {
  if (name.starts_with("$TC_SCP") || name.starts_with("$TC_ECP")) return "sum offsets and setup offsets";
  if (name.starts_with("$TC_MOP") || name.starts_with("$TC_TP")) return "tool management data";
  if (name.starts_with("$TC_M")) return "magazine data";
  if (name.starts_with("$TC_CARR")) return "tool carriers";
  return "other tool data";
}

const char* kind_of_edge_data(std::int64_t number) {
  switch (number) {
    case 4:
    case 5:
    case 13:
    case 14:
    case 22:
    case 23: return "lengths 2 and 3 of an edge";
    default: return "other data of an edge";
  }
}

std::int64_t number_behind(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return -1;
  std::int64_t n = -1;
  const char* const end = name.data() + name.size();
  const auto [last, error] = std::from_chars(name.data() + prefix.size(), end, n);
  return error == std::errc{} && last == end ? n : -1;
}

}  // namespace

ToolRows::Edge* ToolRows::edge(ig::Import& file, const Assignment& a, std::int64_t tool, std::int64_t number) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  if (tool < 1 || tool > most_tools || number < 1 || number > most_edges) {
    file.report(ig::diag("SIE-0344"), begin, end, shown(a.full_name()));
    return nullptr;
  }
  Edge& out = edges_[{tool, number}];
  if (out.end == 0) out.begin = begin, out.end = end;
  return &out;
}

void ToolRows::assign(ig::Import& file, const Assignment& a) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  if (const std::int64_t number = number_behind(a.name, "$TC_DP"); number > 0) return assign_edge_data(file, a, number);
  if (a.name != "$TC_TP2") return file.unused(kind_of(a.name), no_place, begin, end);
  const std::optional<std::string_view> name = quoted_text(a.value);
  if (!name) return file.report(ig::diag("SIE-0342"), begin, end, shown(a.full_name()), shown(a.value));
  Edge* const first = a.index.size() == 1 ? edge(file, a, a.number(0), 1) : edge(file, a, -1, 1);
  if (first == nullptr) return;
  first->name.clear();
  for (const char c : *name) first->name += static_cast<unsigned char>(c) < ' ' || c == 0x7F ? ' ' : c;
}

void ToolRows::assign_edge_data(ig::Import& file, const Assignment& a, std::int64_t number) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  const std::optional<double> value = number_of(a.value);
  if (!value || !(std::fabs(*value) < 1e9))
    return file.report(ig::diag("SIE-0342"), begin, end, shown(a.full_name()), shown(a.value));
  Edge* const e = a.index.size() == 2 ? edge(file, a, a.number(0), a.number(1)) : edge(file, a, -1, -1);
  if (e == nullptr) return;
  switch (number) {
    case 1: e->type = *value, e->has_type = true; return;
    case 3: e->length = value; return;
    case 6: e->radius = value; return;
    case 7: e->corner = Placed{*value, begin, end}; return;
    case 12: e->length_wear = value; return;
    case 15: e->radius_wear = value; return;
    case 16: e->corner_wear = Placed{*value, begin, end}; return;
    case 21: e->adapter = value; return;
    default:
      if (*value != 0) file.unused(kind_of_edge_data(number), no_place, begin, end);
  }
}

/// Of mills: $TC_DP7 of a slotting saw is the width of its slot.
void ToolRows::give_corner(ig::Import& file, const Edge& e, ArchiveLengths& lengths) {
  const bool may_be_mill = e.type == 0 || (e.type >= 100 && e.type < 200);
  const auto give = [&](const std::optional<Placed>& corner, const char* column, double least) {
    if (!corner || (corner->value == 0 && !may_be_mill)) return;
    if (!may_be_mill || corner->value < least)
      return file.unused("corner radius of an edge", no_place, corner->begin, corner->end);
    file.cell(column, lengths.mm(corner->value, corner->begin, corner->end), corner->begin);
  };
  give(e.corner, "CornerRadius", 0);
  give(e.corner_wear, "CornerRadiusWear", -1e9);
}

void ToolRows::give(ig::Import& file, ArchiveLengths& lengths, std::int64_t edge_step) const {
  bool is_turning_reported = false;
  std::set<std::string> rows;
  for (const auto& [id, e] : edges_) {
    const auto [tool, number] = id;
    std::string row = std::to_string(tool);
    if (edge_step > 0) row = std::to_string(tool + (number - 1) * edge_step);
    if (edge_step == 0 && number > 1) row += '.' + std::to_string(number);
    if (edge_step > 0 && tool + (number - 1) * edge_step > most_rows) {
      file.report(ig::diag("SIE-0344"), e.begin, e.end, "row " + row);
      continue;
    }
    if (!rows.insert(row).second) {
      file.report(ig::diag("SIE-0356"), e.begin, e.end, row, static_cast<double>(tool), static_cast<double>(number));
      continue;
    }
    file.row("ToolOffsetTable", row, e.begin);
    if (!e.is_turning_tool()) {
      if (e.length || e.adapter)
        file.cell("H", lengths.mm(e.length.value_or(0) + e.adapter.value_or(0), e.begin, e.end), e.begin);
      if (e.length_wear) file.cell("HWear", lengths.mm(*e.length_wear, e.begin, e.end), e.begin);
    } else if (!is_turning_reported) {
      is_turning_reported = true;
      file.report(ig::diag("SIE-0348"), e.begin, e.end, static_cast<double>(tool), e.type);
    }
    if (e.radius) file.cell("D", lengths.mm(*e.radius, e.begin, e.end) * e.radius_of_entry(), e.begin);
    if (e.radius_wear) file.cell("DWear", lengths.mm(*e.radius_wear, e.begin, e.end) * e.radius_of_entry(), e.begin);
    give_corner(file, e, lengths);
    if (e.has_type && e.type >= 0 && e.type <= 9999) file.cell("Type", e.type, e.begin);
    if (e.has_type && !(e.type >= 0 && e.type <= 9999)) file.unused("type of an edge", no_place, e.begin, e.end);
    if (!e.name.empty()) file.cell("Name", e.name, e.begin);
  }
}

}  // namespace siemens
