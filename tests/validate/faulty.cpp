// Plugins with one fault each, chosen by FAULT_…, which one check of `isogloss validate` is to find.
#include <fcntl.h>
#include <isogloss.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cfenv>
#include <charconv>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

// Each plugin reads all of this again: of the headers that cost most, only what has the fault pays for them.
#if defined(FAULT_allocates)
#include <string>
#elif defined(FAULT_leaves_thread)
#include <thread>
#endif

namespace {

[[maybe_unused]] void wait(long milliseconds) {
  const timespec time{milliseconds / 1000, milliseconds % 1000 * 1'000'000};
  nanosleep(&time, nullptr);
}

#if defined(FAULT_option_bounds)
constexpr bool checks_length = true;
#else
constexpr bool checks_length = false;
#endif

struct Self {
  ig_field x, feed, comment, plane;
  long blocks = 0;
  double length = 0;
  ig_field other = IG_NO_FIELD;
  ig_text kept_text{};
  void* memory = nullptr;
  void (*set_text_value)() = nullptr;
  ig_block* kept_block = nullptr;
  const ig_host* kept_functions = nullptr;
  const ig_field* kept_ids = nullptr;
  const ig_link_api* kept_api = nullptr;
  ig_link* kept_link = nullptr;
};

const ig_field_decl fields[] = {
#if defined(FAULT_asleep)
    {sizeof(ig_field_decl), IG_READ | IG_TAKE, IG_NUMBER, IG_LIFE_STANDARD, "Parsing.X", "", "An X.", nullptr},
#else
    {sizeof(ig_field_decl), IG_READ | IG_TAKE | IG_WAKE, IG_NUMBER, IG_LIFE_STANDARD, "Parsing.X", "", "An X.",
     nullptr},
#endif
#if defined(FAULT_undeclared)
    {sizeof(ig_field_decl), IG_READ, IG_NUMBER, IG_LIFE_STANDARD, "Feedrate.FeedrateValue", "", "The feed.", nullptr},
#else
    {sizeof(ig_field_decl), IG_READ | IG_WRITE, IG_NUMBER, IG_LIFE_STANDARD, "Feedrate.FeedrateValue", "", "The feed.",
     nullptr},
#endif
    {sizeof(ig_field_decl), IG_READ, IG_TEXT, IG_LIFE_STANDARD, "Comment.Text", "", "A comment.", nullptr},
    {sizeof(ig_field_decl), IG_READ, IG_NUMBER, IG_LIFE_STANDARD, "Parsing.Y", "", "A Y.", nullptr},
#if defined(FAULT_never_read)
    {sizeof(ig_field_decl), IG_READ, IG_NUMBER, IG_LIFE_STANDARD, "ProgramXyz.Y", "", "A point.", nullptr},
#endif
#if defined(FAULT_rare_option)
    {sizeof(ig_field_decl), IG_READ, IG_NUMBER, IG_LIFE_STANDARD, "ProgramXyz.Z", "", "A point.", nullptr},
#endif
#if defined(FAULT_never_written)
    {sizeof(ig_field_decl), IG_WRITE, IG_NUMBER, IG_LIFE_STANDARD, "ProgramXyz.X", "", "A point.", nullptr},
#endif
};

const ig_option_decl options[] = {
    {sizeof(ig_option_decl), IG_OPTION_NUMBER, "length", "1", "", 0, 10, "mm", "A length."}};

#if defined(FAULT_service)
const ig_service_decl services[] = {{sizeof(ig_service_decl), 1, "isogloss.work-offset/1", "Offsets."}};
#endif

[[maybe_unused]] void crash() { *reinterpret_cast<volatile int*>(8) = 1; }

ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** out) {
  auto* const self = new Self{ids[0], ids[1], ids[2], ids[3]};
  *out = self;
  self->length = api->option_number(link, 0);
  self->kept_ids = ids;
  self->kept_api = api;
  self->kept_link = link;
#if defined(FAULT_ends_badly)
  std::atexit([] { crash(); });
#elif defined(FAULT_writes_at_create)
  if (std::FILE* const file = std::fopen("/dev/null", "w")) std::fclose(file);
#elif defined(FAULT_no_reason)
  if (self->length >= 10) {
    delete self;
    return IG_FAILED;
  }
#elif defined(FAULT_sets_variable)
  setenv("FAULTY", "1", 1);
#elif defined(FAULT_blocks_signal)
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGUSR2);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
#endif
#if defined(FAULT_rare_option)
  self->other = ids[4];
#elif defined(FAULT_leaks_at_destroy)
  self->memory = std::malloc(100);
