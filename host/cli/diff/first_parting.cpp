#include "diff/first_parting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "asked_reports.hpp"
#include "isogloss/engine/explain.hpp"

namespace isogloss::cli::parting {

namespace {

/// One value that a syntax has given a path, and how far in the chain: 0 to 1.
struct Act {
  std::string syntax, value;
  double rank = 0;
};
/// What a side does in the block.
struct Acts {
  std::map<std::string, std::vector<Act>> by_path;
  std::map<std::string, std::string> answers;  ///< of a code, the syntax that uses it; empty: none does
};

bool are_same(const std::string& one, const std::string& other) {
  if (one == other) return true;
  const auto a = nlohmann::json::parse(one, nullptr, false), b = nlohmann::json::parse(other, nullptr, false);
  if (!a.is_number() || !b.is_number()) return false;
  const double x = a.get<double>(), y = b.get<double>();
  return std::abs(x - y) <= 1e-9 * std::max({1.0, std::abs(x), std::abs(y)});
}

std::optional<Acts> acts_of(const RunOfSide& side, const std::string& file, std::uint32_t line, Session& session) {
  const std::unique_ptr<Source> source = side.program->source(session);
  if (source == nullptr || line == 0) return std::nullopt;
  ExplainTarget target;
  target.line = line;
  target.file = file == side.program->path() ? std::string() : file;
  target.most_blocks = 1;
  constexpr std::uint64_t most_blocks = 100'000;  // a side that has not come there by then goes another way
  RunOptions options = side.options;
  options.progress = {};
  options.maximum_blocks = most_blocks;
  Unheard unheard;
  const std::vector<ExplainedBlock> blocks =
      explain(*side.side.linked, *source, side.program->path(), target, options, unheard);
  if (blocks.empty()) return std::nullopt;
  Acts out;
  for (const ExplainedWord& w : blocks.front().words)
    if (!w.name.empty() && w.value.empty()) out.answers[w.name] = w.users.empty() ? "" : w.users.back();
  const std::vector<ExplainedStep>& steps = blocks.front().steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    for (const ExplainedChange& c : steps[i].changes)
      if (!c.path.starts_with("Source."))
        out.by_path[c.path].push_back(
            {steps[i].syntax, c.after, static_cast<double>(i) / static_cast<double>(steps.size())});
  return out;
}

bool has_syntax(const RunOfSide& side, const std::string& alias) {
  const std::vector<LinkedSyntax>& chain = side.side.linked->chain;
  return std::any_of(chain.begin(), chain.end(), [&](const LinkedSyntax& s) { return s.element.alias == alias; });
}

/// A code that one side alone uses; the other one may not even know it.
std::optional<FirstParting> code_of_one_side(const Acts& a, const Acts& b) {
  const auto user = [](const Acts& side, const std::string& code) {
    const auto found = side.answers.find(code);
    return found == side.answers.end() ? std::string() : found->second;
  };
  for (const Acts* const side : {&a, &b})
    for (const auto& [code, unused] : side->answers) {
      const std::string in_a = user(a, code), in_b = user(b, code);
      if (in_a.empty() != in_b.empty())
        return FirstParting{in_a, in_b, code, in_a.empty() ? "unused" : "used", in_b.empty() ? "unused" : "used"};
    }
  return std::nullopt;
}

std::string shown(const std::string& json) {
  if (json.empty()) return "nothing";
  const auto value = nlohmann::json::parse(json, nullptr, false);
  return value.is_number() ? fmt::format("{:.10g}", value.get<double>()) : json;
}

/// What the k-th acts on a path tell; null: that side has given the path fewer values.
FirstParting parting_of(const std::string& path, const Act* one, const Act* other, const RunOfSide& a,
                        const RunOfSide& b) {
  FirstParting out{{}, {}, path, shown(one != nullptr ? one->value : ""), shown(other != nullptr ? other->value : "")};
  const bool is_same = one != nullptr && other != nullptr && one->syntax == other->syntax;
  // Where both have acted, the one that the other side lacks is what makes the difference, else the earlier one.
  const bool one_is_alone = one != nullptr && !has_syntax(b, one->syntax),
             other_is_alone = other != nullptr && !has_syntax(a, other->syntax);
  const bool acts_in_a = is_same || other == nullptr ||
                         (one != nullptr && (one_is_alone != other_is_alone ? one_is_alone : one->rank <= other->rank));
  const std::string& acting = acts_in_a ? one->syntax : other->syntax;
  if (has_syntax(a, acting)) out.syntax_a = acting;
  if (has_syntax(b, acting)) out.syntax_b = acting;
  return out;
}

}  // namespace

std::optional<FirstParting> find_first_parting(const RunOfSide& a, const RunOfSide& b, const PartedBlock& block,
                                               Session& session) {
  const std::optional<Acts> of_a = acts_of(a, block.file_a, block.line_a, session),
                            of_b = acts_of(b, block.file_b, block.line_b, session);
  if (!of_a || !of_b) return std::nullopt;
  if (auto code = code_of_one_side(*of_a, *of_b)) return code;
  std::optional<FirstParting> out;
  double first = 2;
  const auto look = [&](const std::string& path) {
    static const std::vector<Act> none;
    const auto in_a = of_a->by_path.find(path), in_b = of_b->by_path.find(path);
    const std::vector<Act>& one = in_a != of_a->by_path.end() ? in_a->second : none;
    const std::vector<Act>& other = in_b != of_b->by_path.end() ? in_b->second : none;
    for (std::size_t k = 0; k < std::max(one.size(), other.size()); ++k) {
      const Act *const x = k < one.size() ? &one[k] : nullptr, *const y = k < other.size() ? &other[k] : nullptr;
      if (x != nullptr && y != nullptr && x->syntax == y->syntax && are_same(x->value, y->value)) continue;
      const double rank = std::min(x != nullptr ? x->rank : 1, y != nullptr ? y->rank : 1);
      if (rank < first) first = rank, out = parting_of(path, x, y, a, b);
      return;
    }
  };
  for (const auto& [path, acts] : of_a->by_path) look(path);
  for (const auto& [path, acts] : of_b->by_path) look(path);
  if (out && out->syntax_a.empty() && out->syntax_b.empty()) return std::nullopt;  // the host's own work
  return out;
}

}  // namespace isogloss::cli::parting
