// The same blocks again: by a new chain, after a restart, beside another chain, beside another thread.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

constexpr std::uint64_t rare_blocks = 200;
constexpr const char* kept = "; a plugin keeps what it needs in *self, never in globals";

/// All that a sequence of blocks shows.
std::vector<std::string> results(Bench& bench, const std::vector<TestBlock>& blocks) {
  std::vector<std::string> out;
  for (const TestBlock& block : blocks) out.push_back(bench.run(block).shown);
  return out;
}

/// Names the first block whose results differ.
void compare(Examination& e, const Stand& stand, const std::vector<std::string>& first,
             const std::vector<std::string>& second, const std::string& what) {
  for (std::size_t i = 0; i < first.size(); ++i)
    if (first[i] != second[i]) {
      e.find(std::string(stand.syntax->id) + ", " + stand.blocks[i].name, what);
      return;
    }
}

template <class Compare>
void on_each_stand(Examination& e, Compare&& compare) {
  Subject subject(e);
  for (Stand& stand : stands_of(subject, e)) {
    stand.blocks.push_back(full_block(stand.alone, fields_of(stand.alone)));
    e.attempt(stand.syntax->id);
    compare(stand);
  }
}

}  // namespace

void check_same_result(Examination& e) {
  on_each_stand(e, [&](const Stand& stand) {
    Bench first(stand.alone, {}), second(stand.alone, {});
    const std::vector<std::string> expected = results(first, stand.blocks);
    compare(e, stand, expected, results(second, stand.blocks),
            std::string("a new chain gives another result for the same block") + kept);
  });
}

void check_restart(Examination& e) {
  on_each_stand(e, [&](const Stand& stand) {
    // What a service keeps, its dependency forgets: a run creates it anew.
    if (stand.syntax->service_count > 0) return;
    Bench bench(stand.alone, {});
    bench.start();
    const std::vector<std::string> expected = results(bench, stand.blocks);
    // A rare block, one with an error for instance, may leave more behind than those of the cases.
    for (const TestBlock& block : many_blocks(stand, e, rare_blocks)) bench.run(block, false);
    bench.start();
    compare(e, stand, expected, results(bench, stand.blocks),
            "the second run gives another result; restart() must forget what the first run left in *self");
  });
}

void check_two_chains(Examination& e) {
  on_each_stand(e, [&](const Stand& stand) {
    Bench alone(stand.alone, {});
    const std::vector<std::string> expected = results(alone, stand.blocks);
    Bench first(stand.alone, {}), second(stand.alone, {});
    std::vector<std::string> beside_other;
    for (std::size_t i = 0; i < stand.blocks.size(); ++i) {
      second.run(stand.blocks[stand.blocks.size() - 1 - i], false);
      beside_other.push_back(first.run(stand.blocks[i]).shown);
    }
    compare(e, stand, expected, beside_other, std::string("another chain at work changes the result") + kept);
  });
}

namespace {

/// The same builds again and again, without a look at more than the document: a race needs many of them. Ends when
/// another thread has seen a difference, too.
void race(const Stand& stand, std::chrono::milliseconds time, std::atomic<std::size_t>& differing) {
  const Clock::time_point end = Clock::now() + time;
  Bench bench(stand.alone, {});
  bench.start();
  std::vector<Document> expected;
  for (const TestBlock& block : stand.blocks) {
    bench.prepare(block);
    bench.build();
    expected.push_back(bench.chain().document());
  }
  while (Clock::now() < end && differing == SIZE_MAX)
    for (std::size_t i = 0; i < stand.blocks.size(); ++i) {
      bench.prepare(stand.blocks[i]);
      ++bench.chain().builds;
      bench.build();
      if (!bench.chain().document().same_content(expected[i])) differing = i;
    }
}

}  // namespace

void check_threads(Examination& e) {
  constexpr auto least = std::chrono::milliseconds(8);
  constexpr std::size_t shared_time = 2'000;  // ms, for all stands
  std::size_t stands = 0;
  on_each_stand(e, [&](const Stand&) { ++stands; });
  const std::chrono::milliseconds racing(
      std::clamp<std::size_t>(shared_time / std::max<std::size_t>(stands, 1), 4, 300));
  on_each_stand(e, [&](const Stand& stand) {
    std::vector<std::string> expected;
    {
      Bench alone(stand.alone, {});
      expected = results(alone, stand.blocks);
    }
    std::atomic<std::size_t> differing = SIZE_MAX;
    const auto work = [&] {
      const Clock::time_point begin = Clock::now();
      do {
        Bench bench(stand.alone, {});
        for (std::size_t i = 0; i < stand.blocks.size(); ++i)
          if (bench.run(stand.blocks[i]).shown != expected[i]) differing = i;
      } while (Clock::now() - begin < least && differing == SIZE_MAX);
      if (stand.syntax->build != nullptr) race(stand, racing, differing);
    };
    std::thread other(work);
    work();
    other.join();
    if (differing != SIZE_MAX)
      e.find(std::string(stand.syntax->id) + ", " + stand.blocks[differing].name,
             std::string("a chain on another thread changes the result") + kept);
  });
}

}  // namespace isogloss::cli
