#include "diff/trials.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diff/first_parting.hpp"

namespace isogloss::cli::parting {

namespace {

constexpr std::string_view not_found = "not found: ";  // begins the headings of such causes
constexpr std::size_t most_trials = 200;
constexpr std::uint64_t most_blocks = 20'000;            // up to the block that is looked at
constexpr std::uint64_t most_blocks_of_all = 1'000'000;  // of all trials of a comparison

std::string list_of(const std::vector<Evidence*>& all) {
  std::string out;
  for (const Evidence* const e : all) out += (out.empty() ? "" : "; ") + text_of(*e);
  return out;
}

class Trials {
 public:
  Trials(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, const std::vector<std::string>& ignored,
         Session& session)
      : a_(a), b_(b), order_(order), ignored_(ignored), session_(session) {}

  void try_group(Group& group) {
    group_ = &group;
    using Kind = Group::Kind;
    if (group.kind == Kind::syntax) try_evidence(group);
    if (group.kind == Kind::unknown) return look_closer(group);
    if (group.kind != Kind::syntaxes && group.kind != Kind::initial) return;
    const std::optional<Dialect> changed = group.kind == Kind::syntaxes ? with_syntax_of_a() : with_initial_of_a();
    const Answer answer = changed && can_run(1) && is_repeatable() ? ask(*changed, {}) : Answer::none;
    if (answer == Answer::same) group.trial = Evidence::Trial::cause;
    if (answer == Answer::none) return say_not_tried(group);
    if (answer != Answer::differs) return;
    group.trial = Evidence::Trial::no_cause;
    say_not_found(group, group.cause + " is not: with it on both sides the block differs as before");
    look_closer(group);
  }

 private:
  /// Of a run in which side B has something of side A: the field is the same, or differs; or there is no such run.
  enum class Answer : std::uint8_t { none, same, differs };

  void try_evidence(Group& group) {
    std::vector<Evidence*> suspects;
    for (Evidence& e : group.evidence)
      if (e.can_be_tried()) suspects.push_back(&e);
    if (suspects.empty() || !can_run(2 * suspects.size() + 2) || !is_repeatable()) return say_not_tried(group);
    std::vector<Evidence*> causes;
    std::size_t answers = 0;
    for (Evidence* const e : suspects) {
      const Answer answer = ask({e});
      answers += answer == Answer::none ? 0 : 1;
      if (answer == Answer::same) causes.push_back(e);
      if (answer == Answer::differs) e->trial = Evidence::Trial::no_cause;
    }
    if (causes.empty() && suspects.size() > 1 && ask(suspects) == Answer::same) {
      causes = fewest(suspects);
      group.acts_together = true;
    }
    for (Evidence* const e : causes) e->trial = Evidence::Trial::cause;
    if (causes.empty() && answers == 0) return say_not_tried(group);
    if (causes.empty()) return say_not_found(group, group.syntax_a + " differs, and nothing of what was tried alone");
    const std::string names = list_of(causes);
    group.cause = group.acts_together ? "only together: " + names : names;
    std::stable_sort(group.evidence.begin(), group.evidence.end(), [](const Evidence& one, const Evidence& other) {
      return (one.trial == Evidence::Trial::cause) > (other.trial == Evidence::Trial::cause);
    });
  }

  /// Those without which the others do not do.
  std::vector<Evidence*> fewest(std::vector<Evidence*> all) {
    for (std::size_t i = all.size(); i-- > 0 && all.size() > 1;) {
      std::vector<Evidence*> fewer = all;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (ask(fewer) == Answer::same) all = std::move(fewer);
    }
    return all;
  }

