// Plugins with one fault each, chosen by FAULT_…: of scanners, importers, tables, and of what a syntax keeps. Without a
// fault the plugin is sound.
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/time.h>
#include <unistd.h>
#include <xmmintrin.h>

#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "parts.hpp"

// Each plugin reads all of this again: of the headers that cost most, only what has the fault pays for them.
#if defined(FAULT_spins)
#include <atomic>
#elif defined(FAULT_locks)
#include <mutex>
#elif defined(FAULT_joins_thread)
#include <thread>
#endif

namespace {

using namespace parts;

[[maybe_unused]] void crash() { *reinterpret_cast<volatile int*>(8) = 1; }
[[maybe_unused]] volatile double scratch = 0;

// ---- what is shared, or kept for too long

#if defined(FAULT_counts_in_heap)
long* const counter = new long(0);
#elif defined(FAULT_counts_in_thread)
thread_local long counter = 0;
#elif defined(FAULT_spins)
std::atomic_flag spin = ATOMIC_FLAG_INIT;
#elif defined(FAULT_keeps_first_ids)
const ig_field* first_ids = nullptr;
ig_field first_x = 0;
#elif defined(FAULT_keeps_first_option)
double first_length = -1;
#elif defined(FAULT_locks)
std::mutex mutex;
#elif defined(FAULT_counts_rarely)
long far_below = 0;
#endif

struct State : Self {
  std::vector<double> all;
#if defined(FAULT_joins_thread)
  std::thread thread;
#endif
  void* memory = nullptr;
  double scanned = 0;
  double counts[100]{};
};

const ig_field_decl fields[] = {field("Parsing.X", IG_READ | IG_WRITE | IG_TAKE | IG_WAKE),
                                field("Feedrate.FeedrateValue", IG_READ | IG_WRITE),
                                field("Parsing.Y", IG_READ),
                                field("Comment.Text", IG_READ, IG_TEXT),
                                field("ToolChange.IsChange", IG_WRITE, IG_BOOLEAN),
                                field("CompoundMotion.Items[].Dwell.Time", IG_WRITE),
#if defined(FAULT_lifeless_field)
                                field("Part.Level", IG_READ | IG_WRITE),
#endif
                                field("Parsing.Z", IG_READ)};

const ig_option_decl options[] = {
    {sizeof(ig_option_decl), IG_OPTION_NUMBER, "length",
#if defined(FAULT_other_default)
     "2",
#else
     "1",
#endif
     "", 0,
#if defined(FAULT_other_range)
     20,
#else
     10,
#endif
     "mm", "A length."},
#if defined(FAULT_unnamed_option)
    {sizeof(ig_option_decl), IG_OPTION_BOOLEAN, "mirrored", "false", "", 0, 0, "", "Mirrored."},
#endif
#if defined(FAULT_option_trusts_end)
    {sizeof(ig_option_decl), IG_OPTION_TEXT, "level", "0", "", 0, 0, "", "A level."},
#endif
    {sizeof(ig_option_decl), IG_OPTION_CHOICE, "width", "narrow", "narrow|wide", 0, 0, "", "A width."}};
constexpr std::uint32_t width = sizeof options / sizeof options[0] - 1;

ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** out) {
#if defined(FAULT_refuses_old_host)
  if (api->host_minor < 8) {
    api->fail(link, text_of("it needs a host of version 1.8"));
    return IG_FAILED;
  }
#elif defined(FAULT_cannot_be_created)
  api->fail(link, text_of("the license is missing"));
  return IG_FAILED;
#elif defined(FAULT_wrong_option)
  scratch = api->option_number(link, width);
#elif defined(FAULT_undeclared_service)
  scratch = api->service(link, "isogloss.work-offset/1") != nullptr ? 1 : 0;
#elif defined(FAULT_reads_setting)
  char layers[8];
  const ig_text given = api->setting(link, "block-skip");
  if (given.size > sizeof layers) crash();
#endif
  auto* const self = new State;
  *out = self;
  self->x = ids[0], self->feed = ids[1], self->y = ids[2], self->comment = ids[3];
  self->others = ids[4];
  self->length = api->option_number(link, 0);
  self->is_wide = api->option_integer(link, width) == 1;
#if defined(FAULT_keeps_first_ids)
  if (first_ids == nullptr) first_ids = ids, first_x = ids[0];
  self->x = first_x;
#elif defined(FAULT_keeps_first_option)
  if (first_length < 0) first_length = self->length;
  self->length = first_length;
#elif defined(FAULT_option_trusts_end)
  self->length += std::atoi(api->option_text(link, 1).data);
#elif defined(FAULT_leaks_with_option)
  if (self->is_wide) scratch = std::strlen(strdup("wide"));
#elif defined(FAULT_joins_thread)
  self->thread = std::thread([] { scratch = 1; });
#elif defined(FAULT_reads_any_variable)
  if (std::getenv("FAULTY_MODE") != nullptr) self->length += 1;
#elif defined(FAULT_reads_relative)
  if (std::FILE* const file = std::fopen("faulty.conf", "r")) std::fclose(file);
#endif
  return IG_CHANGED;
}

