// The same blocks under another locale, environment, folder and clock, and at other places of the memory.
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/time.h>

#include <clocale>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <locale>
#include <random>

#include "validate/child.hpp"
#include "validate/redirection.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// A number with a decimal point, as C and C++ write it at present.
bool writes_a_comma() { return fmt::format("{:.1L}", 0.5) == "0,5" && std::to_string(0.5).starts_with("0,5"); }

/// What the C library reads of a locale's LC_NUMERIC: a comma for the point. Made here, since a minimal system has no
/// locale with a comma.
std::string comma_locale() {
  constexpr std::uint32_t magic = 0x20031115u ^ LC_NUMERIC;
  const std::string texts[] = {std::string(",\0", 2),     std::string("\0", 1),       std::string("\x7f\0", 2),
                               std::string(",\0\0\0", 4), std::string("\0\0\0\0", 4), std::string("UTF-8\0", 6)};
  std::string head, body;
  const auto number = [&head](std::uint32_t n) { head.append(reinterpret_cast<const char*>(&n), sizeof n); };
  constexpr std::uint32_t count = std::size(texts), begin = (2 + count) * sizeof(std::uint32_t);
  number(magic);
  number(count);
  for (const std::string& text : texts) {
    body.resize((body.size() + 3) / 4 * 4);
    number(begin + static_cast<std::uint32_t>(body.size()));
    body += text;
  }
  return head + body;
}

class CommaInStreams : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