#elif defined(FAULT_leaves_file)
  open("/dev/null", O_RDONLY);
#elif defined(FAULT_leaves_thread)
  std::thread([] {
    for (;;) wait(1000);
  }).detach();
#elif defined(FAULT_leaves_child)
  if (fork() == 0) {
    sleep(1000);
    _exit(0);
  }
#endif
  if (checks_length && api->option_number(link, 0) >= 10) {
    delete self;
    const char reason[] = "too long";
    api->fail(link, {reason, sizeof reason - 1});
    return IG_FAILED;
  }
#if defined(FAULT_service)
  if (api->service(link, "isogloss.work-offset/1") == nullptr) crash();
#elif defined(FAULT_newer_call)
  if (api->set_text_value == nullptr) crash();
#elif defined(FAULT_exact_size)
  if (api->struct_size != sizeof(ig_link_api)) crash();
#endif
  return IG_CHANGED;
}

[[maybe_unused]] ig_status restart(void* self, const ig_host*, ig_block*) {
  static_cast<Self*>(self)->blocks = 0;
  return IG_UNCHANGED;
}

void destroy(void* self) { delete static_cast<Self*>(self); }

[[maybe_unused]] long blocks_of_all = 0;
[[maybe_unused]] volatile double scratch = 0;

void set(const ig_host* host, ig_block* block, ig_field field, double number) {
  ig_value value;
  value.number = number;
  host->set(block, field, value);
}

