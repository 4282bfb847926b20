// What the plugin allocates: nothing while it builds, and nothing that stays.
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "isogloss/engine/host_functions.hpp"
#include "validate/allocation_counter.hpp"
#include "validate/option_values.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// A function of the host, during which nothing is counted for the plugin.
template <auto member>
struct Uncounted;
template <class R, class... A, R (*ig_host::*member)(A...)>
struct Uncounted<member> {
  static R call(A... arguments) {
    const AllocationCounter::InHost at_work;
    return (host_table(Mode::fast).*member)(arguments...);
  }
};

ig_host uncounted_host() {
  ig_host out = host_table(Mode::fast);
  out.flags = 0;
  replace_functions<Uncounted>(out);
  return out;
}

/// Bytes that each call of `work` leaves behind, at least: what grows only once, as a buffer does, counts for nothing.
template <class Work>
std::int64_t bytes_left(Work&& work) {
  constexpr int warm_up = 3, calls = 6, rounds = 3;
  for (int i = 0; i < warm_up; ++i) work();
  std::int64_t least = INT64_MAX;
  for (int round = 0; round < rounds; ++round) {
    AllocationCounter::start();
    for (int i = 0; i < calls; ++i) work();
    least = std::min(least, AllocationCounter::bytes() / calls);
    AllocationCounter::stop();
  }
  return least;
}

/// Bytes that many further calls of `work` leave behind, more than one buffer that grows once would: 0 when they leave
/// none. A list that keeps something of each call may have room for many of them at first.
template <class Work>
std::int64_t bytes_in_the_long_run(Work&& work) {
  constexpr int warm_up = 40, calls = 700;  // so many that a list doubles its room, also one that has much at first
  constexpr std::int64_t tolerance = 1024;
  for (int i = 0; i < warm_up; ++i) work();
  AllocationCounter::start();
  for (int i = 0; i < calls; ++i) work();
  const std::int64_t out = AllocationCounter::bytes();
  AllocationCounter::stop();
  return out > tolerance ? out : 0;
}

/// The subject, all of whose allocations are counted. A descriptor may hold the address of free() itself, as destroy():
/// that is why its library is there, and redirected, before the host looks at it.
struct CountedSubject {
  explicit CountedSubject(Examination& e) : library(dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL)), subject(e) {}
  void* library;
  AllocationCounter of_library;
  Subject subject;
  AllocationCounter of_all;

  /// False, and told, where nothing can be counted.
  bool counts(Examination& e) const {
    if (!of_all.is_complete()) e.remark("not looked at: this system gives no way to count allocations");
    return of_all.is_complete();
  }
};

}  // namespace

