// Scanners: whatever follows the byte at which they are asked, they stay in the text and write what they declare.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// Has the scanner under way given a word?
thread_local bool has_word = false;
thread_local bool has_lied = false;
thread_local ig_scan_fn watched_scan = nullptr;

ig_host noting_host() {
  ig_host out = host_table(Mode::checked);
  out.set_words = [](ig_block* b, const ig_word* words, std::uint32_t count) {
    has_word = true;
    return host_table(Mode::checked).set_words(b, words, count);
  };
  return out;
}

/// Who takes no byte of a text has no word of it either: the next scanner would find it again.
std::size_t noting_scan(void* self, const ig_host* host, ig_block* block, const char* text, std::size_t size,
                        std::size_t position) {
  has_word = false;
  const std::size_t end = watched_scan(self, host, block, text, size, position);
  has_lied = has_lied || (end == position && has_word);
  return end;
}

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
  std::string all = triggers;
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

/// A line of 60,000 bytes is rare, and no reason to wait.
std::string growth_fault(const Stand& stand) {
  constexpr std::size_t size = 8000, times = 4;
  constexpr double too_much = 2.5 * times, noise = 0.05;  // the second in seconds: what is faster may be chance
  constexpr int tries = 3;
  Bench bench(stand.alone, {});
  const auto seconds = [&](std::string text) {
    const TestBlock block{.name = "a text", .text = std::move(text)};
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) {
      bench.prepare(block);
      ++bench.chain().builds;  // a trial is work of its own to the watch over calls that do not return
      const double begin = thread_seconds();
      bench.scan();
      least = std::min(least, thread_seconds() - begin);
    }
    return least;
  };
  for (const char trigger : some_triggers(stand.syntax->triggers)) {
    const double second = seconds(std::string(times * size, trigger));
    if (second < noise) continue;
    if (const double ratio = second / seconds(std::string(size, trigger)); ratio > too_much)
      return fmt::format(
          "{} bytes {:?} take {:.0f} times as long as {}: its scan() reads the rest of the text again "
          "from each byte",
          times * size, trigger, ratio, size);
  }
  return {};
}

}  // namespace

void check_scan(Examination& e) {
  Subject subject(e);
  const auto scans = [](const ig_syntax* s) { return s->scan != nullptr; };
  if (std::none_of(subject.syntaxes().begin(), subject.syntaxes().end(), scans)) return;
  for (const Stand& stand : stands_of(subject, e)) {
    if (stand.syntax->scan == nullptr || !stand.dependencies.empty()) continue;
    GuardedLine line;
    const ig_host host = noting_host();
    ChainSettings settings = in_mode(Mode::checked);
    settings.host = &host;
    ig_syntax noting = *stand.syntax;
    watched_scan = std::exchange(noting.scan, noting_scan);
    stand.alone.linked->chain[stand.alone.position].syntax = &noting;
    Bench bench(stand.alone, settings);
    bench.place_text = [&line](std::string_view text) { return line.place(text); };
    on_each_text(*stand.syntax, [&](const std::string& text) {
      const std::string where = fmt::format("{}, the text {:?}", stand.syntax->id, text);
      e.attempt(where + "; no byte behind the text may be read");
      has_lied = false;
      std::string fault = bench.run({.name = "a text", .text = text}, false).fault();
      if (fault.empty() && has_lied)
        fault = "its scan() gave a word and returned the position at which it was asked, which says 'not mine'";
      if (!fault.empty()) e.find(where, fault);
      return fault.empty();
    });
    stand.alone.linked->chain[stand.alone.position].syntax = stand.syntax;
    e.attempt(std::string(stand.syntax->id) + ", a long text of one letter");
    if (const std::string fault = growth_fault(stand); !fault.empty()) e.find(stand.syntax->id, fault);
  }
}

}  // namespace isogloss::cli