void destroy(void* self) {
  auto* const state = static_cast<State*>(self);
#if defined(FAULT_joins_thread)
  if (state->thread.joinable()) state->thread.join();
#endif
  delete state;
}

[[maybe_unused]] ig_status restart(void* pointer, const ig_host*, ig_block*) {
  State& self = *static_cast<State*>(pointer);
  self.blocks = 0;
#if defined(FAULT_leaks_at_restart)
  self.memory = std::malloc(40);
#elif !defined(FAULT_forgets_partly)
  self.all.clear();
#endif
  return IG_UNCHANGED;
}

std::size_t scan(void* pointer, const ig_host* host, ig_block* block, const char* text, std::size_t size,
                 std::size_t position) {
  [[maybe_unused]] State& self = *static_cast<State*>(pointer);
  std::size_t end = position + 1;
#if defined(FAULT_scans_behind)
  while (text[end] >= '0' && text[end] <= '9') ++end;
#else
  while (end < size && text[end] >= '0' && text[end] <= '9') ++end;
#endif
#if defined(FAULT_scans_back)
  if (end == position + 1 && position > 0) return position - 1;
#elif defined(FAULT_scans_undeclared)
  if (end < size && text[end] == 'q') host->set(block, self.y, {.number = 1});
#elif defined(FAULT_scans_into_table)
  static const char kinds[128] = {};
  if (end < size && kinds[static_cast<signed char>(text[end]) + 0] == 1) return position;
  if (end < size && static_cast<signed char>(text[end]) == -56) crash();
#elif defined(FAULT_leaks_in_scan)
  self.memory = std::malloc(24);
#elif defined(FAULT_scan_gives_word)
  ig_word nothing{};
  nothing.field = self.x;
  nothing.begin = static_cast<std::uint16_t>(position);
  nothing.end = static_cast<std::uint16_t>(end);
  if (end == position + 1) host->set_words(block, &nothing, 1);
#elif defined(FAULT_scan_reads_rest)
  unsigned sum = 0;
  for (std::size_t i = position; i < size; ++i) sum = sum * 31 + static_cast<unsigned char>(text[i]);
  scratch = sum;
#endif
  if (end == position + 1) return position;
  double number = 0;
  std::from_chars(text + position + 1, text + end, number);
  ig_word word{};
  word.field = self.x;
  word.begin = static_cast<std::uint16_t>(position);
  word.end = static_cast<std::uint16_t>(end);
  word.value.number = number;
#if defined(FAULT_columns_beyond)
  word.end = static_cast<std::uint16_t>(size + 9);
#endif
#if defined(FAULT_scan_keeps_number)
  self.scanned = number;
#elif defined(FAULT_scan_remembers)
  word.value.number += self.scanned;
  self.scanned = number;
#endif
  host->set_words(block, &word, 1);
  return end;
}

[[maybe_unused]] void shift(State& self, ig_value& x) {
  const bool is_shifted = !self.all.empty() && self.all.back() > 500;
  self.all.push_back(x.number);
  if (is_shifted) x.number += 0.5;
}

