// Random blocks: each comes from the seed, the syntax and its number alone, so that any one can be made again.
#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <set>

#include "crash_guard.hpp"
#include "validate/child.hpp"
#include "validate/process_state.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

using Random = std::mt19937_64;

std::uint64_t below(Random& random, std::uint64_t end) { return random() % end; }

/// The same on every platform, unlike the distributions of the standard library.
double random_number(Random& random) {
  constexpr double usual[] = {0, 1, -1, 0.5, 2, 10, 90, 360, 1000, -1e-9, 1e6, 1e15};
  if (below(random, 2) == 0) return usual[below(random, std::size(usual))];
  return static_cast<double>(below(random, 2'000'001)) / 1000 - 1000;
}

std::string random_text(Random& random, std::string_view first) {
  constexpr std::string_view bytes = "GMXYZFSTNOHDPQRIJKABC0123456789.-+ ()[]#=;\"%/*:,$";
  std::string out;
  for (std::uint64_t left = below(random, 40); left > 0; --left)
    out += !first.empty() && below(random, 4) == 0 ? first[below(random, first.size())]
                                                   : bytes[below(random, bytes.size())];
  return out;
}

}  // namespace

TestBlock random_block(const Stand& stand, const std::vector<ig_field>& fields, std::uint64_t seed, std::uint64_t k) {
  std::uint64_t name = 1469598103934665603u;  // FNV-1a of the syntax, so that its blocks are its own
  for (const char* c = stand.syntax->id; *c != '\0'; ++c)
    name = (name ^ static_cast<unsigned char>(*c)) * 1099511628211u;
  std::seed_seq sequence{seed, seed >> 32, name, name >> 32, k, k >> 32};
  Random random(sequence);
  TestBlock out{.name = fmt::format("random block {} of seed {}", k, seed)};
  if (stand.syntax->scan != nullptr) out.text = random_text(random, stand.syntax->triggers);
  const std::uint64_t density = 1 + below(random, 9);
  std::int64_t ordinal = 0;
  const LinkedDialect& linked = *stand.alone.linked;
  for (const ig_field f : fields) {
    if (below(random, 10) >= density) continue;
    Assignment a{f, {}, {}};
    switch (linked.layout.fields[f].type) {
      case IG_NUMBER:
      case IG_TRANSFORM: a.value.number = random_number(random); break;
      case IG_INTEGER: a.value.integer = static_cast<std::int64_t>(below(random, 1000)) - 10; break;
      case IG_CODE: a.value.integer = ++ordinal; break;
      case IG_SYMBOL:
        if (linked.symbols.size() == 0) continue;
        a.value.symbol = 1 + below(random, linked.symbols.size());
        break;
      case IG_TEXT: a.text = random_text(random, {}); break;
      default: a.value.integer = static_cast<std::int64_t>(below(random, 2));
    }
    out.assignments.push_back(std::move(a));
  }
  // A syntax without a scanner may read the text of its block all the same.
  if (stand.syntax->scan == nullptr && below(random, 4) == 0) out.text = random_text(random, {});
  if (below(random, 40) == 0) {
    const std::vector<std::string>& odd = odd_texts();
    out.text.insert(below(random, out.text.size() + 1), odd[below(random, odd.size())]);
  }
  return out;
}

TestBlock block_of_numbers(const Stand& stand, double number) {
  TestBlock out = full_block(stand.alone, fields_of(stand.alone));
  out.name += fmt::format(" whose numbers are all {}", number);
  for (Assignment& a : out.assignments)
    if (stand.alone.linked->layout.fields[a.field].type == IG_NUMBER) a.value.number = number;
  return out;
}

std::vector<TestBlock> many_blocks(const Stand& stand, const Examination& e, std::uint64_t random_ones) {
  const std::vector<ig_field> fields = fields_of(stand.alone);
  std::vector<TestBlock> out = stand.blocks;
  out.push_back(full_block(stand.alone, fields));
  for (std::uint64_t k = 0; k < random_ones; ++k) out.push_back(random_block(stand, fields, e.options.seed, k));
  return out;
}

namespace {

class RandomBlocks {
 public:
  RandomBlocks(Examination& e, const Stand& stand) : e_(e), stand_(stand), fields_(fields_of(stand.alone)) {}

  /// How many blocks were built: fewer than `blocks` when one failed or the time was over.
  std::uint64_t run(std::uint64_t blocks, Clock::time_point end) {
    std::uint64_t built = 0;
    const std::optional<std::uint64_t> failing = first_failing(blocks, end, built);
    if (failing) tell(*failing);
    return built;
  }

 private:
  static inline const ChainSettings settings = in_mode(Mode::checked);

