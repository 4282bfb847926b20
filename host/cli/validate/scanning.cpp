// Scanners: whatever follows the byte at which they are asked, they stay in the text and write what they declare.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// One text at a time, behind which no memory is.
class GuardedLine {
 public:
  GuardedLine() : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    void* const mapped = mmap(nullptr, 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) throw std::runtime_error("no memory for a text");
    begin_ = static_cast<char*>(mapped);
    mprotect(begin_ + page_, page_, PROT_NONE);
  }
  ~GuardedLine() { munmap(begin_, 2 * page_); }
  GuardedLine(const GuardedLine&) = delete;
  GuardedLine& operator=(const GuardedLine&) = delete;

  std::string_view place(std::string_view text) {
    char* const at = begin_ + page_ - text.size();
    std::memcpy(at, text.data(), text.size());
    return {at, text.size()};
  }

 private:
  std::size_t page_;
  char* begin_ = nullptr;
};

/// At most this many of the bytes at which the scanner is asked, from all over them.
std::string some_triggers(const char* triggers) {
  constexpr std::size_t most = 16;
  const std::string all = triggers;
  if (all.size() <= most) return all;
  std::string out;
  for (std::size_t i = 0; i < most; ++i) out += all[i * all.size() / most];
  return out;
}

/// Calls `judge` with each text until it is not content.
template <class Judge>
void on_each_text(const ig_syntax& syntax, Judge&& judge) {
  for (const char trigger : some_triggers(syntax.triggers)) {
    for (int next = 0; next < 256; ++next) {
      const std::string pair{trigger, static_cast<char>(next)};
      for (const std::string& text : {pair, "X1 " + pair + "1"})
        if (!judge(text)) return;
    }
    for (const std::string& odd : odd_texts())
      for (const std::string& text : {trigger + odd, trigger + ("1" + odd), "  " + odd + trigger})
        if (!judge(text)) return;
    for (const char* const rest :
         {"", "-", "+", ".", "-.", "1.", "1.5.5", "0000000000000000000001", "1e5", "[#1+2", "<A", "\"A"})
      if (!judge(std::string("N5") + trigger + rest)) return;
  }
}

}  // namespace

void check_scan(Examination& e) {
  Subject subject(e);
  const auto scans = [](const ig_syntax* s) { return s->scan != nullptr; };
  if (std::none_of(subject.syntaxes().begin(), subject.syntaxes().end(), scans)) return;
  for (const Stand& stand : stands_of(subject, e)) {
    if (stand.syntax->scan == nullptr || !stand.dependencies.empty()) continue;
    GuardedLine line;
    Bench bench(stand.alone, in_mode(Mode::checked));
    bench.place_text = [&line](std::string_view text) { return line.place(text); };
    on_each_text(*stand.syntax, [&](const std::string& text) {
      const std::string where = fmt::format("{}, the text {:?}", stand.syntax->id, text);
      e.attempt(where + "; no byte behind the text may be read");
      const std::string fault = bench.run({.name = "a text", .text = text}, false).fault();
      if (!fault.empty()) e.find(where, fault);
      return fault.empty();
    });
  }
}

}  // namespace isogloss::cli