bool use_comma() {
  // For streams of C++, and then for functions of C, whose locale the first call must not change.
  std::locale::global(std::locale(std::locale::classic(), new CommaInStreams));
  for (const char* installed : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"})
    if (std::setlocale(LC_NUMERIC, installed) != nullptr && writes_a_comma()) return true;
  std::string folder = (fs::temp_directory_path() / "isogloss-locale-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return false;
  const fs::path made = fs::path(folder) / "isogloss";
  fs::create_directories(made);
  std::ofstream(made / "LC_NUMERIC", std::ios::binary) << comma_locale();
  setenv("LOCPATH", folder.c_str(), 1);
  std::setlocale(LC_NUMERIC, "isogloss");
  unsetenv("LOCPATH");
  std::error_code error;
  fs::remove_all(folder, error);
  return writes_a_comma();
}

void use_point() {
  std::setlocale(LC_NUMERIC, "C");
  std::locale::global(std::locale::classic());
}

constexpr const char* changed_variables[] = {"HOME", "USER", "LANG", "LC_ALL", "TMPDIR", "PATH", "PWD"};

/// Each variable that the plugin asks for is set, whatever its name is.
bool sets_all_variables = false;
char* other_getenv(const char* name) {
  static char value[] = "/nowhere";
  return sets_all_variables ? value : std::getenv(name);
}
const Replacement other_variables[] = {{"getenv", reinterpret_cast<void*>(&other_getenv)},
                                       {"secure_getenv", reinterpret_cast<void*>(&other_getenv)}};

bool use_other_folder() {
  std::error_code error;
  fs::current_path("/", error);
  for (const char* name : changed_variables) setenv(name, "/nowhere", 1);
  setenv("TZ", "XYZ-11:30", 1);
  tzset();
  sets_all_variables = true;
  return !error;
}

// Clocks of the system, whose time is another one.
std::int64_t seconds_ahead = 0;
std::time_t other_time(std::time_t* out) {
  const std::time_t now = std::time(nullptr) + seconds_ahead;
  if (out != nullptr) *out = now;
  return now;
}
int other_clock_gettime(clockid_t clock, timespec* out) {
  const int error = clock_gettime(clock, out);
  if (error == 0) out->tv_sec += seconds_ahead, out->tv_nsec = (out->tv_nsec + seconds_ahead) % 1'000'000'000;
  return error;
}
int other_gettimeofday(timeval* out, void* zone) {
  const int error = gettimeofday(out, zone);
  if (error == 0) out->tv_sec += seconds_ahead;
  return error;
}
const Replacement other_clocks[] = {{"time", reinterpret_cast<void*>(&other_time)},
                                    {"clock_gettime", reinterpret_cast<void*>(&other_clock_gettime)},
                                    {"gettimeofday", reinterpret_cast<void*>(&other_gettimeofday)}};

bool use_other_time() {
  constexpr std::int64_t odd_seconds_of_ten_years = 315'532'813;
  seconds_ahead = odd_seconds_of_ten_years;
  return true;
}

/// mallopt(M_PERTURB) leaves out the memory that a thread keeps for itself, which is all that is small.
bool fills_memory = false;
void* other_malloc(std::size_t size) {
  constexpr int filler = 0x5a;
  void* const out = std::malloc(size);
  return out == nullptr || !fills_memory ? out : std::memset(out, filler, size);
}
const Replacement other_memory[] = {{"malloc", reinterpret_cast<void*>(&other_malloc)}};

constexpr std::size_t page_bytes = 4096;

std::size_t odd_pages = 3;

/// Memory of many sizes is taken before the library is loaded, so that no gap is left in which it was before; new
/// memory holds other bytes.
bool use_other_memory() {
  constexpr std::size_t least = page_bytes, most = std::size_t{32} << 20;
  const std::size_t odd_size = odd_pages * page_bytes;
  fills_memory = true;
  // All stay taken to the end of the process of this check.
  bool is_taken = true;
  for (std::size_t size = most; size >= least; size /= 2)
    is_taken = is_taken &&
               mmap(nullptr, size + odd_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
  [[maybe_unused]] static void* volatile taken = std::malloc(4'112);
  return is_taken;
}

struct Elsewhere {
  std::string_view what;
  bool (*go)();
  void (*come_back)();
  bool moves_library = false;
};

const Elsewhere other_places[] = {
    // First, since each of the others is another process, too.
    {"in another process, with other addresses and other bytes in new memory", use_other_memory,
     [] { fills_memory = false; }, true},
    {"where numbers are written with a decimal comma (locale)", use_comma, use_point},
    {"with another working folder and other environment variables", use_other_folder,
     [] { sets_all_variables = false; }},
    {"at another time", use_other_time, [] { seconds_ahead = 0; }},
};

/// What each block of each stand shows, as a number; and the page of the memory in which the library lies.
struct Results {
  std::vector<std::uint64_t> numbers;
  std::uint64_t page = 0;
};

Results results_there(Examination& e, const std::string& where) {
  Results out;
  Subject subject(e);
  out.page = reinterpret_cast<std::uintptr_t>(subject.plugin().name) / page_bytes;
  redirect(other_clocks, Redirected::libraries);
  redirect(other_memory, Redirected::libraries);
  redirect(other_variables, Redirected::libraries, e.file);
  for (const Stand& stand : stands_of(subject, e)) {
    e.attempt(std::string(stand.syntax->id) + where);
    Bench bench(stand.alone, {});
    bench.start();
    for (const TestBlock& block : many_blocks(stand, e, 0))
      out.numbers.push_back(std::hash<std::string>{}(bench.run(block).shown));
  }
  return out;
}

constexpr std::size_t most_results = 1 << 18;
enum class End { complete, crashed, cannot_go };

/// In a process of its own, where there may be one.
End results_at(Examination& e, const Elsewhere* place, Results& out) {
  constexpr std::size_t head = 3;
  const std::size_t bytes = (most_results + head) * sizeof(std::uint64_t);
  void* const shared = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no memory for results");
  auto* const numbers = static_cast<std::uint64_t*>(shared);
  const bool survived = survives(e, [&] {
    numbers[0] = place == nullptr || place->go() ? 1 : 0;
    if (numbers[0] == 0) return;
    const Results all = results_there(e, place == nullptr ? "" : ", " + std::string(place->what));
    numbers[1] = std::min(all.numbers.size(), most_results);
    numbers[2] = all.page;
    std::copy_n(all.numbers.begin(), numbers[1], numbers + head);
    if (place != nullptr) place->come_back();
  });
  const bool could_go = numbers[0] == 1;
  out.numbers.assign(numbers + head, numbers + head + numbers[1]);
  out.page = numbers[2];
  munmap(shared, bytes);
  return !survived ? End::crashed : could_go ? End::complete : End::cannot_go;
}

/// The same, in a process in which the library lies elsewhere. Chance can put it at an address of which the bits that
/// tell it from others are those of `expected`: then it is moved on.
End results_elsewhere(Examination& e, const Elsewhere& place, const Results& expected, Results& out) {
  constexpr std::size_t tries = 4;
  constexpr std::uint64_t low_bits = 0xff;
  for (std::size_t i = 0; i < tries; ++i) {
    const End end = results_at(e, &place, out);
    const bool is_moved = ((out.page ^ expected.page) & low_bits) != 0;
    if (end != End::complete || is_moved || !place.moves_library || out.numbers != expected.numbers) return end;
    odd_pages += 2;
  }
  return End::cannot_go;
}

/// Syntax and block of result number `index`.
std::string block_of_result(Examination& e, std::size_t index) {
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e))
    for (const TestBlock& block : many_blocks(stand, e, 0))
      if (index-- == 0) return std::string(stand.syntax->id) + ", " + block.name;
  return {};
}

}  // namespace

void check_elsewhere(Examination& e) {
  Results expected;
  if (results_at(e, nullptr, expected) == End::crashed) return;  // other checks tell that, and where
  for (const Elsewhere& place : other_places) {
    Results found;
    const End end = results_elsewhere(e, place, expected, found);
    if (end == End::cannot_go) {
      e.remark(fmt::format("not looked at {}: this system does not allow it", place.what));
      continue;
    }
    const std::size_t common = std::min(expected.numbers.size(), found.numbers.size());
    const auto differing = static_cast<std::size_t>(
        std::mismatch(expected.numbers.begin(), expected.numbers.begin() + static_cast<std::ptrdiff_t>(common),
                      found.numbers.begin())
            .first -
        expected.numbers.begin());
    const bool is_same = end == End::complete && differing == common && expected.numbers.size() == found.numbers.size();
    if (is_same) continue;
    if (end == End::crashed)
      e.find("", fmt::format("it crashes, does not return, or ends the process {}", place.what));
    else
      e.find(differing < common ? block_of_result(e, differing) : "",
             fmt::format("its result is another one {}", place.what));
    return;  // the others are in another process as well, so they may show the same
  }
}

}  // namespace isogloss::cli