ig_status build(void* pointer, const ig_host* host, ig_block* block) {
  [[maybe_unused]] State& self = *static_cast<State*>(pointer);
  ig_value x{}, y{};
  host->get(block, self.y, &y);
  [[maybe_unused]] const ig_text comment = host->text(block, self.comment), source = host->source(block);
  const bool is_there = host->take(block, self.x, &x) != 0;
#if defined(FAULT_reads_absent)
  host->get(block, self.y, &y);
  if (is_there) x.number += y.number;
#elif defined(FAULT_scan_keeps_number)
  if (is_there) x.number = self.scanned;
#elif defined(FAULT_counts_in_heap)
  ++*counter;
#elif defined(FAULT_counts_in_thread)
  ++counter;
#elif defined(FAULT_spins)
  while (spin.test_and_set()) {
  }
  spin.clear();
#elif defined(FAULT_locks)
  const std::lock_guard lock(mutex);
#elif defined(FAULT_yields)
  sched_yield();
#elif defined(FAULT_draws)
  unsigned char byte = 0;
  if (is_there && getrandom(&byte, 1, 0) == 1) scratch = byte;
#elif defined(FAULT_asks_time)
  if (is_there && x.number < 0) scratch = static_cast<double>(std::time(nullptr));
#elif defined(FAULT_changes_mxcsr)
  if (is_there && x.number > 990) _mm_setcsr(_mm_getcsr() | 0x8040);
#elif defined(FAULT_sets_timer)
  const itimerval often{{3600, 0}, {3600, 0}};
  if (is_there && x.number > 990) setitimer(ITIMER_VIRTUAL, &often, nullptr);
#elif defined(FAULT_changes_signal_stack)
  static char memory[65536];
  const stack_t stack{memory, 0, sizeof memory};
  if (is_there && x.number == 1) sigaltstack(&stack, nullptr);
#elif defined(FAULT_option_with_word)
  if (is_there && self.is_wide && y.number < 0) crash();
#elif defined(FAULT_option_with_text)
  if (self.is_wide && source.size > 0 && source.data[0] == '(') crash();
#elif defined(FAULT_cut_character)
  for (std::size_t i = 0; i < comment.size;)
    i += static_cast<unsigned char>(comment.data[i]) < 0x80 ? 1 : (scratch = comment.data[i + 1], 2);
#elif defined(FAULT_null_in_text)
  if (comment.size > 0 && comment.data[0] == '\0') crash();
#elif defined(FAULT_fails_over_nan)
  if (is_there && !std::isfinite(x.number)) {
    host->fault(block, text_of("X is no number"));
    return IG_FAILED;
  }
#elif defined(FAULT_fails_by_report)
  if (is_there && !std::isfinite(x.number)) {
    host->report(block, 1, self.x, 0, 0, nullptr, 0);
    return IG_FAILED;
  }
#elif defined(FAULT_stops_itself)
  if (is_there) raise(SIGSTOP);
#elif defined(FAULT_keeps_all)
  if (is_there) {
    if (self.all.empty()) self.all.reserve(900);
    self.all.push_back(x.number);
  }
#elif defined(FAULT_forgets_partly)
  if (is_there) shift(self, x);
#elif defined(FAULT_counts_beyond)
  if (is_there) self.counts[static_cast<int>(x.number) % 100] += 1;
#elif defined(FAULT_counts_rarely)
  if (is_there && x.number < -900) ++far_below;
#elif defined(FAULT_makes_names)
  if (is_there) host->symbol(block, text_of("N" + std::to_string(x.number)));
#elif defined(FAULT_wrong_boolean)
  if (is_there) host->set(block, static_cast<ig_field>(self.others), {.integer = 171});
#elif defined(FAULT_wrong_kind)
  const double offset[3] = {1, 2, 3};
  if (is_there) host->set_translation(block, self.feed, offset);
#elif defined(FAULT_wrong_record)
  const ig_field of_list = self.x;
  const ig_value value{.number = 1};
  if (is_there) host->append(block, &of_list, 1, &value);
#elif defined(FAULT_looks_ahead)
  if (is_there) host->ahead(block, 3);
#elif defined(FAULT_reports_beyond)
  if (is_there) host->report(block, 0, IG_NO_FIELD, 0, 100'000, nullptr, 0);
#endif
#if defined(FAULT_says_changed)
  if (!is_there) return IG_CHANGED;
#endif
  if (!is_there) return IG_UNCHANGED;
  ++self.blocks;
  return set_feed(self, host, block, x.number * self.length * (self.is_wide ? 2 : 1));
}

const ig_service_decl no_services[] = {{sizeof(ig_service_decl), 1, "isogloss.flow/1", "Flow."}};

// ---- the table

const ig_column_decl columns[] = {{sizeof(ig_column_decl), 0, "Length", "mm", "0", -1000, 1000, "A length."}};
const ig_option_decl table_options[] = {
    {sizeof(ig_option_decl), IG_OPTION_INTEGER, "scale", "1", "", 0, 100, "", "A scale."}};
const char* const provides[] = {"isogloss.motion/1", nullptr};

struct Table {
  ig_config_1 service{};
  double scale = 1;
};

std::int32_t number(void* self, ig_text name, double* out) {
#if defined(FAULT_table_trusts_end)
  if (std::strcmp(name.data, "Scale") == 0) crash();
#elif defined(FAULT_table_knows_all)
  *out = 1;
  return 1;
#endif
  if (std::string_view(name.data, name.size) != "ScalingUnit") return 0;
  *out = static_cast<Table*>(self)->scale;
#if defined(FAULT_table_divides)
  *out = 1 / *out;
#endif
  return 1;
}

ig_status create_table(const ig_link_api* api, ig_link* link, const ig_field*, void** out) {
  auto* const self = new Table;
  self->scale = static_cast<double>(api->option_integer(link, 0));
  self->service = {sizeof(ig_config_1), 0, self, number};
#if defined(FAULT_table_gives_no_reason)
  if (self->scale > 50) {
    delete self;
    return IG_FAILED;
  }
#endif
  *out = self;
  return IG_CHANGED;
}
void destroy_table(void* self) { delete static_cast<Table*>(self); }

const void* service(void* self, const char* id) {
  return std::string_view(id) == provides[0] ? &static_cast<Table*>(self)->service : nullptr;
}

ig_text row_fault(void*, ig_text row) {
#if defined(FAULT_table_trusts_key)
  char key[64];
  if (row.size > sizeof key) crash();
#elif defined(FAULT_table_text_on_stack)
  char why[32];
  const int size = std::snprintf(why, sizeof why, "%.8s is too long", row.size > 20 ? row.data : "");
  scratch = why[0];
  if (const char* volatile const text = why; row.size > 20) return {text, static_cast<std::size_t>(size)};
#endif
  return row.size > 100 ? text_of("the key is too long") : ig_text{nullptr, 0};
}

// ---- the importer

std::uint32_t recognise(ig_text text, ig_text) {
  const std::string_view all(text.data, text.size);
#if defined(FAULT_import_recognises_empty)
  if (all.empty()) return 10;
#elif defined(FAULT_import_trusts_end)
  return std::strstr(text.data, "PART") == text.data ? 100 : 0;
#elif defined(FAULT_import_surer)
  if (all.starts_with("PART")) return 1000;
#endif
  return all.starts_with("PART\n") ? 100 : 0;
}

ig_status read(const ig_import_api* api, ig_import* in) {
  const ig_text text = api->text(in);
  const std::string_view all(text.data, text.size);
  if (!all.starts_with("PART\n")) {
#if !defined(FAULT_import_gives_no_reason)
    api->fail(in, text_of("it does not begin with PART"));
#endif
    return IG_FAILED;
  }
#if defined(FAULT_import_rereads)
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; k += 64) scratch = scratch + all[k];
#endif
  for (std::size_t begin = 5; begin < all.size();) {
    const std::size_t end = std::min(all.find('\n', begin), all.size());
    const std::string_view line = all.substr(begin, end - begin);
    const std::size_t equals = line.find('=');
    double value = 0;
#if defined(FAULT_import_trusts_line)
    const std::string key(line.substr(0, equals));
    value = std::stod(std::string(line.substr(equals + 1)));
    const bool is_row = true;
#else
    const std::string key(line.substr(0, std::min(equals, line.size())));
    const char* const first = line.data() + std::min(equals + 1, line.size());
    const auto [stop, error] = std::from_chars(first, line.data() + line.size(), value, std::chars_format::fixed);
    const bool is_row = equals != std::string_view::npos && equals > 0 && error == std::errc() &&
                        stop == line.data() + line.size()
#if !defined(FAULT_import_ignores_bounds)
                        && std::abs(value) <= 1000
#endif
        ;
#endif
    if (is_row) {
      api->row(in, text_of("PartTable"), text_of(key), begin);
      api->number_cell(in, text_of("Length"), value,
                       begin
#if defined(FAULT_import_places_beyond)
                           + 1000
#endif
      );
    } else {
      api->unused(in, text_of("a line"), text_of("it is no row"), begin, end);
    }
    begin = end + 1;
  }
  return IG_CHANGED;
}

