#include <algorithm>

#include "diff/report.hpp"

namespace isogloss::cli::parting {

namespace {

Json value_or_null(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }

Json place_json(const std::string& file, std::uint32_t line, const std::string& text) {
  if (line == 0) return nullptr;
  Json out{{"File", file}, {"Line", line}};
  if (!text.empty()) out["Text"] = text;
  return out;
}

Json block_json(const PartedBlock& block) {
  Json values = Json::array();
  for (const Parting& v : block.values) {
    Json one{{"Field", v.field}, {"A", value_or_null(v.a)}, {"B", value_or_null(v.b)}};
    if (!v.unit.empty()) one["Unit"] = v.unit;
    if (!v.writer_a.empty()) one["WriterA"] = v.writer_a;
    if (!v.writer_b.empty()) one["WriterB"] = v.writer_b;
    values.push_back(std::move(one));
  }
  return {{"A", place_json(block.file_a, block.line_a, block.text_a)},
          {"B", place_json(block.file_b, block.line_b, block.text_b)},
          {"Values", std::move(values)}};
}

Json evidence_json(const Evidence& e) {
  static constexpr const char* kinds[] = {"Row", "Option"};
  return {{"Kind", kinds[static_cast<std::size_t>(e.kind)]},
          {"NameA", value_or_null(e.name_a)},
          {"NameB", value_or_null(e.name_b)},
          {"A", value_or_null(e.a)},
          {"B", value_or_null(e.b)},
          {"PlaceA", value_or_null(e.place_a)},
          {"PlaceB", value_or_null(e.place_b)},
          {"Title", value_or_null(e.title)},
          {"Trial", e.trial == Evidence::Trial::none ? Json(nullptr)
                                                     : Json(e.trial == Evidence::Trial::cause ? "Cause" : "NoCause")}};
}

Json group_json(const Group& g) {
  Json evidence = Json::array(), fields = Json::array(), examples = Json::array();
  for (const Evidence& e : g.evidence) evidence.push_back(evidence_json(e));
  for (const auto& [path, count] : g.fields)
    fields.push_back({{"Path", path}, {"Blocks", count.blocks}, {"IsDirect", count.is_direct}});
  for (const PartedBlock& block : g.examples) examples.push_back(block_json(block));
  const bool is_tried = g.trial != Evidence::Trial::none ||
                        std::any_of(g.evidence.begin(), g.evidence.end(),
                                    [](const Evidence& e) { return e.trial != Evidence::Trial::none; });
  return {{"Cause", heading(g)},
          {"Kind", to_string(g.kind)},
          {"IsTried", is_tried},
          {"Blocks", g.blocks},
          {"DirectBlocks", g.direct_blocks},
          {"Codes", g.codes},
          {"SyntaxA", value_or_null(g.syntax_a)},
          {"SyntaxB", value_or_null(g.syntax_b)},
          {"Evidence", std::move(evidence)},
          {"Fields", std::move(fields)},
          {"Examples", std::move(examples)}};
}

Json deviation_json(const Deviation& d) {
  Json out{{"A", place_json(d.file_a, d.line_a, "")}, {"B", place_json(d.file_b, d.line_b, "")}, {"Event", d.event}};
  out["ValueA"] = value_or_null(d.a);
  out["ValueB"] = value_or_null(d.b);
  if (d.size > 0) out["Size"] = d.size;
  return out;
}

}  // namespace

Json as_json(const Report& r) {
  Json causes = Json::array();
  for (const Group& g : r.groups) causes.push_back(group_json(g));
  Json out{{"A", {{"Name", r.name_a}, {"Program", r.program_a}, {"Blocks", r.blocks_a}}},
           {"B", {{"Name", r.name_b}, {"Program", r.program_b}, {"Blocks", r.blocks_b}}},
           {"Same", r.parted == 0},
           {"Different", r.parted},
           {"Causes", std::move(causes)}};
  if (r.all.empty()) return out;
  Json all = Json::array();
  for (std::size_t i = 0; i < r.all.size(); ++i) {
    Json block = block_json(r.all[i]);
    block["Cause"] = r.all_groups[i];
    all.push_back(std::move(block));
  }
  out["All"] = std::move(all);
  return out;
}

Json as_json(const MotionReport& r) {
  Json kinds = Json::array();
  for (const auto& [name, kind] : r.kinds) {
    Json one{{"Kind", name}, {"Events", kind.motions}, {"First", deviation_json(kind.first)}};
    if (!kind.unit.empty()) one["Unit"] = kind.unit;
    if (kind.greatest.size > 0) one["Greatest"] = deviation_json(kind.greatest);
    kinds.push_back(std::move(one));
  }
  Json out{{"A", {{"Name", r.name_a}, {"Program", r.program_a}, {"Events", r.motions_a}}},
           {"B", {{"Name", r.name_b}, {"Program", r.program_b}, {"Events", r.motions_b}}},
           {"Tolerance", {{"mm", r.tolerance.mm}, {"deg", r.tolerance.degrees}}},
           {"Same", r.parted == 0},
           {"Different", r.parted},
           {"Motions", std::move(kinds)}};
  if (r.all.empty()) return out;
  Json all = Json::array();
  for (const auto& [name, d] : r.all) {
    Json one = deviation_json(d);
    one["Kind"] = name;
    all.push_back(std::move(one));
  }
  out["All"] = std::move(all);
  return out;
}

}  // namespace isogloss::cli::parting
