#include "import/import_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "contract/argument_text.hpp"
#include "contract/c_text.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss {

namespace {

constexpr std::size_t most_cells = 4'000'000;
constexpr std::size_t most_unused = 10'000;

std::string string_of(ig_text t) { return std::string(to_view(t)); }

const OptionValue& option_of(const std::vector<OptionValue>& options, std::uint32_t i) {
  static const OptionValue none;
  return i < options.size() ? options[i] : none;
}

// ---- places

/// Where each line begins. Lines end in LF, CR LF or CR.
std::vector<std::size_t> line_begins(std::string_view text) {
  std::vector<std::size_t> out{0};
  for (std::size_t i = 0; (i = text.find_first_of("\r\n", i)) != std::string_view::npos;) {
    i += text.substr(i).starts_with("\r\n") ? 2 : 1;
    out.push_back(i);
  }
  return out;
}

/// Line and column, from 1, of a byte of the text. An importer may sort its rows, so places come in any order.
Location place_of(ig_import& in, std::size_t position) {
  position = std::min(position, in.text.size());
  if (in.line_begins.empty()) in.line_begins = line_begins(in.text);
  const auto next = std::upper_bound(in.line_begins.begin(), in.line_begins.end(), position);
  return {in.asked.file.string(), static_cast<std::uint32_t>(next - in.line_begins.begin()),
          static_cast<std::uint32_t>(position - *(next - 1)) + 1};
}

void violate(ig_import& in, std::string what) {
  if (in.is_sound)
    in.sink.add(host_diagnostic("IG-0127", in.asked.where, {in.asked.file.string(), in.importer.id, what}));
  in.is_sound = false;
}

// ---- the file

ig_text text(const ig_import* in) { return to_text(in->text); }
ig_text file_name(const ig_import* in) { return to_text(in->name); }
double option_number(const ig_import* in, std::uint32_t i) { return option_of(in->options, i).number; }
std::int64_t option_integer(const ig_import* in, std::uint32_t i) { return option_of(in->options, i).integer; }
ig_text option_text(const ig_import* in, std::uint32_t i) { return to_text(option_of(in->options, i).text); }

// ---- rows

/// The table of a dependency, which any plugin may have; null, and reported, where none has it.
DependencyElement* table_of(ig_import& in, const std::string& id, std::size_t place) {
  const auto [known, is_new] = in.tables.emplace(id, in.out.tables.size());
  if (!is_new) return &in.out.tables[known->second];
  const ig_dependency* dependency = in.library.dependency(id);
  if (dependency == nullptr) {
    in.library.load_all();
    dependency = in.library.dependency(id);
  }
  if (dependency == nullptr) {
    in.tables.erase(known);
    violate(in, fmt::format("it gives rows for {}, which no plugin has", id));
    return nullptr;
  }
  in.out.tables.push_back({id, id, {}, {}, {}, place_of(in, place)});
  in.rows.emplace_back();
  return &in.out.tables.back();
}

void row(ig_import* in, ig_text dependency, ig_text key, std::size_t place) {
  in->row = nullptr;
  DependencyElement* const table = table_of(*in, string_of(dependency), place);
  if (table == nullptr) return;
  const ig_dependency& declared = *in->library.dependency(table->id);
  if (declared.row_element == nullptr) return violate(*in, table->id + " has no rows");
  const std::string name = string_of(key);
  auto& rows = in->rows[in->tables[table->id]];
  const auto [known, is_new] = rows.emplace(name, table->rows.size());
  if (is_new) {
    const Location where = place_of(*in, place);
    table->rows.push_back({declared.row_element, {{declared.row_key, name, where}}, where});
  }
  in->row = &table->rows[known->second];
}

void put_cell(ig_import& in, ig_text column, std::string value, std::size_t place) {
  if (in.row == nullptr) return;  // why there is no row was reported
  if (++in.cells > most_cells) return violate(in, fmt::format("it gives more than {} values", most_cells));
  const std::string name = string_of(column);
  const auto old = std::find_if(in.row->attributes.begin(), in.row->attributes.end(),
                                [&](const Attribute& a) { return a.name == name; });
  Attribute cell{name, std::move(value), place_of(in, place)};
  if (old == in.row->attributes.end()) {
    in.row->attributes.push_back(std::move(cell));
    return;
  }
  if (old->value != cell.value) in.replaced.push_back({in.row->attributes.front().value, *old, cell});
  *old = std::move(cell);
}

void text_cell(ig_import* in, ig_text column, ig_text value, std::size_t place) {
  put_cell(*in, column, printable(string_of(value)), place);
}

void number_cell(ig_import* in, ig_text column, double value, std::size_t place) {
  if (!std::isfinite(value))
    return violate(*in, fmt::format("it gives {} a value that is not finite", string_of(column)));
  std::array<char, 400> digits;  // room for the largest double without an exponent
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
  put_cell(*in, column, std::string(digits.data(), end), place);
}

void option(ig_import* in, ig_text dependency, ig_text name, ig_text value, std::size_t place) {
  DependencyElement* const table = table_of(*in, string_of(dependency), place);
  if (table == nullptr) return;
  const std::string option_name = string_of(name);
  std::erase_if(table->options, [&](const Attribute& a) { return a.name == option_name; });
  table->options.push_back({option_name, printable(string_of(value)), place_of(*in, place)});
}

// ---- rows of the machine

ig_text value_of(const DependencyElement* table, std::uint32_t row, std::string_view name) {
  if (table == nullptr || row >= table->rows.size()) return {nullptr, 0};
  for (const Attribute& a : table->rows[row].attributes)
    if (a.name == name) return to_text(a.value);
  return {nullptr, 0};
}

ig_text key_of(const DependencyElement* table, std::uint32_t row, const Library& library) {
  const ig_dependency* const declared = table == nullptr ? nullptr : library.dependency(table->id);
  if (declared == nullptr || declared->row_key == nullptr) return {nullptr, 0};
  return value_of(table, row, declared->row_key);
}

/// The first one: the tables of the machine's own file stand before those of its dialect.
const DependencyElement* machine_table(const ig_import* in, ig_text id) {
  for (const DependencyElement* const table : in->asked.machine_tables)
    if (table->id == to_view(id)) return table;
  return nullptr;
}

std::uint32_t machine_row_count(const ig_import* in, ig_text dependency) {
  const DependencyElement* const table = machine_table(in, dependency);
  return table == nullptr ? 0 : static_cast<std::uint32_t>(table->rows.size());
}
ig_text machine_row_key(const ig_import* in, ig_text dependency, std::uint32_t row) {
  return key_of(machine_table(in, dependency), row, in->library);
}
ig_text machine_cell(const ig_import* in, ig_text dependency, std::uint32_t row, ig_text column) {
  return value_of(machine_table(in, dependency), row, to_view(column));
}

// ---- what has no effect

void count_unused(std::vector<UnusedPart>& all, std::map<std::pair<std::string, std::string>, std::size_t>& known,
                  ig_text what, ig_text why, const Location& where) {
  std::pair<std::string, std::string> texts{printable(string_of(what)), printable(string_of(why))};
  if (all.size() >= most_unused) texts = {"the rest", "it holds too many different parts that are not read"};
  const auto [found, is_new] = known.emplace(texts, all.size());
  if (is_new) all.push_back({texts.first, texts.second, where, 0});
  ++all[found->second].count;
}

void unused(ig_import* in, ig_text what, ig_text why, std::size_t begin, std::size_t) {
  count_unused(in->out.unused, in->unused, what, why, place_of(*in, begin));
}

void report(ig_import* in, std::uint32_t diagnostic, std::size_t begin, std::size_t, const ig_argument* arguments,
            std::uint32_t count) {
  if (diagnostic >= in->plugin.diagnostic_count)
    return violate(*in, "it reports a diagnostic that is not in its plugin's table");
  const ig_diagnostic_decl& row = in->plugin.diagnostics[diagnostic];
  const auto severity = static_cast<Severity>(row.severity);
  if (severity == Severity::error) in->is_sound = false;
  const Location where = place_of(*in, begin);
  in->reported_lines.insert(where.line);
  in->sink.add({severity, row.code, fill_in(row.text, argument_texts(arguments, count)), where, 0, {}});
}

void fail(ig_import* in, ig_text reason) { in->failure = string_of(reason); }

// ---- writing

double export_number(const ig_export* out, std::uint32_t i) { return option_of(out->options, i).number; }
std::int64_t export_integer(const ig_export* out, std::uint32_t i) { return option_of(out->options, i).integer; }
ig_text export_text(const ig_export* out, std::uint32_t i) { return to_text(option_of(out->options, i).text); }

const DependencyElement* written_table(const ig_export* out, ig_text id) {
  const std::string name = string_of(id);
  const auto found =
      std::find_if(out->tables.begin(), out->tables.end(), [&](const DependencyElement& e) { return e.id == name; });
  return found == out->tables.end() ? nullptr : &*found;
}

std::uint32_t row_count(const ig_export* out, ig_text dependency) {
  const DependencyElement* const table = written_table(out, dependency);
  return table == nullptr ? 0 : static_cast<std::uint32_t>(table->rows.size());
}

ig_text row_key(const ig_export* out, ig_text dependency, std::uint32_t row) {
  out->asked.try_emplace(string_of(dependency));
  return key_of(written_table(out, dependency), row, out->library);
}

ig_text cell(const ig_export* out, ig_text dependency, std::uint32_t row, ig_text column) {
  out->asked[string_of(dependency)].insert(string_of(column));
  return value_of(written_table(out, dependency), row, string_of(column));
}

void write(ig_export* out, ig_text bytes) { out->out.append(bytes.data, bytes.size); }

void export_unused(ig_export* out, ig_text what, ig_text why) {
  count_unused(out->unused, out->known_unused, what, why, {});
}

void export_fail(ig_export* out, ig_text reason) { out->failure = string_of(reason); }

}  // namespace