  void tell(std::uint64_t failing) {
    TestBlock block = random_block(stand_, fields_, e_.options.seed, failing);
    const std::string where = std::string(stand_.syntax->id) + ", " + block.name;
    if (!fails(block)) {
      e_.find(where, "it fails only after the blocks before it: the syntax keeps something of them");
      return;
    }
    shrink(block);
    Bench bench(stand_.alone, settings);
    const bool ends = !survives(e_, [&] { Bench(stand_.alone, settings).run(block, false); });
    const std::string fault =
        ends ? "it crashes, does not return, or ends the process" : bench.run(block, false).fault();
    std::string shown;
    for (const Assignment& a : block.assignments) shown += " " + stand_.alone.linked->layout.fields[a.field].path;
    e_.find(where, fmt::format("{}\n  the smallest block that fails: {}\n  its fields:{}", fault, bench.show(block),
                               shown.empty() ? " none" : shown));
  }

  /// `built`: the blocks before it, or all that the time allowed.
  std::optional<std::uint64_t> first_failing(std::uint64_t blocks, Clock::time_point end, std::uint64_t& built) {
    void* const shared =
        mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory for random blocks");
    auto* const number = static_cast<volatile std::uint64_t*>(shared);
    bool has_failed = false;
    const bool survived = survives(e_, [&] {
      watch_calls(e_.may_fork ? 1 : 0);
      const ProcessState state;
      Bench bench(stand_.alone, settings);
      std::uint64_t k = 0;
      for (; k < blocks && Clock::now() < end; ++k) {
        *number = k;
        const TestBlock block = random_block(stand_, fields_, e_.options.seed, k);
        if (bench.run(block, false).fault().empty()) continue;
        if (e_.may_fork) end_process(input_errors);
        has_failed = true;
        return;
      }
      *number = k;
      for (const std::string& change : state.changes())
        e_.find(stand_.syntax->id, "after its random blocks: " + change);
    });
    built = *number;
    munmap(shared, sizeof(std::uint64_t));
    return survived && !has_failed ? std::nullopt : std::optional(built);
  }

  /// On a new chain, so that nothing of other blocks counts.
  bool fails(const TestBlock& block) const {
    bool has_failed = false;
    const bool survived = survives(e_, [&] {
      watch_calls(e_.may_fork ? 1 : 0);
      has_failed = !Bench(stand_.alone, settings).run(block, false).fault().empty();
      if (has_failed && e_.may_fork) end_process(input_errors);
    });
    return has_failed || !survived;
  }

  /// Leaves out what the failure does not need, then makes the numbers simple.
  void shrink(TestBlock& block) const {
    const Clock::time_point end = Clock::now() + std::chrono::seconds(10);
    const auto keep_if_failing = [&](const TestBlock& smaller) {
      if (Clock::now() > end || !fails(smaller)) return false;
      block = smaller;
      return true;
    };
    for (std::size_t size = block.assignments.size(); size > 0; size /= 2)
      for (std::size_t i = 0; i + size <= block.assignments.size();) {
        TestBlock smaller = block;
        const auto at = smaller.assignments.begin() + static_cast<std::ptrdiff_t>(i);
        smaller.assignments.erase(at, at + static_cast<std::ptrdiff_t>(size));
        if (!keep_if_failing(smaller)) i += size;
      }
    for (std::size_t size = block.text.size(); size > 0; size /= 2)
      for (std::size_t i = 0; i + size <= block.text.size();) {
        TestBlock smaller = block;
        smaller.text.erase(i, size);
        if (!keep_if_failing(smaller)) i += size;
      }
    for (std::size_t i = 0; i < block.assignments.size(); ++i) {
      if (stand_.alone.linked->layout.fields[block.assignments[i].field].type != IG_NUMBER) continue;
      for (const double simple : {0.0, 1.0}) {
        TestBlock simpler = block;
        simpler.assignments[i].value.number = simple;
        if (keep_if_failing(simpler)) break;
      }
    }
  }

  Examination& e_;
  const Stand& stand_;
  const std::vector<ig_field> fields_;
};

}  // namespace

void check_random_blocks(Examination& e) {
  Subject subject(e);
  const std::vector<Stand> all = stands_of(subject, e);
  std::vector<const Stand*> stands;
  std::set<const ig_syntax*> done;
  for (const Stand& stand : all)
    if (done.insert(stand.syntax).second) stands.push_back(&stand);  // the first one has the default options
  if (stands.empty()) return;

  // A syntax that needs less than its share of the time leaves the rest to those after it.
  const double limit = std::min<double>(e.options.random_limit, e.options.time_limit / 2.0);
  const std::uint64_t share = (e.options.blocks + stands.size() - 1) / stands.size();
  const Clock::time_point begin = Clock::now();
  std::uint64_t built = 0;
  for (std::size_t i = 0; i < stands.size(); ++i) {
    e.attempt(std::string(stands[i]->syntax->id) + ", random blocks");
    const std::chrono::duration<double> until(limit * static_cast<double>(i + 1) / static_cast<double>(stands.size()));
    built += RandomBlocks(e, *stands[i]).run(share, begin + std::chrono::duration_cast<Clock::duration>(until));
  }
  if (e.findings() > 0) return;
  const std::uint64_t wanted = share * stands.size();
  e.remark(built == wanted ? fmt::format("{} random blocks of seed {}", built, e.options.seed)
                           : fmt::format("{} of {} random blocks of seed {}: the {:.0f} s of --random-limit were over",
                                         built, wanted, e.options.seed, limit));
}

}  // namespace isogloss::cli