  /// The syntax by which both sides part first in the block: its options are tried, or the syntax itself where one side
  /// alone has it. What is no cause is named.
  void look_closer(Group& group) {
    if (!group.cause.starts_with(not_found) || !can_run(4)) return;
    blocks_ += 2 * group.probed_block;
    const std::optional<FirstParting> first = find_first_parting(a_, b_, group.probed, session_);
    if (!first) return;
    const std::string& name = first->syntax_a.empty() ? first->syntax_b : first->syntax_a;
    if (name == group.syntax_a && name == group.syntax_b) return;
    Group closer = group;
    closer.syntax_a = first->syntax_a;
    closer.syntax_b = first->syntax_b;
    closer.evidence.clear();
    closer.beside.clear();
    group_ = &closer;
    const bool is_cause = first->syntax_a.empty() != first->syntax_b.empty() ? is_syntax_the_cause(closer, *first)
                                                                             : is_option_the_cause(closer);
    group_ = &group;
    if (is_cause)
      group = std::move(closer);
    else
      group.cause +=
          fmt::format("; both sides part first at {}: {} {} against {}", name, first->path, first->a, first->b);
  }

  bool is_syntax_the_cause(Group& group, const FirstParting& first) {
    const std::optional<Dialect> changed = with_syntax_of_a();
    if (!changed || !is_repeatable() || ask(*changed, {}) != Answer::same) return false;
    const bool is_of_a = first.syntax_b.empty();
    group.kind = Group::Kind::syntaxes;
    group.trial = Evidence::Trial::cause;
    group.cause =
        fmt::format("{}, which only {} has", is_of_a ? first.syntax_a : first.syntax_b, (is_of_a ? a_ : b_).side.name);
    return true;
  }

  bool is_option_the_cause(Group& group) {
    const auto position = [](const RunOfSide& side, const std::string& alias) {
      const std::vector<LinkedSyntax>& chain = side.side.linked->chain;
      const auto found =
          std::find_if(chain.begin(), chain.end(), [&](const auto& s) { return s.element.alias == alias; });
      return static_cast<std::uint16_t>(found - chain.begin() + 1);
    };
    const Snapshot no_rows;
    group.evidence = EvidenceFinder(a_.side, b_.side)
                         .find(position(a_, group.syntax_a), position(b_, group.syntax_b), no_rows, no_rows);
    group.kind = Group::Kind::syntax;
    if (!group.evidence.empty()) try_evidence(group);
    return std::any_of(group.evidence.begin(), group.evidence.end(),
                       [](const Evidence& e) { return e.trial == Evidence::Trial::cause; });
  }

  static void say_not_tried(Group& group) {
    if (group.kind == Group::Kind::syntax || group.kind == Group::Kind::syntaxes || group.kind == Group::Kind::initial)
      group.cause = "not tried, perhaps " + group.cause;
  }
  static void say_not_found(Group& group, const std::string& why) {
    group.kind = Group::Kind::unknown;
    group.cause = std::string(not_found) + (group.beside.empty() ? why : group.beside + ", in the same block; " + why);
  }

  bool can_run(std::size_t trials) const {
    return trials_ + trials <= most_trials && !group_->probe.empty() && group_->probed_block <= most_blocks &&
           blocks_ + trials * group_->probed_block <= most_blocks_of_all;
  }
  /// False where the difference is not in the first pass over its line.
  bool is_repeatable() { return ask(b_.side.linked->dialect, {}) == Answer::differs; }

  Answer ask(const std::vector<Evidence*>& suspects) {
    Dialect dialect = b_.side.linked->dialect;
    for (ChainElement& element : dialect.chain)
      if (element.alias == group_->syntax_b)
        for (const Evidence* e : suspects) {
          if (e->kind != Evidence::Kind::option) continue;
          std::erase_if(element.options, [e](const Attribute& given) { return given.name == e->option; });
          element.options.push_back({e->option, e->raw_a, {}});
        }
    return ask(dialect, suspects);
  }

