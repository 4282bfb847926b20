// Lists plugins, syntaxes, dialects, dependencies, fields, diagnostics, the codes of a dialect.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "json_text.hpp"
#include "known_codes.hpp"
#include "output_file.hpp"
#include "sandbox/untrusted.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

/// Rows of which `columns` are shown as text.
struct Listing {
  std::string title;
  std::vector<const char*> columns;
  Json rows = Json::array();
};

Listing plugins(Session& session) {
  Listing out{"plugins", {"Name", "Version", "Vendor", "File"}, Json::array()};
  for (const LoadedPlugin& p : session.library().plugins()) out.rows.push_back(describe(p));
  return out;
}

Listing syntaxes(Session& session) {
  Listing out{"syntaxes", {"Id", "Plugin", "Summary"}, Json::array()};
  for (const LoadedPlugin& p : session.library().plugins())
    for (std::uint32_t i = 0; i < p.plugin->syntax_count; ++i)
      out.rows.push_back(describe(*p.plugin->syntaxes[i], *p.plugin));
  return out;
}

Listing dependencies(Session& session) {
  Listing out{"dependencies", {"Id", "Plugin", "Summary"}, Json::array()};
  for (const LoadedPlugin& p : session.library().plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i)
      out.rows.push_back(describe(*p.plugin->dependencies[i], *p.plugin));
  return out;
}

Listing dialects(Session& session) {
  Listing out{"dialects", {"Name", "Title", "File"}, Json::array()};
  for (const Dialect& d : session.reader().list()) {
    std::vector<std::string> patterns;
    for (const Signature& s : d.signatures) patterns.push_back(s.pattern);
    out.rows.push_back({{"Name", d.name},
                        {"Title", d.title},
                        {"Extensions", d.extensions},
                        {"Signatures", patterns},
                        {"File", d.file.string()}});
  }
  return out;
}

Listing importers(Session& session) {
  Listing out{"importers", {"Id", "Plugin", "Files", "Summary"}, Json::array()};
  for (const LoadedPlugin& p : session.library().plugins())
    for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i)
      out.rows.push_back(describe(*p.plugin->importers[i], *p.plugin));
  return out;
}

Listing machines(Session& session) {
  Listing out{"machines", {"Name", "Dialect", "Title", "File"}, Json::array()};
  for (const FoundMachine& m : session.machines())
    out.rows.push_back({{"Name", m.name},
                        {"Dialect", m.is_tables ? "(tables)" : m.dialect},
                        {"Title", m.title},
                        {"File", m.file.string()}});
  return out;
}

Listing fields(Session& session) {
  return {"fields", {"Path", "Type", "Life", "Unit", "Doc"}, describe_fields(session.library())};
}

Listing diagnostics(Session& session) {
  Listing out{"diagnostics", {"Code", "Severity", "Text"}, Json::array()};
  for (const KnownCode& known : known_codes(session.library())) out.rows.push_back(describe(known));
  return out;
}

Listing codes(const LinkedDialect& linked) {
  return {"codes", {"Code", "Kind", "Syntax", "Page"}, describe_codes(linked)};
}

using Lister = Listing (*)(Session&);
constexpr std::pair<std::string_view, Lister> listers[] = {
    {"plugins", plugins},   {"dialects", dialects},         {"machines", machines}, {"importers", importers},
    {"syntaxes", syntaxes}, {"dependencies", dependencies}, {"fields", fields},     {"diagnostics", diagnostics}};

std::string cell(const Json& row, const char* column) {
  const auto found = row.find(column);
  if (found == row.end()) return "";
  return found->is_string() ? found->get<std::string>() : found->dump();
}

/// The first cell, and the others below it.
std::string narrow_row(const Json& row, const Listing& listing, std::size_t columns) {
  constexpr std::size_t below = 6;
  std::string others;
  for (std::size_t i = 1; i < listing.columns.size(); ++i) others += cell(row, listing.columns[i]) + " ";
  return cell(row, listing.columns.front()) + "\n" + std::string(below, ' ') +
         in_columns(others, columns - below, below);
}

std::string table(const Listing& listing) {
  std::vector<std::size_t> widths(listing.columns.size());
  for (const Json& row : listing.rows)
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], characters(cell(row, listing.columns[i])));
  // Only the last column is broken into lines. Where it has no room beside the others, the first one stands alone.
  constexpr std::size_t narrowest = 24;
  const std::size_t columns = columns_of(STDOUT_FILENO);
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < widths.size(); ++i) begin += widths[i] + 2;
  const bool is_narrow = columns != 0 && begin + narrowest > columns;
  std::string out;
  for (const Json& row : listing.rows) {
    std::string line;
    for (std::size_t i = 0; i + 1 < widths.size(); ++i)
      line += fmt::format("{:<{}}  ", cell(row, listing.columns[i]), widths[i]);
    const std::string last = cell(row, listing.columns.back());
    if (columns == 0 || begin + characters(last) <= columns)
      line += last;
    else
      line = is_narrow ? narrow_row(row, listing, columns) : line + in_columns(last, columns - begin, begin);
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  }
  return out;
}

struct ListCommand {
  CommonOptions common;
  std::string what, dialect, machine;
  bool json = false;

  int run() const {
    Session session(common);
    if ((what == "codes") != (!dialect.empty() || !machine.empty())) {
      session.report("IG-0513", {},
                     {"list codes needs a dialect: -d NAME, or a machine: -m NAME; the other lists accept none"});
      return cannot_start;
    }
    if (what == "codes") {
      const std::optional<std::string> named = session.dialect_or_machine(dialect, machine);
      const auto linked = named ? session.link(*named) : nullptr;
      if (linked == nullptr) return cannot_start;
      const Listing listing = codes(*linked);
      return print(json ? pretty(listing.rows) : table(listing), session.status());
    }
    session.library().load_all();
    std::string out;
    Json all = Json::object();
    for (const auto& [name, list] : listers) {
      // Without a name: only the short lists.
      if (what.empty() ? name != "plugins" && name != "dialects" : name != what) continue;
      const Listing listing = list(session);
      if (json)
        all[listing.title] = listing.rows;
      else
        out += (what.empty() ? (out.empty() ? "" : "\n") + listing.title + "\n" : "") + table(listing);
    }
    if (json) out = pretty(what.empty() ? all : all[what]);
    return print(out, session.status());
  }
};

}  // namespace

int list_command(const Arguments& arguments) {
  CommandLine line("list", "Lists plugins, dialects and what they contain. Without WHAT: plugins and dialects.",
                   "isogloss list syntaxes\n  isogloss list codes -d fanuc\n  isogloss list diagnostics --json");
  ListCommand command;
  std::vector<std::string> names;
  for (const auto& [name, lister] : listers) names.emplace_back(name);
  names.emplace_back("codes");
  line.option("WHAT", command.what, "plugins, syntaxes, dialects, machines, dependencies, fields, diagnostics or codes")
      .one_of(names);
  line.option("-d,--dialect", command.dialect, "Dialect of the codes, each listed with its syntaxes and their pages")
      .type_name("DIALECT");
  line.option("-m,--machine", command.machine, "Machine of the codes").type_name("MACHINE");
  line.flag("--json", command.json, "Write JSON");
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.dialect, command.machine);
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
