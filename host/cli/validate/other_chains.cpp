// A chain with other options, other ids of fields and other names gives the same results, whether it is the first of
// its process, or works beside a chain of another kind, or comes to the place of one that was destroyed.
#include "validate/other_chains.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <stdexcept>

#include "validate/child.hpp"
#include "validate/option_values.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t most_other_results = 1 << 16;

/// Results of the other chains, with a mark where each syntax begins.
struct OtherResults {
  std::size_t count;
  struct One {
    std::uint32_t syntax, block;
    std::uint64_t result;
  } all[most_other_results];
  void add(std::uint32_t syntax, std::uint32_t block, std::uint64_t result) {
    if (count < most_other_results) all[count++] = {syntax, block, result};
  }
};

class SharedResults {
 public:
  SharedResults()
      : memory_(mmap(nullptr, sizeof(OtherResults), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE,
                     -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::runtime_error("no memory for results");
  }
  ~SharedResults() { munmap(memory_, sizeof(OtherResults)); }
  SharedResults(const SharedResults&) = delete;
  SharedResults& operator=(const SharedResults&) = delete;
  OtherResults& operator*() const { return *static_cast<OtherResults*>(memory_); }
  OtherResults* operator->() const { return static_cast<OtherResults*>(memory_); }

 private:
  void* memory_;
};

enum class Neighbour { none, beside, before };

/// Options that differ from the defaults, and a dialect of the plugin's own syntaxes alone, whose fields and names have
/// other numbers.
std::vector<LinkedAlone> others_of(Subject& subject, const ig_syntax& syntax, std::uint64_t seed) {
  std::vector<LinkedAlone> out;
  Surroundings alone = subject.surroundings();
  alone.dialect.reset();
  DiagnosticList said;
  // The first one differs most: where nothing was before it, a plugin that keeps the first keeps this.
  const std::string options = other_options(syntax, seed);
  out.push_back(link_alone(syntax, subject.plugin(), alone, options, subject.library(), said));
  if (!options.empty())
    out.push_back(link_alone(syntax, subject.plugin(), subject.surroundings(), options, subject.library(), said));
  std::erase_if(out, [](const LinkedAlone& one) { return one.linked == nullptr; });
  return out;
}

void run_other_blocks(const Stand& stand, std::uint64_t seed, std::uint32_t syntax, std::uint32_t first,
                      OtherResults* out) {
  constexpr std::uint64_t random_ones = 6;
  DiagnosticList said;
  try {
    Bench bench(stand.alone, {});
    bench.start();
    const std::vector<ig_field> fields = fields_of(stand.alone);
    std::vector<TestBlock> blocks{full_block(stand.alone, fields)};
    for (std::uint64_t k = 0; k < random_ones; ++k) blocks.push_back(random_block(stand, fields, seed, k));
    for (const TestBlock& block : blocks) {
      const std::uint64_t result = std::hash<std::string>{}(bench.run(block).shown);
      if (out != nullptr) out->add(syntax, first++, result);
    }
  } catch (const std::runtime_error&) {
    return;  // create() may refuse options that contradict each other
  }
}

void run_others(Examination& e, Neighbour neighbour, OtherResults& out) {
  Subject subject(e);
  subject.add_own_dependencies();
  for (std::uint32_t i = 0; i < subject.syntaxes().size(); ++i) {
    const ig_syntax& syntax = *subject.syntaxes()[i];
    e.attempt(std::string(syntax.id) + ", a chain of another kind " +
              (neighbour == Neighbour::none     ? "alone"
               : neighbour == Neighbour::beside ? "beside the first one"
                                                : "after the first one"));
    DiagnosticList said;
    Stand usual{
        &syntax, {}, link_alone(syntax, subject.plugin(), subject.surroundings(), "", subject.library(), said), {}};
    const bool has_usual =
        neighbour != Neighbour::none && usual.alone.linked != nullptr && creation_fault(usual.alone, {}).empty();
    std::uint32_t first = 0;
    for (LinkedAlone& other : others_of(subject, syntax, e.options.seed)) {
      std::optional<Bench> lives;
      if (has_usual && neighbour == Neighbour::beside) {
        lives.emplace(usual.alone, ChainSettings{});
        lives->start();
        lives->run(full_block(usual.alone, fields_of(usual.alone)), false);
      }
      if (has_usual) run_other_blocks(usual, e.options.seed, i, 0, nullptr);
      const Stand stand{&syntax, {}, std::move(other), {}};
      run_other_blocks(stand, e.options.seed, i, first, &out);
      first += 1000;
    }
  }
}

}  // namespace

void check_other_chains(Examination& e) {
  if (!e.may_fork) return;
  const SharedResults expected;
  // Each in a process of its own, so that it is the first one there.
  if (!survives(e, [&] { run_others(e, Neighbour::none, *expected); })) return;  // other checks tell the crash
  for (const Neighbour neighbour : {Neighbour::beside, Neighbour::before}) {
    const SharedResults found;
    const bool survived = survives(e, [&] { run_others(e, neighbour, *found); });
    const std::size_t common = std::min(expected->count, found->count);
    std::size_t i = 0;
    while (i < common && expected->all[i].result == found->all[i].result) ++i;
    if (i == expected->count && survived) continue;
    Subject subject(e);
    const std::string where = i < expected->count ? subject.syntaxes()[expected->all[i].syntax]->id : "";
    const std::string what = neighbour == Neighbour::beside
                                 ? "beside a chain with other options and other ids of fields"
                                 : "after a chain with other options and other ids of fields was destroyed";
    e.find(where, survived ? "a chain gives another result " + what +
                                 "; a plugin keeps what it needs in *self, never in globals"
                           : "it crashes, does not return, or ends the process " + what);
    return;
  }
}

}  // namespace isogloss::cli
