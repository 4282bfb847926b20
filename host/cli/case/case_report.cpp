#include "case/case_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "json_text.hpp"
#include "markup.hpp"

namespace isogloss::cli {

namespace {

std::size_t failures_of(const CasePage& page) {
  return static_cast<std::size_t>(std::count_if(page.cases.begin(), page.cases.end(),
                                                [](const CaseOutcome& one) { return !one.difference.empty(); }));
}

}  // namespace

std::string cases_as_text(const std::vector<CasePage>& pages) {
  std::string out;
  std::size_t cases = 0, failed = 0;
  for (const CasePage& page : pages) {
    cases += page.cases.size();
    failed += failures_of(page);
    for (const CaseOutcome& one : page.cases)
      if (!one.difference.empty())
        out += fmt::format("{}:{}: {}\n{}\n", page.file, one.line, one.heading, one.difference);
  }
  return out + fmt::format("{} cases of {} pages: {} hold, {} fail\n", cases, pages.size(), cases - failed, failed);
}

std::string cases_as_json(const std::vector<CasePage>& pages) {
  Json list = Json::array();
  std::size_t cases = 0, failed = 0;
  for (const CasePage& page : pages) {
    cases += page.cases.size();
    failed += failures_of(page);
    Json all = Json::array();
    for (const CaseOutcome& one : page.cases) {
      Json c{{"Heading", one.heading}, {"Line", one.line}, {"Holds", one.difference.empty()}};
      if (!one.difference.empty()) c["Difference"] = one.difference;
      all.push_back(std::move(c));
    }
    list.push_back(
        {{"File", page.file}, {"Syntax", page.syntax}, {"Cases", std::move(all)}, {"Diagnostics", page.faults}});
  }
  return pretty(Json{{"Isogloss", 1}, {"Held", cases - failed}, {"Failed", failed}, {"Pages", std::move(list)}});
}

std::string cases_as_junit(const std::vector<CasePage>& pages) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const CasePage& page : pages) {
    double seconds = 0;
    std::size_t errors = 0;
    std::string cases;
    for (const CaseOutcome& one : page.cases) {
      seconds += one.seconds;
      cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", visible_xml(page.syntax),
                           visible_xml(one.heading), one.seconds);
      cases += one.difference.empty()
                   ? "/>\n"
                   : fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                                 visible_xml(fmt::format("{}:{}: the case does not hold", page.file, one.line)),
                                 visible_xml(one.difference));
    }
    for (const Json& fault : page.faults) {
      if (fault["Severity"] != "error") continue;
      ++errors;
      cases +=
          fmt::format("    <testcase classname=\"{}\" name=\"{}\"><error message=\"{}\"/></testcase>\n",
                      visible_xml(page.syntax), "the page can be read",
                      visible_xml(fault["Message"].get<std::string>() + " [" + fault["Code"].get<std::string>() + "]"));
    }
    out += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
                       visible_xml(page.file), page.cases.size() + errors, failures_of(page), errors, seconds) +
           cases + "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace isogloss::cli
