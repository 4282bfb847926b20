#include "contract/descriptor_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "contract/descriptor_parts.hpp"
#include "dialect/options.hpp"
#include "isogloss_import.h"
#include "isogloss_scan.h"

namespace isogloss {
namespace {

using namespace checks;

// The elements of a dialect file: no syntax and no dependency can be named so.
constexpr std::array reserved_names{
    "Dialect",  "Files",      "Signature",    "Segmenter",   "Plugins",    "Plugin",    "Dependencies", "Initial",
    "Field",    "Chain",      "Parsing",      "Evaluation",  "Severities", "Severity",  "Logic",        "PostLogic",
    "Replace",  "Inspection", "InsertBefore", "InsertAfter", "Remove",     "Configure", "Machine",      "Include",
    "Programs", "Backup",     "Folder",       "SearchOrder", "ProgramPath"};
// The attributes that the dialect reader keeps for itself.
constexpr std::array reserved_attributes{"as", "override", "src", "format", "syntax", "dependency"};

std::vector<std::string_view> split(std::string_view s, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = s.find(separator, begin);
    parts.push_back(s.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

template <class What>
void range(double minimum, double maximum, const What& what) {
  if (std::isnan(minimum) || std::isnan(maximum) || minimum > maximum)
    fault("{} has the range {} to {}", what(), minimum, maximum);
}

template <class What>
void number_in_range(std::string_view s, double minimum, double maximum, const What& what) {
  const std::optional<double> value = parse_number(s);
  if (!value) fault("the default of {}, '{}', is not a number", what(), s);
  if (*value < minimum || *value > maximum)
    fault("the default of {}, {}, lies outside {} to {}", what(), s, minimum, maximum);
}

template <class What>
void option_default(const ig_option_decl& option, const What& what) {
  const std::string_view s = text(option.fallback, of("the default of", what));
  if (!parse_option(option, s)) fault("the default of {} is '{}', not {}", what(), s, describe_option(option));
}

void check_options(const ig_option_decl* options, std::uint32_t count, std::string_view owner) {
  array(options, count, most_declarations, member(owner, "options"));
  Seen names;
  for (std::uint32_t i = 0; i < count; ++i) {
    const ig_option_decl& option = options[i];
    const std::string_view id = name(option.name, [&] { return fmt::format("the name of {}'s option {}", owner, i); });
    const auto what = [&] { return fmt::format("option '{}' of {}", id, owner); };
    if (contains(reserved_attributes, id)) fault("{} has a name that the dialect file keeps for itself", what());
    unique(names, id, [&] { return fmt::format("{}'s option", owner); });
    if (option.type < IG_OPTION_TEXT || option.type > IG_OPTION_FIELDS)
      fault("{} has the type {}", what(), option.type);
    text(option.unit, of("the unit of", what), longest_name);
    text(option.doc, of("the doc of", what));
    if (option.type == IG_OPTION_CHOICE) {
      Seen choices;
      for (const std::string_view choice : split(text(option.choices, of("the choices of", what)), '|')) {
        if (choice.empty()) fault("{} has an empty choice", what());
        unique(choices, choice, [&] { return fmt::format("a choice of {},", what()); });
      }
    }
    if (option.type == IG_OPTION_NUMBER || option.type == IG_OPTION_INTEGER)
      range(option.minimum, option.maximum, what);
    if (option.fallback != nullptr) option_default(option, what);
  }
}

/// What the parts of a path are made of.
constexpr std::array<bool, 256> path_characters = [] {
  std::array<bool, 256> all{};
  for (std::size_t c = 0; c < all.size(); ++c)
    all[c] = is_letter(static_cast<char>(c)) || is_digit(static_cast<char>(c));
  for (const char c : {'_', '-', '~', '#'}) all[static_cast<unsigned char>(c)] = true;
  return all;
}();

/// Is it a path without a list? Sixteen bytes at a time, since a plugin declares thousands: each byte belongs to a part
/// or is a point, and no point stands beside another or at an end.
bool is_plain_path(std::string_view path) {
  using Bytes [[gnu::vector_size(16)]] = unsigned char;
  using Halves [[gnu::vector_size(16)]] = std::uint64_t;
  const auto is_any = [](Bytes b) {
    const auto halves = reinterpret_cast<Halves>(b);
    return (halves[0] | halves[1]) != 0;
  };
  Bytes odd{}, points{};
  const auto look_at = [&](const char* first) {  // and at the byte before them
    Bytes x, before;
    std::memcpy(&x, first, sizeof x);
    std::memcpy(&before, first - 1, sizeof before);
    const Bytes folded = x | 0x20;
    const auto point = reinterpret_cast<Bytes>(x == '.');
    const auto known = reinterpret_cast<Bytes>(((folded >= 'a') & (folded <= 'z')) | ((x >= '0') & (x <= '9')) |
                                               (x == '_') | (x == '-') | (x == '~') | (x == '#'));
    odd |= ~(known | point) | (point & reinterpret_cast<Bytes>(before == '.'));
    points |= point;
  };
  if (path.empty() || path.back() == '.') return false;
  // The first bytes stand behind a point, which refuses another one.
  std::array<char, sizeof(Bytes) + 1> begin;
  begin.fill('_');
  begin[0] = '.';
  std::memcpy(begin.data() + 1, path.data(), std::min(path.size(), sizeof(Bytes)));
  look_at(begin.data() + 1);
  for (std::size_t i = sizeof(Bytes); i + sizeof(Bytes) <= path.size(); i += sizeof(Bytes)) look_at(path.data() + i);
  if (path.size() > sizeof(Bytes)) look_at(path.data() + path.size() - sizeof(Bytes));
  return is_any(points) && !is_any(odd);
}

/// "Section.Field", "Parsing.CODE.1.X", "Section.List[].Section.Field".
bool is_path(std::string_view path) {
  if (is_plain_path(path)) return true;
  std::size_t parts = 0, lists = 0;
  for (bool is_last = false; !is_last; ++parts) {
    const std::size_t dot = path.find('.');
    is_last = dot == std::string_view::npos;
    std::string_view part = path.substr(0, dot);
    if (parts > 0 && !is_last && part.ends_with("[]")) {
      part.remove_suffix(2);
      ++lists;
    }
    bool is_whole = !part.empty();
    for (const char c : part) is_whole &= path_characters[static_cast<unsigned char>(c)];
    if (!is_whole) return false;
    if (!is_last) path.remove_prefix(dot + 1);
  }
  return parts > 1 && lists <= 1;
}

template <class What>
void check_pattern(const ig_syntax& syntax, std::string_view path, const What& what) {
  for (std::uint32_t i = 0; i < syntax.option_count; ++i) {
    if (syntax.options[i].type == IG_OPTION_FIELDS && path.substr(1) == syntax.options[i].name) return;
  }
  fault("{} is a pattern, and the syntax has no option of field patterns of that name", what());
}

template <class What>
void check_access(const ig_field_decl& field, const What& what) {
  constexpr std::uint32_t uses = IG_READ | IG_WRITE | IG_TAKE | IG_PREVIOUS | IG_WAKE | IG_WAKE_WHILE;
  constexpr std::uint32_t known = uses | IG_REQUIRED | IG_PATTERN | IG_ENDS_AHEAD;
  if ((field.access & ~known) != 0)
    fault("{} has the access bits 0x{:X}, which this host does not know", what(), field.access & ~known);
  if ((field.access & uses) == 0) fault("{} is neither read, written nor taken", what());
  if ((field.access & (IG_REQUIRED | IG_READ)) == IG_REQUIRED)
    fault("{} is required and not read: IG_REQUIRED goes with IG_READ", what());
}

template <class What>
void check_wake_value(const ig_field_decl& field, const What& what) {
  if (text(field.wake_value, of("the wake_value of", what), longest_name).empty())
    fault("{} has an empty wake_value; null stands for any value", what());
  if (field.type != IG_SYMBOL) fault("{} has a wake_value, which only a field of names can have", what());
  if ((field.access & IG_WAKE_WHILE) == 0) fault("{} has a wake_value and not the access IG_WAKE_WHILE", what());
}

template <class What>
void check_ends_ahead(const ig_syntax& syntax, std::string_view path, const What& what) {
  if (syntax.look_ahead == 0) fault("{} has the access IG_ENDS_AHEAD, and the syntax looks no block ahead", what());
  if (path.find("[]") != std::string_view::npos)
    fault("{} has the access IG_ENDS_AHEAD, which a field of records cannot have", what());
}

void check_fields(const ig_syntax& syntax, std::string_view owner) {
  array(syntax.fields, syntax.field_count, most_declarations, member(owner, "fields"));
  for (std::uint32_t i = 0; i < syntax.field_count; ++i) {
    const ig_field_decl& field = syntax.fields[i];
    const auto where = [&] { return fmt::format("the path of {}'s field {}", owner, i); };
    const std::string_view path = bytes(field.path, where, longest_name);
    const auto what = [&] { return fmt::format("field '{}' of {}", path, owner); };
    if ((field.access & IG_PATTERN) != 0) {
      refuse_unprintable(path, where);
      if (path.starts_with('@'))
        check_pattern(syntax, path, what);
      else if (path.find_first_of("*?") == std::string_view::npos)
        fault("{} is a pattern, so its path is '@' and an option's name, or has a wildcard", what());
    } else if (!is_path(path)) {
      refuse_unprintable(path, where);
      fault("{} has no path such as Section.Field", what());
    }
    check_access(field, what);
    if (field.type < IG_NUMBER || field.type > IG_SWITCH) fault("{} has the type {}", what(), field.type);
    if (field.life > IG_LIFE_FRAME) fault("{} has the life {}", what(), field.life);
    text(field.unit, of("the unit of", what), longest_name);
    text(field.doc, of("the doc of", what));
    if (field.wake_value != nullptr) check_wake_value(field, what);
    if ((field.access & IG_ENDS_AHEAD) != 0) check_ends_ahead(syntax, path, what);
  }
}

void check_syntax(const ig_syntax& syntax, std::string_view owner) {
  text(syntax.summary, member(owner, "summary"));
  if (syntax.folder != nullptr) text(syntax.folder, member(owner, "folder"), longest_name);
  // The page is not read here: all pages together are most of a plugin's bytes, and a run shows none.
  if (syntax.look_ahead > most_look_ahead)
    fault("{} looks {} blocks ahead, more than {}", owner, syntax.look_ahead, most_look_ahead);
  check_options(syntax.options, syntax.option_count, owner);
  check_fields(syntax, owner);
  array(syntax.services, syntax.service_count, most_declarations, member(owner, "services"));
  for (std::uint32_t i = 0; i < syntax.service_count; ++i) {
    if (text(syntax.services[i].id, member(owner, "services.id"), longest_name).empty())
      fault("{} needs a service without a name", owner);
    text(syntax.services[i].doc, member(owner, "services.doc"));
  }
  name_list(syntax.after, member(owner, "after"));
  name_list(syntax.before, member(owner, "before"));
  if (syntax.exclusive_slot != nullptr) text(syntax.exclusive_slot, member(owner, "exclusive_slot"), longest_name);
  if (syntax.first_writer_slot != nullptr)
    text(syntax.first_writer_slot, member(owner, "first_writer_slot"), longest_name);
  if (syntax.create == nullptr) fault("{}.create is null", owner);
  if (syntax.destroy == nullptr) fault("{}.destroy is null", owner);
  if (syntax.build == nullptr && syntax.scan == nullptr && syntax.restart == nullptr)
    fault("{} has neither build, scan nor restart", owner);
  if (syntax.inspects != 0 && syntax.build == nullptr) fault("{} inspects and has no build", owner);
  if ((syntax.scan == nullptr) != (syntax.triggers == nullptr))
    fault("{} has {}", owner, syntax.scan == nullptr ? "triggers and no scan" : "a scan and no triggers");
  if (syntax.triggers != nullptr) bytes(syntax.triggers, member(owner, "triggers"), 256);
  if (syntax.scan_flags != 0 && syntax.scan == nullptr) fault("{} has scan_flags and no scan", owner);
}

/// "key|column=value|…"
void check_row(const ig_dependency& dependency, std::uint32_t index, std::string_view owner) {
  const auto what = [&] { return fmt::format("row {} of {}", index, owner); };
  const auto parts = split(text(dependency.default_rows[index], what), '|');
  if (parts[0].empty()) fault("{} has no key", what());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    if (equals == std::string_view::npos) fault("{}: '{}' is not column=value", what(), parts[i]);
    const std::string_view id = parts[i].substr(0, equals);
    const ig_column_decl* column = std::find_if(dependency.columns, dependency.columns + dependency.column_count,
                                                [&](const ig_column_decl& c) { return id == c.name; });
    if (column == dependency.columns + dependency.column_count) fault("{} names the unknown column '{}'", what(), id);
    if (column->is_text == 0)
      number_in_range(parts[i].substr(equals + 1), column->minimum, column->maximum,
                      [&] { return fmt::format("{} of {}", id, what()); });
  }
}

void check_dependency(const ig_dependency& dependency, std::string_view owner) {
  text(dependency.summary, member(owner, "summary"));
  if ((dependency.row_element == nullptr) != (dependency.row_key == nullptr))
    fault("{} names only one of row_element and row_key", owner);
  check_options(dependency.options, dependency.option_count, owner);
  array(dependency.columns, dependency.column_count, most_declarations, member(owner, "columns"));
  Seen columns;
  if (dependency.row_element != nullptr) {
    name(dependency.row_element, member(owner, "row_element"));
    columns.insert(name(dependency.row_key, member(owner, "row_key")));
  }
  for (std::uint32_t i = 0; i < dependency.column_count; ++i) {
    const ig_column_decl& column = dependency.columns[i];
    const std::string_view id = name(column.name, [&] { return fmt::format("the name of {}'s column {}", owner, i); });
    const auto what = [&] { return fmt::format("column '{}' of {}", id, owner); };
    unique(columns, id, [&] { return fmt::format("{}'s column", owner); });
    text(column.unit, of("the unit of", what), longest_name);
    text(column.doc, of("the doc of", what));
    if (column.is_text == 0) range(column.minimum, column.maximum, what);
    if (column.is_text == 0 && column.fallback != nullptr)
      number_in_range(text(column.fallback, of("the default of", what)), column.minimum, column.maximum, what);
  }
  if (dependency.row_element == nullptr && dependency.column_count + dependency.default_row_count > 0)
    fault("{} has columns or rows, and no row_element", owner);
  if (dependency.default_row_count > most_declarations)
    fault("{} counts {} rows, more than {}", owner, dependency.default_row_count, most_declarations);
  if (dependency.default_row_count > 0 && dependency.default_rows == nullptr)
    fault("{}.default_rows counts {} and is null", owner, dependency.default_row_count);
  for (std::uint32_t i = 0; i < dependency.default_row_count; ++i) check_row(dependency, i, owner);
  name_list(dependency.provides, member(owner, "provides"));
  if (dependency.create == nullptr) fault("{}.create is null", owner);
  if (dependency.destroy == nullptr) fault("{}.destroy is null", owner);
  if (dependency.provides != nullptr && dependency.provides[0] != nullptr && dependency.service == nullptr)
    fault("{} provides services, and its service function is null", owner);
}

void check_importer(const ig_importer& importer, std::string_view owner) {
  text(importer.summary, member(owner, "summary"));
  text(importer.files, member(owner, "files"));
  if (importer.folder != nullptr) text(importer.folder, member(owner, "folder"), longest_name);
  check_options(importer.options, importer.option_count, owner);
  name_list(importer.dependencies, member(owner, "dependencies"));
  if (importer.dependencies == nullptr || importer.dependencies[0] == nullptr)
    fault("{} names no dependency that it gives rows for", owner);
  if (importer.recognise == nullptr) fault("{}.recognise is null", owner);
  if (importer.read == nullptr) fault("{}.read is null", owner);
}

/// A prefix in capitals, a hyphen, a number.
bool is_code(std::string_view code) {
  const std::size_t hyphen = code.rfind('-');
  if (hyphen == std::string_view::npos || hyphen == 0 || hyphen + 1 == code.size()) return false;
  const std::string_view prefix = code.substr(0, hyphen), number = code.substr(hyphen + 1);
  return std::all_of(prefix.begin(), prefix.end(), [](char c) { return (c >= 'A' && c <= 'Z') || is_digit(c); }) &&
         std::all_of(number.begin(), number.end(), is_digit);
}

/// A place for an argument is '{', one digit and '}'.
template <class What>
void check_places(std::string_view text, const What& what) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == '{' && is_digit(text[i + 1]) && (i + 2 == text.size() || text[i + 2] != '}'))
      fault("{} holds '{}', which is no place for an argument such as {{0}}", what(), text.substr(i, 3));
}

void check_diagnostics(const ig_plugin& plugin) {
  array(plugin.diagnostics, plugin.diagnostic_count, most_declarations, [] { return "diagnostics"; });
  Seen codes;
  for (std::uint32_t i = 0; i < plugin.diagnostic_count; ++i) {
    const ig_diagnostic_decl& row = plugin.diagnostics[i];
    const std::string_view code = text(
        row.code, [&] { return fmt::format("the code of diagnostic {}", i); }, longest_name);
    const auto what = [&] { return fmt::format("diagnostic {}", code); };
    if (!is_code(code)) fault("diagnostic code '{}' is not a prefix and number such as ACME-0101", code);
    if (code.starts_with("IG-")) fault("diagnostic code '{}' has the host's own prefix", code);
    const std::string_view shown = text(row.text, of("the text of", what));
    if (shown.empty()) fault("diagnostic {} has no text", code);
    check_places(shown, of("the text of", what));
    if (!codes.insert(code)) {
      const ig_diagnostic_decl* first = plugin.diagnostics;
      while (code != first->code) ++first;
      fault("diagnostic code '{}' is declared twice{}", code, shown == first->text ? "" : ", with two texts");
    }
    if (row.severity < IG_NOTE || row.severity > IG_ERROR)
      fault("diagnostic {} has the severity {}", code, row.severity);
    text(row.explanation, of("the explanation of", what));
    text(row.example, of("the example of", what));
  }
}

/// Syntaxes and dependencies are reached by pointers of their own, so a newer, longer one is welcome.
template <class T>
std::string_view part(const T* const* parts, std::uint32_t i, const char* what) {
  if (parts[i] == nullptr) fault("{}[{}] is null", what, i);
  if (parts[i]->struct_size < sizeof(T))
    fault("{}[{}] has struct_size {}, at least {} is needed", what, i, parts[i]->struct_size, sizeof(T));
  const std::string_view id = name(parts[i]->id, [&] { return fmt::format("{}[{}].id", what, i); });
  if (contains(reserved_names, id)) fault("{}[{}].id '{}' is an element of the dialect file itself", what, i, id);
  return id;
}

/// Flags of a newer plugin may have a meaning, which this host does not know.
void check_scan_flags(const ig_plugin& plugin, const ig_syntax& syntax, std::string_view owner) {
  if (const std::uint32_t unknown = syntax.scan_flags & ~std::uint32_t{IG_SCANS_AHEAD};
      unknown != 0 && plugin.abi_minor <= IG_ABI_MINOR)
    fault("{} has the scan_flags 0x{:x}, which have no meaning", owner, unknown);
}

/// A newer plugin may have given the member a name and a meaning, which this host does not look at.
void check_reserved(const ig_plugin& plugin, std::uint32_t value, std::string_view owner) {
  if (value != 0 && plugin.abi_minor <= IG_ABI_MINOR) fault("{}.reserved is {}, not 0", owner, value);
}

void check_plugin(const ig_plugin& plugin) {
  if (plugin.struct_size < sizeof(ig_plugin))
    fault("ig_plugin has struct_size {}, at least {} is needed", plugin.struct_size, sizeof(ig_plugin));
  const std::string_view id = name(plugin.name, [] { return "the plugin's name"; });
  for (const auto& [s, what] : {std::pair{plugin.version, "version"}, std::pair{plugin.vendor, "vendor"},
                                std::pair{plugin.built_with, "built_with"}})
    text(
        s, [part = what, id] { return fmt::format("the {} of plugin '{}'", part, id); }, longest_name);
  if (plugin.syntax_count > most_parts) fault("syntaxes counts {}, more than {}", plugin.syntax_count, most_parts);
  if (plugin.dependency_count > most_parts)
    fault("dependencies counts {}, more than {}", plugin.dependency_count, most_parts);
  if (plugin.importer_count > most_parts) fault("importers counts {}, more than {}", plugin.importer_count, most_parts);
  if (plugin.importer_count > 0 && plugin.importers == nullptr) fault("importers is null");
  if (plugin.syntax_count > 0 && plugin.syntaxes == nullptr) fault("syntaxes is null");
  if (plugin.dependency_count > 0 && plugin.dependencies == nullptr) fault("dependencies is null");
  check_reserved(plugin, plugin.reserved, "ig_plugin");
  Seen ids;
  for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) {
    const std::string_view syntax = part(plugin.syntaxes, i, "syntaxes");
    unique(ids, syntax, [] { return "the id"; });
    check_syntax(*plugin.syntaxes[i], syntax);
    check_scan_flags(plugin, *plugin.syntaxes[i], syntax);
    check_reserved(plugin, plugin.syntaxes[i]->reserved, syntax);
  }
  for (std::uint32_t i = 0; i < plugin.dependency_count; ++i) {
    const std::string_view dependency = part(plugin.dependencies, i, "dependencies");
    unique(ids, dependency, [] { return "the id"; });
    check_dependency(*plugin.dependencies[i], dependency);
  }
  for (std::uint32_t i = 0; i < plugin.importer_count; ++i) {
    const std::string_view importer = part(plugin.importers, i, "importers");
    unique(ids, importer, [] { return "the id"; });
    check_importer(*plugin.importers[i], importer);
    check_reserved(plugin, plugin.importers[i]->reserved, importer);
  }
  check_diagnostics(plugin);
}

}  // namespace

std::optional<std::string> descriptor_fault(const ig_plugin& plugin) {
  try {
    check_plugin(plugin);
    return std::nullopt;
  } catch (const Fault& found) {
    return found.reason;
  }
}

}  // namespace isogloss
