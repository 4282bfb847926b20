#include "validate/report.hpp"

#include <fmt/format.h>

#include <set>

#include "isogloss/engine/printable.hpp"
#include "json_text.hpp"
#include "markup.hpp"

namespace isogloss::cli {

namespace {

std::string_view result_of(const Outcome& o) { return !o.findings.empty() ? "failed" : o.held() ? "held" : "skipped"; }

/// Texts of a plugin may hold any byte.
std::string shown(std::string_view text) { return printable(text, "\n\t"); }

std::string line_of(const Finding& f) { return f.where.empty() ? f.what : f.where + ": " + f.what; }

std::string indented(const std::string& text) {
  std::string out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) out += "      " + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return out;
}

}  // namespace

std::string as_text(const std::vector<PluginOutcome>& plugins, const ValidateOptions& options) {
  std::string out;
  for (const PluginOutcome& plugin : plugins) {
    out += printable(plugin.file) + "\n";
    std::size_t failed[3] = {}, held = 0, skipped = 0;
    std::set<std::string> why_skipped;
    bool has_random_failure = false;
    for (const Outcome& o : plugin.checks) {
      if (!o.skipped.empty() && o.findings.empty()) {
        ++skipped;
        why_skipped.insert(o.skipped);
        continue;
      }
      out += fmt::format("  {:<6}  {:<6}  {}: {}\n", o.held() ? "held" : "FAILED", to_string(o.check->level),
                         o.check->name, o.check->summary);
      for (const Finding& f : o.findings) out += indented(shown(line_of(f)));
      if (o.more > 0) out += fmt::format("      and {} more\n", o.more);
      for (const std::string& remark : o.remarks) out += indented(shown(remark));
      ++(o.held() ? held : failed[static_cast<int>(o.check->level)]);
      has_random_failure = has_random_failure || (!o.held() && o.check->name == "random-blocks");
    }
    if (skipped > 0) out += fmt::format("  {} checks did not run: {}\n", skipped, fmt::join(why_skipped, "; "));
    if (has_random_failure)
      out += fmt::format("  the same random blocks again: --only random-blocks --seed {} --blocks {}\n", options.seed,
                         options.blocks);
    out +=
        fmt::format("  {} checks held; failed: {} must, {} should, {} note\n", held, failed[0], failed[1], failed[2]);
  }
  return out;
}

std::string as_json(const std::vector<PluginOutcome>& plugins, const ValidateOptions& options) {
  Json out{{"Isogloss", 1}, {"Seed", options.seed}, {"Blocks", options.blocks}};
  Json& list = out["Plugins"] = Json::array();
  for (const PluginOutcome& plugin : plugins) {
    Json checks = Json::array();
    for (const Outcome& o : plugin.checks) {
      Json one{{"Name", o.check->name},
               {"Level", to_string(o.check->level)},
               {"Result", result_of(o)},
               {"Seconds", o.seconds}};
      if (!o.skipped.empty()) one["Reason"] = o.skipped;
      Json& findings = one["Findings"] = Json::array();
      for (const Finding& f : o.findings) findings.push_back({{"Where", f.where}, {"What", f.what}});
      if (o.more > 0) one["FurtherFindings"] = o.more;
      if (!o.remarks.empty()) one["Remarks"] = o.remarks;
      checks.push_back(std::move(one));
    }
    list.push_back({{"File", plugin.file}, {"Checks", std::move(checks)}});
  }
  return pretty(out);
}

std::string as_junit(const std::vector<PluginOutcome>& plugins) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const PluginOutcome& plugin : plugins) {
    std::size_t failures = 0, skipped = 0;
    double seconds = 0;
    std::string cases;
    for (const Outcome& o : plugin.checks) {
      seconds += o.seconds;
      cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", to_string(o.check->level),
                           o.check->name, o.seconds);
      std::string all;
      for (const Finding& f : o.findings) all += line_of(f) + "\n";
      if (o.more > 0) all += fmt::format("and {} more\n", o.more);
      std::string remarks;
      for (const std::string& remark : o.remarks) remarks += remark + "\n";
      if (!o.skipped.empty() && o.findings.empty()) {
        ++skipped;
        cases += fmt::format("><skipped message=\"{}\"/></testcase>\n", visible_xml(o.skipped));
      } else if (o.held() && remarks.empty()) {
        cases += "/>\n";
      } else if (o.held()) {
        cases += fmt::format("><system-out>{}</system-out></testcase>\n", visible_xml(remarks));
      } else if (o.check->level == Level::note) {
        cases += fmt::format("><system-out>{}</system-out></testcase>\n", visible_xml(all));
      } else {
        ++failures;
        cases += fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                             visible_xml(line_of(o.findings.front())), visible_xml(all));
      }
    }
    out += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
                       visible_xml(plugin.file), plugin.checks.size(), failures, skipped, seconds) +
           cases + "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

namespace {

/// A URI reference: any byte that is no plain letter of a path is given by its number.
std::string as_uri(const std::string& file) {
  std::string out = file.starts_with('/') ? "file://" : "";
  for (const char c : file) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          std::string_view("/-._~").find(c) != std::string_view::npos;
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

std::string_view sarif_level_of(Level level) {
  return level == Level::must ? "error" : level == Level::should ? "warning" : "note";
}

Json sarif_text(const std::string& text) { return {{"text", shown(text)}}; }

Json rule_of(const Check& check) {
  return {{"id", check.name},
          {"shortDescription", sarif_text(std::string(check.summary))},
          {"help", sarif_text(std::string(check.help))},
          {"defaultConfiguration", {{"level", sarif_level_of(check.level)}}},
          {"properties", {{"level", to_string(check.level)}}}};
}

/// Findings beyond the first are counted alone, and have a result of their own.
Json sarif_result(const std::string& file, const Check& check, std::size_t rule, const Finding& f) {
  Json location{{"physicalLocation", {{"artifactLocation", {{"uri", as_uri(file)}}}}}};
  if (!f.where.empty()) location["logicalLocations"] = Json::array({{{"fullyQualifiedName", shown(f.where)}}});
  return {{"ruleId", check.name},
          {"ruleIndex", rule},
          {"level", sarif_level_of(check.level)},
          {"message", sarif_text(line_of(f))},
          {"locations", Json::array({std::move(location)})}};
}

}  // namespace

std::string as_sarif(const std::vector<PluginOutcome>& plugins) {
  Json rules = Json::array(), results = Json::array();
  for (const Check& check : all_checks()) rules.push_back(rule_of(check));
  bool is_complete = true;
  for (const PluginOutcome& plugin : plugins)
    for (const Outcome& o : plugin.checks) {
      const auto rule = static_cast<std::size_t>(o.check - all_checks().data());
      is_complete = is_complete && o.skipped.empty();
      for (const Finding& f : o.findings) results.push_back(sarif_result(plugin.file, *o.check, rule, f));
      if (o.more > 0)
        results.push_back(sarif_result(plugin.file, *o.check, rule, {"", fmt::format("and {} more findings", o.more)}));
    }
  const Json driver{{"name", "isogloss validate"}, {"version", ISOGLOSS_VERSION}, {"rules", std::move(rules)}};
  return pretty({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                 {"version", "2.1.0"},
                 {"runs", Json::array({{{"tool", {{"driver", driver}}},
                                        {"invocations", Json::array({{{"executionSuccessful", is_complete}}})},
                                        {"results", std::move(results)}}})}});
}

}  // namespace isogloss::cli
