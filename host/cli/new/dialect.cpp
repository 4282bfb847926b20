// The folder of a dialect, and what it has in common with that of a plugin.
#include "new/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "markup.hpp"
#include "new/names.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// As a changelog of Debian has it, in UTC.
std::string date_of_today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  static constexpr const char* days[] = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  static constexpr const char* months[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                           "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  return fmt::format("{}, {:02} {} {} {:02}:{:02}:{:02} +0000", days[utc.tm_wday], utc.tm_mday, months[utc.tm_mon],
                     utc.tm_year + 1900, utc.tm_hour, utc.tm_min, utc.tm_sec);
}

}  // namespace

NewFolder::NewFolder(const NewOptions& options, const char* what)
    : options_(options), what_(what), session_(options.common), place_(fs::path(options.folder) / options.name) {}

bool NewFolder::begins() {
  if (!is_plugin_name(options_.name)) return refuse("IG-0150", {options_.name, what_});
  if (!is_one_line(options_.title) || !is_one_line(options_.vendor))
    return refuse("IG-0513", {"--title and --vendor are one line each"});
  std::error_code error;
  if (fs::exists(place_, error)) return refuse("IG-0151", {options_.name, "the folder " + place_.string()});
  for (const Dialect& d : session_.reader().list())
    if (d.name == options_.name) return refuse("IG-0151", {options_.name, "dialect " + d.file.string()});
  const std::string extended = options_.base.empty() ? "fanuc" : options_.base;
  if (extended.find('/') != std::string::npos)
    return refuse("IG-0513", {"--extends names a dialect, as the new file will: add its folder by --dialects DIR"});
  std::optional<Dialect> read = session_.read(extended);
  if (!read) return false;
  base_ = std::move(*read);
  words_ = {{"plugin", options_.name},
            {"base", base_.name},
            {"name", type_name_of(options_.name)},
            {"date", date_of_today()},
            {"year", date_of_today().substr(12, 4)},
            {"title", escaped_xml(options_.title.empty() ? options_.name : options_.title)}};
  return true;
}

int NewFolder::write(const std::vector<std::string>& layers) {
  const std::vector<std::string> written = write_templates(place_, layers, words_, session_);
  if (written.empty()) return cannot_start;
  const std::string where = place_.string();
  const std::string next =
      "next: cd " + where + " && cmake -S . -B build && cmake --build build && ctest --test-dir build\n";
  std::fputs(next.c_str(), stderr);
  return print_written(options_, place_, written, session_);
}

bool NewFolder::refuse(std::string_view code, std::initializer_list<std::string> arguments) {
  session_.report(code, {}, arguments);
  return false;
}

const ChainElement* NewFolder::in_chain(std::string_view syntax) const {
  const auto found = std::find_if(base_.chain.begin(), base_.chain.end(),
                                  [syntax](const ChainElement& e) { return e.syntax == syntax; });
  return found == base_.chain.end() ? nullptr : &*found;
}

std::string NewFolder::family() const {
  const std::vector<std::string>& extensions = base_.extensions;
  if (std::find(extensions.begin(), extensions.end(), ".h") != extensions.end()) return "klartext";
  return in_chain("WordSyntax") != nullptr ? "iso" : "sinumerik";
}

int new_dialect(const NewOptions& options) {
  NewFolder folder(options, "a dialect");
  if (!folder.begins()) return cannot_start;
  const std::vector<std::string>& extensions = folder.base().extensions;
  std::string tables;
  for (const DependencyElement& e : folder.base().dependencies) tables += (tables.empty() ? "" : ", ") + e.alias;
  folder.words()["program"] = "slot";
  folder.words()["extension"] = extensions.empty() ? "nc" : extensions.front().substr(1);
  folder.words()["tables"] = tables;
  return folder.write({"dialect", "dialect-" + folder.family()});
}

}  // namespace isogloss::cli