/// Takes X and makes it the feed.
ig_status build(void* pointer, const ig_host* host, ig_block* block) {
  [[maybe_unused]] Self& self = *static_cast<Self*>(pointer);
  ig_value x{};
  const bool is_there = host->take(block, self.x, &x) != 0;
  ++self.blocks;
  [[maybe_unused]] ig_value any{};
  host->get(block, self.feed, &any);
  host->get(block, self.plane, &any);
  [[maybe_unused]] const ig_text comment = host->text(block, self.comment);
#if defined(FAULT_empty)
  if (!is_there) crash();
#elif defined(FAULT_absent)
  ig_value feed;
  if (is_there && host->get(block, self.plane, &feed) == 0 && x.number == 1) crash();
#elif defined(FAULT_huge_text)
  char copy[1000];
  const ig_text text = host->text(block, self.comment);
  std::memcpy(copy, text.data, text.size);
  if (text.size > 0) x.number += copy[0];
#elif defined(FAULT_nan)
  int table[4] = {};
  if (is_there && std::isnan(x.number)) crash();
  scratch = table[0];
#elif defined(FAULT_hang)
  for (volatile bool forever = !is_there; forever;) {
  }
#elif defined(FAULT_memory)
  if (!is_there)
    for (;;) *static_cast<volatile char*>(std::malloc(1 << 20)) = 1;
#elif defined(FAULT_leaves_process)
  static bool has_left = false;
  if (!has_left && fork() == 0) {
    sleep(1000);
    _exit(0);
  }
  has_left = true;
  if (!is_there) crash();
#elif defined(FAULT_leaves_group)
  setpgid(0, getpgid(getppid()));
  std::signal(SIGALRM, SIG_IGN);  // no watch ends it
  while (!is_there) pause();
#elif defined(FAULT_prints)
  if (!is_there) {
    for (int i = 0; i < 20'000'000; ++i) std::fputc('x', stdout);
    std::fflush(stdout);
    crash();
  }
#elif defined(FAULT_random)
  ig_value y;
  if (is_there && x.number > 2 && host->get(block, self.plane, &y) != 0 && y.number < -2) crash();
#elif defined(FAULT_reads_behind_text)
  if (comment.size > 0) scratch = std::strlen(comment.data);
#elif defined(FAULT_keeps_text)
  if (self.kept_text.size > 0) scratch = self.kept_text.data[0];
  self.kept_text = comment;
#elif defined(FAULT_reads_behind_source)
  const ig_text source = host->source(block);
  if (source.data != nullptr) scratch = source.data[source.size];
#elif defined(FAULT_rare_option)
  if (is_there && self.length > 6 && self.length < 9) set(host, block, self.other, 1);
#elif defined(FAULT_unknown_diagnostic)
  if (is_there && x.number < 0) host->report(block, 7, self.x, 0, 0, nullptr, 0);
#elif defined(FAULT_leaks)
  if (is_there) self.memory = std::memset(std::malloc(1 << 20), 1, 1 << 20);
#elif defined(FAULT_leaks_little)
  if (is_there) scratch = reinterpret_cast<long>(std::malloc(24));
#elif defined(FAULT_allocates)
  if (is_there) scratch = std::string(100, static_cast<char>('a' + self.blocks % 2)).size();
#elif defined(FAULT_waits_rarely)
  if (is_there && x.number > 100) wait(1);
#elif defined(FAULT_keeps_error)
  if (is_there && x.number > 300) self.blocks = 1000;  // restart() does not know of it
#elif defined(FAULT_changes_locale)
  if (is_there) std::setlocale(LC_NUMERIC, "C.UTF-8");
#elif defined(FAULT_changes_rounding)
  if (is_there) std::fesetround(FE_TOWARDZERO);
#elif defined(FAULT_changes_signal)
  if (is_there) std::signal(SIGUSR1, SIG_IGN);
#elif defined(FAULT_ended_by_signal)
  if (!is_there) {
    std::signal(SIGUSR1, SIG_DFL);
    std::raise(SIGUSR1);
  }
#elif defined(FAULT_keeps_block)
  if (self.kept_block != nullptr) host->get(self.kept_block, self.plane, &any);
  self.kept_block = block;
#elif defined(FAULT_keeps_functions)
  if (self.kept_functions == nullptr) self.kept_functions = host;
  self.kept_functions->get(block, self.plane, &any);
#elif defined(FAULT_keeps_ids)
  host->get(block, self.kept_ids[3], &any);
#elif defined(FAULT_keeps_option)
  if (is_there) scratch = self.kept_api->option_number(self.kept_link, 0);
#elif defined(FAULT_reads_comma)
  if (is_there) x.number += std::strtod("0.5", nullptr) - 0.5;
#elif defined(FAULT_writes_comma)
  char digits[64];
  const int size = std::snprintf(digits, sizeof digits, "%.3f", x.number);
  if (is_there) std::from_chars(digits, digits + size, x.number);
  if (is_there && std::memchr(digits, ',', size) != nullptr) x.number += 0.125;
#elif defined(FAULT_reads_clock)
  if (is_there) x.number += static_cast<double>(std::time(nullptr) / 10'000'000);
#elif defined(FAULT_uses_address)
  if (is_there) x.number += static_cast<double>(reinterpret_cast<std::uintptr_t>(&blocks_of_all) >> 12 & 0xff);
#elif defined(FAULT_uses_old_memory)
  auto* const memory = static_cast<volatile unsigned char*>(std::malloc(64));
  if (is_there) x.number += memory[40];
  std::free(const_cast<unsigned char*>(memory));
#elif defined(FAULT_reads_variable)
  if (is_there) x.number += std::getenv("HOME") != nullptr && std::getenv("HOME")[1] == 'n' ? 1 : 0;
#elif defined(FAULT_prints_to_error)
  if (is_there && x.number < 0) std::fprintf(stderr, "X is %g\n", x.number);
#elif defined(FAULT_reads_file)
  if (std::FILE* const file = is_there ? std::fopen("/dev/null", "r") : nullptr) std::fclose(file);
#elif defined(FAULT_slow_rarely)
  for (volatile int i = 0; is_there && x.number > 100 && i < 200'000;) i = i + 1;
#elif defined(FAULT_counts_quietly)
  ++blocks_of_all;
#elif defined(FAULT_lacks_argument)
  if (is_there && x.number < -10) host->report(block, 0, self.x, 0, 0, nullptr, 0);
#elif defined(FAULT_not_finite)
  if (is_there) x.number = x.number * 25.4 / 25.4;
#elif defined(FAULT_many_at_once)
  ig_field many[40];
  ig_value values[40];
  for (ig_field& one : many) one = self.plane;
  host->get_many(block, many, 40, values);
#elif defined(FAULT_leaks_pages)
  if (is_there) mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
#elif defined(FAULT_random_lie)
  if (is_there && x.number > 2) {
    set(host, block, self.feed, x.number);
    return IG_UNCHANGED;
  }
#endif
  if (!is_there) return IG_UNCHANGED;
#if defined(FAULT_global_count)
  x.number += ++blocks_of_all;
#elif defined(FAULT_keeps) || defined(FAULT_forgets)
  x.number += self.blocks;
#elif defined(FAULT_keeps_error)
  if (self.blocks >= 1000) x.number = 0;
#elif defined(FAULT_shared_scratch)
  scratch = x.number;
  wait(1);
  x.number = scratch;
#elif defined(FAULT_other_chain)
  if (blocks_of_all != 0 && blocks_of_all != reinterpret_cast<long>(&self)) x.number = -1;
  blocks_of_all = reinterpret_cast<long>(&self);
#elif defined(FAULT_slow)
  for (volatile int i = 0; i < 100'000;) i = i + 1;
#endif
  set(host, block, self.feed, x.number);
#if defined(FAULT_lies)
  return IG_UNCHANGED;
#elif defined(FAULT_status)
  return 77;
#else
  return IG_CHANGED;
#endif
}

#if defined(FAULT_bad_case)
#define AFTER "2"
#else
#define AFTER "1"
#endif
const char page[] =
    "# FaultySyntax\n\nMakes X the feed.\n\n"
    "| option | type | default | range | meaning |\n|---|---|---|---|---|\n"
    "| `length` | number | 1 | 0 to 10 | a length in mm |\n\n## X becomes the feed\n\n#BeforeBuild:\n```json\n"
    R"({"Parsing": {"X": 1, "Y": 2}})"
    "\n```\n#AfterBuild:\n```json\n"
    R"({"Parsing": {"Y": 2}, "Feedrate": {"FeedrateValue": )" AFTER
    "}}\n```\n\n"
    "## Another X\n\n#BeforeBuild:\n```json\n"
    R"({"Parsing": {"X": -2}})"
    "\n```\n#AfterBuild:\n```json\n"
    R"({"Feedrate": {"FeedrateValue": -2}})"
    "\n```\n";

const ig_diagnostic_decl diagnostics[] = {{sizeof(ig_diagnostic_decl), IG_NOTE,
#if defined(FAULT_prefix)
                                           "ISO-9901",
#elif defined(FAULT_code)
                                           "no code",
#else
                                           "FLT-0001",
#endif
#if defined(FAULT_lacks_argument)
                                           "the number {0} is negative",
#else
                                           "nothing",
#endif
                                           "Nothing is wrong.", "X1"}};

ig_syntax syntax{};
const ig_syntax* const syntaxes[] = {&syntax};
ig_plugin plugin{};

#if defined(FAULT_slow_load)
struct AtLoad {
  AtLoad() { wait(80); }
} at_load;
#elif defined(FAULT_crash_at_close)
struct AtClose {
  ~AtClose() { crash(); }
} at_close;
#elif defined(FAULT_prints_at_load)
struct AtLoad {
  AtLoad() { std::puts("faulty 1.0 is ready"); }
} at_load;
#endif

}  // namespace

#if defined(FAULT_exports)
extern "C" IG_EXPORT int of_everyone() { return 1; }
#elif defined(FAULT_many_exports)
#define ONE(n) \
  extern "C" IG_EXPORT int of_everyone_##n() { return 1; }
#define FIVE(n) ONE(n##0) ONE(n##1) ONE(n##2) ONE(n##3) ONE(n##4)
FIVE(1)
FIVE(2)
FIVE(3)
FIVE(4)
FIVE(5)
#endif

extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) {
  syntax.struct_size = sizeof syntax;
  syntax.id = "FaultySyntax";
#if !defined(FAULT_no_summary)
  syntax.summary = "Makes X the feed.";
#else
  syntax.summary = "";
#endif
  syntax.page = page;
  syntax.fields = fields;
  syntax.field_count = sizeof fields / sizeof fields[0];
  syntax.options = options;
  syntax.option_count = 1;
#if defined(FAULT_service)
  syntax.services = services;
  syntax.service_count = 1;
#endif
  syntax.create = create;
  syntax.destroy = destroy;
  syntax.build = build;
#if defined(FAULT_forgets) || defined(FAULT_asleep)
  syntax.restart = restart;
#elif defined(FAULT_keeps_error)
  syntax.restart = [](void* self, const ig_host*, ig_block*) -> ig_status {
    long& blocks = static_cast<Self*>(self)->blocks;
    if (blocks < 1000) blocks = 0;
    return IG_UNCHANGED;
  };
#endif
  plugin.struct_size = sizeof plugin;
  plugin.abi_major = IG_ABI_MAJOR;
  plugin.abi_minor = IG_ABI_MINOR;
  plugin.syntax_count = 1;
  plugin.name = NAME;
  plugin.version = "1.0.0";
  plugin.vendor = "tests";
  plugin.built_with = "C++";
  plugin.syntaxes = syntaxes;
  plugin.diagnostics = diagnostics;
  plugin.diagnostic_count = 1;
#if defined(FAULT_other_answer)
  static ig_plugin second = plugin;
  static bool is_second = false;
  is_second = !is_second;
  if (is_second) return &second;
#elif defined(FAULT_crash_at_load)
  crash();
#endif
  return &plugin;
}
