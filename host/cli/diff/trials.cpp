#include "diff/trials.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace isogloss::cli::parting {

namespace {

constexpr std::size_t most_trials = 40;
constexpr std::uint64_t most_blocks = 20'000;  // up to the example

class Trials {
 public:
  Trials(const RunOfSide& a, const RunOfSide& b, const LineOrder* order, const std::vector<std::string>& ignored,
         Session& session)
      : a_(a), b_(b), order_(order), ignored_(ignored), session_(session) {}

  void try_group(Group& group) {
    std::vector<Evidence*> suspects;
    for (Evidence& e : group.evidence)
      if (e.can_be_tried()) suspects.push_back(&e);
    const bool has_choice = group.evidence.size() > 1 && trials_ + suspects.size() + 2 <= most_trials;
    if (group.kind != Group::Kind::syntax || suspects.empty() || !has_choice || group.probe.empty() ||
        group.first_block > most_blocks || group.examples.empty() || group.examples.front().line_a == 0 ||
        group.examples.front().line_b == 0)
      return;
    group_ = &group;
    if (!is_there({})) return;  // not in the first pass over the line
    if (is_there(suspects)) {
      for (Evidence* e : suspects) e->trial = Evidence::Trial::no_cause;
    } else {
      std::vector<Evidence*> causes;
      for (Evidence* e : suspects)
        if (suspects.size() > 1 && !is_there({e})) causes.push_back(e);
      if (causes.empty()) causes = suspects;  // none of them alone
      for (Evidence* e : suspects) e->trial = Evidence::Trial::no_cause;
      for (Evidence* e : causes) e->trial = Evidence::Trial::cause;
    }
    name_cause(group);
  }

 private:
  /// Does the first example differ when side B has these options and rows of side A?
  bool is_there(const std::vector<Evidence*>& suspects) {
    ++trials_;
    Dialect dialect = b_.side.linked->dialect;
    for (ChainElement& element : dialect.chain)
      if (element.alias == group_->syntax_b)
        for (const Evidence* e : suspects) {
          if (e->kind != Evidence::Kind::option) continue;
          std::erase_if(element.options, [e](const Attribute& given) { return given.name == e->option; });
          element.options.push_back({e->option, e->raw_a, {}});
        }
    DiagnosticList unheard;
    const std::unique_ptr<LinkedDialect> linked = link(dialect, session_.library(), unheard);
    if (linked == nullptr) return true;
    const PartedBlock& example = group_->examples.front();
    RunOfSide one = a_, other = b_;
    other.side.linked = linked.get();
    for (const Evidence* e : suspects)
      for (const auto& cell : e->as_a) other.options.chain.assignments.push_back(cell);
    stop_at(one, example.file_a, example.line_a);
    stop_at(other, example.file_b, example.line_b);
    const ComparisonOptions how{order_ != nullptr, false, {example.file_a, group_->probe, example.line_a}};
    return compare_blocks(one, other, order_, ignored_, how, session_).report.is_probe_there;
  }

  static void stop_at(RunOfSide& side, const std::string& file, std::uint32_t line) {
    side.options.stop_after_line = line;
    side.options.stop_in_file = file == side.program->path() ? std::string() : file;
  }

  static void name_cause(Group& group) {
    std::stable_sort(group.evidence.begin(), group.evidence.end(), [](const Evidence& one, const Evidence& other) {
      const auto rank = [](const Evidence& e) {
        return e.trial == Evidence::Trial::cause ? 0 : e.trial == Evidence::Trial::none ? (e.is_sure ? 1 : 2) : 3;
      };
      return rank(one) < rank(other);
    });
    const Evidence& first = group.evidence.front();
    if (first.trial == Evidence::Trial::no_cause) {
      group.kind = Group::Kind::unknown;
      group.cause = fmt::format(
          "{}: nothing of what was tried alone; another table, or what it kept from earlier blocks", group.syntax_a);
      return;
    }
    group.cause.clear();
    for (const Evidence& e : group.evidence)
      if (e.trial == first.trial && (e.is_sure || &e == &first))
        group.cause += (group.cause.empty() ? "" : "; ") + text_of(e);
  }

  const RunOfSide &a_, &b_;
  const LineOrder* const order_;
  const std::vector<std::string>& ignored_;
  Session& session_;
  Group* group_ = nullptr;
  std::size_t trials_ = 0;
};

}  // namespace

void try_causes(Report& report, const RunOfSide& a, const RunOfSide& b, const LineOrder* order,
                const std::vector<std::string>& ignored, Session& session) {
  Trials trials(a, b, order, ignored, session);
  for (Group& group : report.groups) trials.try_group(group);
}

}  // namespace isogloss::cli::parting