const ig_import_api& import_api() {
  static constexpr ig_import_api api{sizeof(ig_import_api),
                                     IG_ABI_MINOR,
                                     text,
                                     file_name,
                                     option_number,
                                     option_integer,
                                     option_text,
                                     row,
                                     text_cell,
                                     number_cell,
                                     option,
                                     unused,
                                     report,
                                     fail,
                                     machine_row_count,
                                     machine_row_key,
                                     machine_cell};
  return api;
}

const ig_export_api& export_api() {
  static constexpr ig_export_api api{
      sizeof(ig_export_api), IG_ABI_MINOR, export_number, export_integer, export_text, row_count, row_key, cell, write,
      export_unused,         export_fail};
  return api;
}

void report_replaced(const ig_import& in) {
  const ReplacedCell* first = nullptr;
  std::size_t count = 0;
  for (const ReplacedCell& cell : in.replaced)
    if (!in.reported_lines.contains(cell.later.where.line) && count++ == 0) first = &cell;
  if (first == nullptr) return;
  in.sink.add(host_diagnostic("IG-0143", first->earlier.where,
                              {first->key, first->earlier.name, first->earlier.value,
                               std::to_string(first->later.where.line), first->later.value, std::to_string(count)}));
}

void name_unasked(ig_export& out, const char* const* dependencies) {
  constexpr const char* why = "the format does not hold it";
  for (; dependencies != nullptr && *dependencies != nullptr; ++dependencies) {
    const DependencyElement* const table = written_table(&out, to_text(*dependencies));
    const ig_dependency* const declared = table == nullptr ? nullptr : out.library.dependency(table->id);
    if (declared == nullptr || declared->row_key == nullptr || table->rows.empty()) continue;
    const auto asked = out.asked.find(table->id);
    if (asked == out.asked.end()) {
      out.unused.push_back({"rows of " + table->id, why, {}, table->rows.size()});
      continue;
    }
    if (asked->second.empty()) continue;  // by their keys the importer has named the rows
    std::map<std::string, std::uint64_t> counts;
    for (const TableRow& row : table->rows)
      for (const Attribute& a : row.attributes)
        if (a.name != declared->row_key && !asked->second.contains(a.name)) ++counts[a.name];
    for (const auto& [column, count] : counts)
      out.unused.push_back({"column " + column + " of " + table->id, why, {}, count});
  }
}

}  // namespace isogloss