const char* const tables[] = {"PartTable", nullptr};

const ig_diagnostic_decl diagnostics[] = {
    {sizeof(ig_diagnostic_decl), IG_NOTE, "PART-0001", "nothing", "Nothing is wrong.", "X1"},
    {sizeof(ig_diagnostic_decl), IG_ERROR, "PART-0002", "X is no number", "X is too large.", "X1"}};

ig_syntax syntax{};
ig_dependency dependency{};
ig_importer importer{};
ig_plugin plugin{};
const ig_syntax* const syntaxes[] = {&syntax};
const ig_dependency* const dependencies[] = {&dependency};
const ig_importer* const importers[] = {&importer};

}  // namespace

extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) {
  syntax.struct_size = sizeof syntax;
  syntax.id = "PartSyntax";
  syntax.summary = "Makes X the feed.";
  syntax.page = page;
  syntax.fields = fields;
  syntax.field_count = sizeof fields / sizeof fields[0];
  syntax.options = options;
  syntax.option_count = sizeof options / sizeof options[0];
  syntax.create = create;
  syntax.destroy = destroy;
  syntax.restart = restart;
  syntax.build = build;
#if defined(SCANS)
  syntax.scan = scan;
  syntax.triggers = "X";
  syntax.scan_flags = IG_SCANS_AHEAD;
#endif
  dependency.struct_size = sizeof dependency;
  dependency.id = "PartTable";
  dependency.summary = "Parts.";
  dependency.row_element = "Part";
  dependency.row_key = "id";
  dependency.columns = columns;
  dependency.column_count = 1;
  dependency.options = table_options;
  dependency.option_count = 1;
  dependency.provides = provides;
  dependency.create = create_table;
  dependency.destroy = destroy_table;
  dependency.service = service;
  dependency.row_fault = row_fault;
  importer.struct_size = sizeof importer;
  importer.id = "PartFile";
  importer.summary = "Reads parts.";
#if !defined(FAULT_import_without_page)
  importer.page = file_page;
#endif
  importer.files = "*.TXT";
  importer.dependencies = tables;
  importer.recognise = recognise;
  importer.read = read;
  plugin.struct_size = sizeof plugin;
  plugin.abi_major = IG_ABI_MAJOR;
  plugin.abi_minor = IG_ABI_MINOR;
  plugin.name = NAME;
  plugin.version = "1.0.0";
  plugin.vendor = "tests";
  plugin.built_with = "C++";
  plugin.syntaxes = syntaxes;
  plugin.syntax_count = 1;
  plugin.dependencies = dependencies;
  plugin.dependency_count = 1;
  plugin.importers = importers;
  plugin.importer_count = 1;
  plugin.diagnostics = diagnostics;
  plugin.diagnostic_count = 2;
  return &plugin;
}
