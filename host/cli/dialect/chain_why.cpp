// Where one syntax of a chain comes from, and what must stand before and after it.
#include <fmt/format.h>

#include <algorithm>

#include "dialect/chain_map.hpp"

namespace isogloss::cli {

namespace {

Json place_as_json(const Location& where) { return {{"File", where.file}, {"Line", where.line}}; }

std::string place_text(const Json& place) {
  return fmt::format("{}:{}", place["File"].get<std::string>(), place["Line"].get<std::uint32_t>());
}

std::string reason(const Relation& r, const std::string& first, const std::string& second) {
  switch (r.kind) {
    case Relation::Kind::declared:
      return r.names.size() > 1 ? "both declare it" : fmt::format("{} declares it", r.names[0]);
    case Relation::Kind::field: {
      constexpr std::size_t most = 4;
      return fmt::format("{} writes {}, which {} reads", first, listed(r.names, most), second);
    }
    case Relation::Kind::code: return fmt::format("both take {}", fmt::join(r.names, ", "));
  }
  return {};
}

/// The neighbours on one side, nearest in the chain first, each with all its reasons.
Json neighbours(const LinkedDialect& linked, const std::vector<Relation>& all, std::uint32_t position, bool following) {
  Json out = Json::array();
  for (const Relation& r : all) {
    if ((following ? r.first : r.second) != position) continue;
    const std::string &first = linked.chain[r.first].element.alias, &second = linked.chain[r.second].element.alias;
    const std::string& other = following ? second : first;
    if (out.empty() || out.back()["Syntax"] != other)
      out.push_back({{"Syntax", other}, {"Declared", false}, {"Because", Json::array()}});
    if (r.kind == Relation::Kind::declared) out.back()["Declared"] = true;
    out.back()["Because"].push_back(reason(r, first, second));
  }
  if (!following) std::reverse(out.begin(), out.end());
  return out;
}

std::string side_as_text(const Json& side, std::string_view title) {
  std::string out;
  for (const Json& n : side) {
    std::string because;
    for (const Json& b : n["Because"]) because += (because.empty() ? "" : "; ") + b.get<std::string>();
    out += fmt::format("  {}: {}\n", n["Syntax"].get<std::string>(), because);
  }
  return out.empty() ? fmt::format("{}: nothing\n", title) : fmt::format("{}:\n{}", title, out);
}

}  // namespace

Json describe_why(const LinkedDialect& linked, std::uint32_t position) {
  const ChainElement& element = linked.chain[position].element;
  const AppliedEdit* const placing = placing_edit(linked.dialect, element.alias);
  Json out{{"Dialect", linked.dialect.name},    {"As", element.alias},
           {"Syntax", element.syntax},          {"Plugin", linked.chain[position].plugin->name},
           {"Stage", to_string(element.stage)}, {"Position", position + 1},
           {"Of", linked.chain.size()},         {"Place", place_as_json(element.where)}};
  if (placing != nullptr)
    out["PlacedBy"] = {{"Edit", placing->kind}, {"Anchor", placing->anchor}, {"Dialect", placing->dialect}};
  else
    out["PlacedBy"] = {
        {"Dialect", linked.dialect.ancestors.empty() ? linked.dialect.name : linked.dialect.ancestors.back()}};
  Json options = Json::array(), edits = Json::array();
  for (const Attribute& a : element.options)
    options.push_back({{"Name", a.name}, {"Value", a.value}, {"Place", place_as_json(a.where)}});
  for (const AppliedEdit& edit : linked.dialect.edits)
    if (!edit.of_dependency && edit.anchor == element.alias && edit.kind == "Configure")
      edits.push_back({{"Edit", edit.kind}, {"Dialect", edit.dialect}, {"Place", place_as_json(edit.where)}});
  const std::vector<Relation> all = relations(linked);
  out["Options"] = std::move(options);
  out["Edits"] = std::move(edits);
  out["Takes"] = taken_codes(linked.chain[position], linked.layout);
  out["MustFollow"] = neighbours(linked, all, position, false);
  out["MustPrecede"] = neighbours(linked, all, position, true);
  return out;
}

std::string why_as_text(const Json& why) {
  const std::string alias = why["As"], id = why["Syntax"];
  std::string out = fmt::format("{} of plugin {}, stage {}, position {} of {} in {}\n",
                                alias == id ? alias : fmt::format("{} ({})", alias, id),
                                why["Plugin"].get<std::string>(), why["Stage"].get<std::string>(),
                                why["Position"].get<int>(), why["Of"].get<int>(), why["Dialect"].get<std::string>());
  const Json& by = why["PlacedBy"];
  if (by.contains("Edit"))
    out +=
        fmt::format("{}: put in by dialect {}, <{}> of {}\n", place_text(why["Place"]),
                    by["Dialect"].get<std::string>(), by["Edit"].get<std::string>(), by["Anchor"].get<std::string>());
  else
    out += fmt::format("{}: listed in the chain of dialect {}\n", place_text(why["Place"]),
                       by["Dialect"].get<std::string>());
  for (const Json& e : why["Edits"])
    out += fmt::format("{}: configured by dialect {}\n", place_text(e["Place"]), e["Dialect"].get<std::string>());
  for (const Json& o : why["Options"])
    out += fmt::format("  {}=\"{}\"  {}\n", o["Name"].get<std::string>(), o["Value"].get<std::string>(),
                       place_text(o["Place"]));
  if (!why["Takes"].empty()) {
    out += "takes:";
    for (const Json& code : why["Takes"]) out += " " + code.get<std::string>();
    out += '\n';
  }
  return out + side_as_text(why["MustFollow"], "after") + side_as_text(why["MustPrecede"], "before");
}

}  // namespace isogloss::cli