  /// Runs both sides as far as the block, side B with this dialect and with these rows of side A.
  Answer ask(const Dialect& dialect, const std::vector<Evidence*>& suspects) {
    ++trials_;
    blocks_ += group_->probed_block;
    DiagnosticList unheard;
    const std::unique_ptr<LinkedDialect> linked = link(dialect, session_.library(), unheard);
    if (linked == nullptr) return Answer::none;
    const PartedBlock& block = group_->probed;
    RunOfSide one = a_, other = b_;
    other.side.linked = linked.get();
    for (const Evidence* e : suspects)
      for (const auto& cell : e->as_a) other.options.chain.assignments.push_back(cell);
    stop_at(one, block.file_a, block.line_a);
    stop_at(other, block.file_b, block.line_b);
    const ComparisonOptions how{order_ != nullptr, false, {block.file_a, group_->probe, block.line_a}};
    const BlockResult result = compare_blocks(one, other, order_, ignored_, how, session_);
    if (!result.report.is_probed || !result.faults[1].empty()) return Answer::none;
    return result.report.is_probe_there ? Answer::differs : Answer::same;
  }

  static void stop_at(RunOfSide& side, const std::string& file, std::uint32_t line) {
    side.options.stop_after_line = line;
    side.options.stop_in_file = file == side.program->path() ? std::string() : file;
  }

  static std::vector<ChainElement>::iterator find(std::vector<ChainElement>& chain, const std::string& alias) {
    return std::find_if(chain.begin(), chain.end(), [&](const ChainElement& e) { return e.alias == alias; });
  }

  /// Side B's dialect with the syntax of side A in place of its own; empty where that cannot be.
  std::optional<Dialect> with_syntax_of_a() const {
    Dialect out = b_.side.linked->dialect;
    const Dialect& a = a_.side.linked->dialect;
    if (const auto own = find(out.chain, group_->syntax_b); own != out.chain.end()) out.chain.erase(own);
    const auto wanted = std::find_if(a.chain.begin(), a.chain.end(),
                                     [&](const ChainElement& e) { return e.alias == group_->syntax_a; });
    if (wanted == a.chain.end()) return out;
    if (find(out.chain, wanted->alias) != out.chain.end()) return std::nullopt;
    // Behind the nearest one before it that both have, or at the begin of its stage.
    auto place = std::find_if(out.chain.begin(), out.chain.end(),
                              [&](const ChainElement& e) { return e.stage >= wanted->stage; });
    for (auto before = wanted; before != a.chain.begin();) {
      --before;
      const auto same = find(out.chain, before->alias);
      if (same == out.chain.end() || before->stage != wanted->stage || same->stage != wanted->stage) continue;
      place = same + 1;
      break;
    }
    out.chain.insert(place, *wanted);
    for (const PluginReference& p : a.plugins)
      if (std::none_of(out.plugins.begin(), out.plugins.end(), [&](const auto& own) { return own.name == p.name; }))
        out.plugins.push_back(p);
    return out;
  }

  /// Side B's dialect with the value of side A before the first block; empty where no dialect gives it.
  std::optional<Dialect> with_initial_of_a() const {
    Dialect out = b_.side.linked->dialect;
    const Dialect& a = a_.side.linked->dialect;
    const auto is_it = [&](const auto& field) { return field.path == group_->initial; };
    const auto given = std::find_if(a.initial.begin(), a.initial.end(), is_it);
    const bool is_own = std::any_of(out.initial.begin(), out.initial.end(), is_it);
    if (given == a.initial.end() && !is_own) return std::nullopt;
    std::erase_if(out.initial, is_it);
    if (given != a.initial.end()) out.initial.push_back(*given);
    return out;
  }

  const RunOfSide &a_, &b_;
  const LineOrder* const order_;
  const std::vector<std::string>& ignored_;
  Session& session_;
  Group* group_ = nullptr;
  std::size_t trials_ = 0;
  std::uint64_t blocks_ = 0;
};

}  // namespace

void try_causes(Report& report, const RunOfSide& a, const RunOfSide& b, const LineOrder* order,
                const std::vector<std::string>& ignored, Session& session) {
  Trials trials(a, b, order, ignored, session);
  for (Group& group : report.groups) trials.try_group(group);
}

}  // namespace isogloss::cli::parting