namespace {

/// A few blocks very often, and many runs.
void check_long_run(Examination& e, const Stand& stand, Bench& bench, const std::vector<TestBlock>& blocks) {
  constexpr std::size_t most_blocks = 3;  // the last ones of the stand, the one with all fields, and random ones
  const std::size_t begin = std::min(stand.blocks.size() - 1, blocks.size() - most_blocks);
  const std::span<const TestBlock> some(blocks.data() + begin, most_blocks);
  std::int64_t bytes = bytes_in_the_long_run([&] {
    for (const TestBlock& block : some) bench.prepare(block), bench.scan(), bench.build();
  });
  if (bytes > 0)
    return e.find(stand.syntax->id, fmt::format("memory grows without end: by {} bytes in many blocks", bytes));
  bytes = bytes_in_the_long_run([&] { bench.start(); });
  if (bytes > 0)
    e.find(stand.syntax->id,
           fmt::format("memory grows without end: by {} bytes in many runs; restart() must free", bytes));
}

/// Names live as long as their chain, so no build may make one from a number.
void check_names(Examination& e, const Stand& stand, Bench& bench) {
  constexpr int warm_up = 50, rounds = 400;
  const TestBlock full = full_block(stand.alone, fields_of(stand.alone));
  std::size_t names = 0;
  for (int i = 0; i < warm_up + rounds; ++i) {
    if (i == warm_up) names = bench.chain().symbols().size();
    TestBlock block = full;
    for (Assignment& a : block.assignments)
      if (stand.alone.linked->layout.fields[a.field].type == IG_NUMBER) a.value.number = 0.125 * i;
    bench.run(block, false);
  }
  if (const std::size_t made = bench.chain().symbols().size() - names; made > rounds / 2)
    e.find(stand.syntax->id, fmt::format("memory grows without end: {} new names, which the host keeps, in {} blocks "
                                         "that differ in their numbers",
                                         made, rounds));
}

/// A chain with other options may allocate what one without them does not.
void check_other_options(Examination& e, Subject& subject, const Stand& stand) {
  constexpr std::uint64_t tries = 3;
  for (std::uint64_t seed = 0; seed < tries && stand.syntax->option_count > 0; ++seed) {
    const std::string element = other_options(*stand.syntax, seed);
    DiagnosticList said;
    const LinkedAlone alone =
        link_alone(*stand.syntax, subject.plugin(), subject.surroundings(), element, subject.library(), said);
    if (alone.linked == nullptr || !creation_fault(alone, {}).empty()) continue;
    const TestBlock full = full_block(alone, fields_of(alone));
    const std::int64_t bytes = bytes_left([&] {
      Bench bench(alone, {});
      bench.start();
      bench.run(full, false);
    });
    if (bytes <= 0) continue;
    e.find(std::string(stand.syntax->id) + ", " + element,
           fmt::format("a chain that is destroyed leaves {} bytes behind", bytes));
    return;
  }
}

}  // namespace

void check_memory(Examination& e) {
  constexpr std::uint64_t random_ones = 10;
  CountedSubject counted(e);
  if (!counted.counts(e)) return;
  for (const Stand& stand : stands_of(counted.subject, e)) {
    const std::string id = stand.syntax->id;
    e.attempt(id);
    const std::vector<TestBlock> blocks = many_blocks(stand, e, random_ones);
    {
      Bench bench(stand.alone, {});
      const std::int64_t bytes = bytes_left([&] {
        for (const TestBlock& block : blocks) bench.prepare(block), bench.scan(), bench.build();
      });
      if (bytes > 0)
        e.find(id, fmt::format("memory grows without end: by {} bytes with every {} blocks", bytes, blocks.size()));
      else if (stand.dependencies.empty())
        check_long_run(e, stand, bench, blocks), check_names(e, stand, bench);
    }
    if (stand.dependencies.empty()) check_other_options(e, counted.subject, stand);
    const std::int64_t bytes = bytes_left([&] { Bench(stand.alone, {}).start(); });
    if (bytes > 0) e.find(id, fmt::format("a chain that is destroyed leaves {} bytes behind", bytes));
  }
}

void check_allocations(Examination& e) {
  constexpr int warm_up = 8, builds = 4;
  constexpr std::uint64_t random_ones = 40;
  const ig_host host = uncounted_host();
  ChainSettings settings;
  settings.host = &host;
  CountedSubject counted(e);
  if (!counted.counts(e)) return;
  for (const Stand& stand : stands_of(counted.subject, e)) {
    Bench bench(stand.alone, settings);
    std::uint64_t most = 0;
    std::string name;
    for (const TestBlock& block : many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0)) {
      e.attempt(std::string(stand.syntax->id) + ", " + block.name);
      for (int i = 0; i < warm_up; ++i) bench.prepare(block), bench.build();
      std::uint64_t least = UINT64_MAX;
      for (int i = 0; i < builds; ++i) {
        bench.prepare(block);
        AllocationCounter::start();
        bench.build();
        least = std::min(least, AllocationCounter::stop());
      }
      if (least > most) most = least, name = block.name;
    }
    if (most > 0)
      e.find(std::string(stand.syntax->id) + ", " + name,
             fmt::format("each build allocates {} time{} more", most, most == 1 ? "" : "s"));
  }
}

}  // namespace isogloss::cli
