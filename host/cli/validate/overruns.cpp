// Writes beside the memory that the plugin has allocated: they harm somebody else, and seldom at once.
#include <dlfcn.h>

#include <limits>

#include "validate/fenced_memory.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

std::vector<TestBlock> blocks_of(const Stand& stand, const Examination& e) {
  constexpr std::uint64_t random_ones = 60;
  constexpr double extreme[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                1e308, -1e308};
  std::vector<TestBlock> out = many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0);
  for (const double number : extreme) out.push_back(block_of_numbers(stand, number));
  for (const double number : rare_numbers) out.push_back(block_of_numbers(stand, number));
  for (const std::string& text : odd_texts()) {
    out.push_back(out.front());
    out.back().name = "an odd text";
    out.back().text = text;
  }
  return out;
}

}  // namespace

void check_overruns(Examination& e) {
  if (!e.may_fork) return e.remark("not looked at: what stands around the memory stays for the rest of the process");
  // The fences are of a library that is there before the host asks it for anything.
  dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  FencedMemory memory(e.file);
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    const std::string id = stand.syntax->id;
    const auto is_harmed = [&](const std::string& when) {
      const std::string damage = memory.damage();
      if (!damage.empty()) e.find(id + ", " + when, "it writes beside the memory that it has allocated: " + damage);
      return !damage.empty();
    };
    {
      e.attempt(id);
      Bench bench(stand.alone, in_mode(Mode::fast));
      bench.start();
      if (is_harmed("before its first block")) continue;
      bool is_told = false;
      for (const TestBlock& block : blocks_of(stand, e)) {
        e.attempt(id + ", " + block.name);
        bench.run(block, false);
        is_told = is_harmed(block.name);
        if (is_told) break;
      }
      if (is_told) continue;
    }
    is_harmed("when its chain is destroyed");
  }
}

}  // namespace isogloss::cli
