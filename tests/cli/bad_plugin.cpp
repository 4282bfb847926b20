// A plugin that misbehaves on command: M901 writes through a null pointer, M902 never returns, M903 throws, M904
// aborts, M905 prints a line, M906 prints for ever, M907 closes what it could print to, M908 leaves a process behind,
// M909 two that have left its group, the second a child of the first, and the scanner crashes at a question mark.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <isogloss/sdk.hpp>
#include <stdexcept>

const char* ig::embedded_page(const char*) noexcept { return nullptr; }
const char* ig::embedded_folder(const char*) noexcept { return nullptr; }
const ig::EmbeddedDiagnostic* ig::embedded_diagnostic(const char*) noexcept { return nullptr; }

namespace {

struct Misbehave {
  static constexpr auto spec = ig::syntax("MisbehaveSyntax", "Misbehaves when told to.").scans("?");

  ig::Codes codes_{"M901", "M902", "M903", "M904", "M905", "M906", "M907", "M908", "M909"};

  [[gnu::no_sanitize("undefined")]] static void crash() {  // a real crash, in a sanitizer build too
    volatile int* volatile nowhere = nullptr;
    *nowhere = 1;
  }

  std::size_t scan(ig::Block&, std::string_view, std::size_t position) {
    crash();
    return position;
  }

  ig::Status build(ig::Block& b) {
    const auto code = b.take(codes_);
    if (!code) return ig::Status::unchanged;
    volatile bool forever = true;
    switch (*code) {
      case 0: crash(); break;
      case 1:
        while (forever) {
        }
        break;
      case 2: throw std::runtime_error("thrown on purpose");
      case 4: std::puts("{\"Summary\": null, \"First\": null, \"Called\": []}"); break;
      case 5:
        while (forever) std::puts("noise");
        break;
      case 6:
        for (int descriptor = STDOUT_FILENO; descriptor < 64; ++descriptor)
          if (struct stat info{}; ::fstat(descriptor, &info) == 0 && S_ISFIFO(info.st_mode)) ::close(descriptor);
        break;
      case 7:
        if (::fork() == 0) ::sleep(600), ::_exit(0);
        break;
      case 8:
        if (::fork() == 0) ::setsid(), ::fork(), ::sleep(600), ::_exit(0);
        break;
      default: std::abort();
    }
    return ig::Status::changed;
  }
};

const ig::Register<Misbehave> registered;

constexpr std::array diagnostics{ig::diagnostic(IG_NOTE, "BAD-0001", "unused", "Unused.", "")};

}  // namespace

ISOGLOSS_PLUGIN("cli_bad_plugin", "1.0.0", "tests", diagnostics)
