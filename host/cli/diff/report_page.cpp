// The page is made from the JSON form: both show the same.
#include <fmt/format.h>

#include "diff/report.hpp"
#include "markup.hpp"

namespace isogloss::cli::parting {

namespace {

std::string shown(const Json& value) {
  if (value.is_null()) return "–";
  return visible_xml(value.is_string() ? value.get<std::string>() : value.dump());
}

std::string place(const Json& at) {
  return at.is_null() ? std::string("–") : fmt::format("{}:{}", shown(at["File"]), at["Line"].dump());
}

std::string row(std::initializer_list<std::string> cells, std::string_view tag = "td") {
  std::string out = "<tr>";
  for (const std::string& cell : cells) out += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return out + "</tr>\n";
}

std::string block_rows(const Json& block) {
  std::string out;
  for (const char* const side : {"A", "B"})
    if (const Json& at = block[side]; !at.is_null())
      out += row({side, place(at), fmt::format("<code>{}</code>", shown(at.value("Text", Json("")))), ""});
  for (const Json& v : block["Values"]) {
    const auto value = [&v](const char* side) {
      return shown(v[side]) + (v.contains("Unit") && !v[side].is_null() ? " " + shown(v["Unit"]) : "");
    };
    out += row({"", shown(v["Field"]), value("A"), value("B")});
  }
  return out;
}

std::string cause_section(const Json& cause) {
  std::string out =
      fmt::format("<details><summary>{} <b>{} blocks</b></summary>\n", shown(cause["Cause"]), cause["Blocks"].dump());
  if (!cause["Evidence"].empty()) {
    out += "<table>" + row({"A", "value", "B", "value", ""}, "th");
    for (const Json& e : cause["Evidence"])
      out += row({shown(e["NameA"]) + "<br><small>" + shown(e["PlaceA"]) + "</small>", shown(e["A"]),
                  shown(e["NameB"]) + "<br><small>" + shown(e["PlaceB"]) + "</small>", shown(e["B"]),
                  e["Trial"].is_null()    ? ""
                  : e["Trial"] == "Cause" ? "tried: the cause"
                                          : "tried: no cause"});
    out += "</table>\n";
  }
  if (!cause["Fields"].empty()) {
    out += "<table>" + row({"field", "blocks", ""}, "th");
    for (const Json& f : cause["Fields"])
      out += row({shown(f["Path"]), f["Blocks"].dump(), f["IsDirect"].get<bool>() ? "" : "follows"});
    out += "</table>\n";
  }
  out += "<table>" + row({"", "block or field", "A", "B"}, "th");
  for (const Json& example : cause["Examples"]) out += block_rows(example);
  return out + "</table></details>\n";
}

std::string deviation_cells(const Json& d) {
  return row({place(d["A"]), place(d["B"]), shown(d["Event"]), shown(d["ValueA"]), shown(d["ValueB"]),
              d.contains("Size") ? fmt::format("{:.6g}", d["Size"].get<double>()) : ""});
}

std::string motion_section(const Json& kind) {
  std::string out = fmt::format("<details><summary>{} <b>{} events</b></summary>\n<table>", shown(kind["Kind"]),
                                kind["Events"].dump());
  const std::string by = kind.contains("Unit") ? "by, " + shown(kind["Unit"]) : "by";
  out += row({"A", "B", "event", "value of A", "value of B", by}, "th");
  for (const char* const which : {"First", "Greatest"})
    if (kind.contains(which)) out += deviation_cells(kind[which]);
  return out + "</table></details>\n";
}

}  // namespace

std::string as_page(const std::vector<Json>& comparisons) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>isogloss diff</title>\n<style>\n"
      "body{font:15px/1.4 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}\n"
      "summary{cursor:pointer;padding:.3em 0}table{border-collapse:collapse;margin:.5em 1em 1em}\n"
      "td,th{border:1px solid #ccc;padding:.15em .5em;text-align:left;vertical-align:top}small{color:#666}\n"
      "</style></head><body>\n<h1>isogloss diff</h1>\n";
  for (const Json& c : comparisons) {
    const Json &a = c["A"], &b = c["B"];
    const bool is_one = a["Program"] == b["Program"];
    out += fmt::format("<h2>{}</h2>\n<p>A: {}, B: {}. ",
                       is_one ? shown(a["Program"]) : shown(a["Program"]) + " and " + shown(b["Program"]),
                       shown(a["Name"]), shown(b["Name"]));
    out += c["Same"].get<bool>() ? "No difference.</p>\n" : fmt::format("{} differ.</p>\n", c["Different"].dump());
    if (c.contains("Causes"))
      for (const Json& cause : c["Causes"]) out += cause_section(cause);
    if (c.contains("Motions"))
      for (const Json& kind : c["Motions"]) out += motion_section(kind);
    if (!c.contains("All")) continue;
    const bool has_motions = c.contains("Motions");
    out += "<h3>All of them</h3>\n<table>";
    for (const Json& one : c["All"]) out += has_motions ? deviation_cells(one) : block_rows(one);
    out += "</table>\n";
  }
  return out + "</body></html>\n";
}

}  // namespace isogloss::cli::parting
