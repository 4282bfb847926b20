// The same blocks again: by a new chain, after a restart, beside another chain, beside another thread.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "validate/other_chains.hpp"
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

constexpr const char* not_forgotten =
    "the second run gives another result; restart() must forget what the first run left in *self";

/// Does a service of the syntax keep something that no chain of this check creates anew?
bool keeps_in_services(const ig_syntax& syntax) {
  constexpr std::string_view forgetful[] = {
      IG_FLOW_SERVICE,           IG_PROVENANCE_SERVICE,          "isogloss.work-offset/1",
      "isogloss.tool-offset/1",  "isogloss.machine-axis/1",      "isogloss.machine-kinematics/1",
      "isogloss.canned-cycle/1", "isogloss.coordinate-system/1", "isogloss.number-format/1",
      "isogloss.motion/1"};
  return std::any_of(syntax.services, syntax.services + syntax.service_count, [&](const ig_service_decl& s) {
    return std::find(std::begin(forgetful), std::end(forgetful), std::string_view(s.id)) == std::end(forgetful);
  });
}

/// What a block gives, as a number.
std::size_t fingerprint(Bench& bench, const TestBlock& block) {
  const Trial trial = bench.run(block, false);
  const Document& d = bench.chain().document();
  std::size_t out = static_cast<std::size_t>(trial.status) + 2;
  const auto add = [&out](std::size_t value) { out = (out ^ value) * 1099511628211u; };
  for (ig_field f = 0; f < d.size(); ++f)
    if (d.present(f)) {
      add(f);
      const ig_type type = d.layout().fields[f].type;
      if (type == IG_TEXT)
        add(std::hash<std::string_view>{}(d.text(f)));
      else if (type == IG_SYMBOL)  // chains number their names differently
        add(std::hash<std::string_view>{}(bench.chain().symbols().text(static_cast<ig_symbol>(d.value(f).symbol))));
      else if (type == IG_TRANSFORM)
        for (const double m : d.frame(f).matrix) add(std::hash<double>{}(m));
      else
        add(static_cast<std::size_t>(d.value(f).integer));
    }
  for (const ListData& list : d.lists) add(list.count);
  for (const Diagnostic& said : trial.diagnostics) add(std::hash<std::string>{}(said.code + said.message));
  return out;
}

std::vector<std::size_t> fingerprints(Bench& bench, const std::vector<TestBlock>& blocks) {
  std::vector<std::size_t> out;
  for (const TestBlock& block : blocks) out.push_back(fingerprint(bench, block));
  return out;
}

/// A run gives the same as the first one of its chain, whatever the last blocks of the run before it were.
void compare_beginnings(Examination& e, const Stand& stand, Bench& bench, const std::vector<TestBlock>& blocks) {
  constexpr std::size_t most = 8, before_each = 4;
  const std::size_t step = std::max<std::size_t>(blocks.size() / most, 1);
  for (std::size_t i = 0; i < blocks.size(); i += step) {
    Bench unused(stand.alone, {});
    unused.start();
    const std::size_t expected = fingerprint(unused, blocks[i]);
    for (std::size_t k = 0; k < before_each; ++k) {
      // The last ones have extreme numbers, which leave most behind.
      const std::size_t from_end = blocks.size() - std::min(blocks.size(), before_each - k);
      const std::size_t other = k < 2 ? from_end : (i * 7 + k * 37 + 11) % blocks.size();
      bench.run(blocks[other], false);
      bench.start();
      if (fingerprint(bench, blocks[i]) == expected) continue;
      e.find(std::string(stand.syntax->id) + ", " + blocks[i].name, not_forgotten);
      return;
    }
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
    if (keeps_in_services(*stand.syntax)) return;
    Bench bench(stand.alone, {});
    bench.start();
    const std::vector<std::string> expected = results(bench, stand.blocks);
    // A rare block, one with an error for instance, may leave more behind than those of the cases, and a rare one may
    // be needed to see it: each block is at work before each other one.
    std::vector<TestBlock> blocks = many_blocks(stand, e, rare_blocks);
    for (const double number : rare_numbers) blocks.push_back(block_of_numbers(stand, number));
    bench.start();
    std::vector<std::size_t> first = fingerprints(bench, blocks);
    bench.start();
    compare(e, stand, expected, results(bench, stand.blocks), not_forgotten);
    for (const bool is_backwards : {false, true}) {
      std::vector<TestBlock> between = blocks;
      if (is_backwards) std::reverse(between.begin(), between.end());
      for (const TestBlock& block : between) bench.run(block, false);
      bench.start();
      const std::vector<std::size_t> again = fingerprints(bench, blocks);
      const auto differing =
          static_cast<std::size_t>(std::mismatch(first.begin(), first.end(), again.begin()).first - first.begin());
      if (differing == first.size()) continue;
      e.find(std::string(stand.syntax->id) + ", " + blocks[differing].name, not_forgotten);
      break;
    }
    compare_beginnings(e, stand, bench, blocks);
  });
}

void check_two_chains(Examination& e) {
  check_other_chains(e);  // first: no chain may have been at work in this process
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
