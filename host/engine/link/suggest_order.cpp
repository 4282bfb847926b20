// An order of the chain that satisfies every syntax and moves as few elements as possible. Two elements that stand the
// wrong way round cannot both keep their places, so the smallest set that has one of each such pair is moved.
#include <algorithm>
#include <bitset>

#include <fmt/format.h>

#include "isogloss/engine/linker.hpp"

namespace isogloss {

namespace {

using Set = std::bitset<longest_chain>;

bool holds(const char* const* list, std::string_view id) {
  for (; list != nullptr && *list != nullptr; ++list)
    if (id == *list) return true;
  return false;
}

/// What makes the first element stand before the second one.
enum class Because : std::uint8_t { nothing, stage, first_declares, second_declares };

class Constraints {
 public:
  Constraints(const Dialect& dialect, const Library& library) : chain_(dialect.chain) {
    for (const ChainElement& e : chain_) syntaxes_.push_back(library.syntax(e.syntax));
  }
  std::size_t size() const { return chain_.size(); }
  Because of(std::size_t a, std::size_t b) const {
    if (chain_[a].syntax == chain_[b].syntax) return Because::nothing;
    if (syntaxes_[a] != nullptr && holds(syntaxes_[a]->before, chain_[b].syntax)) return Because::first_declares;
    if (syntaxes_[b] != nullptr && holds(syntaxes_[b]->after, chain_[a].syntax)) return Because::second_declares;
    return chain_[a].stage < chain_[b].stage ? Because::stage : Because::nothing;
  }

 private:
  const std::vector<ChainElement>& chain_;
  std::vector<const ig_syntax*> syntaxes_;
};

/// Those that must stand straight after each element.
std::vector<Set> straight_after(const Constraints& constraints) {
  std::vector<Set> after(constraints.size());
  for (std::size_t a = 0; a < after.size(); ++a)
    for (std::size_t b = 0; b < after.size(); ++b)
      if (constraints.of(a, b) != Because::nothing) after[a].set(b);
  return after;
}

/// For each element, those that must stand after it, straight or through others. Empty when there is a ring.
std::vector<Set> order_of(const Dialect& dialect, const Library& library) {
  const std::vector<ChainElement>& chain = dialect.chain;
  std::vector<Set> after = straight_after(Constraints(dialect, library));
  for (std::size_t through = 0; through < chain.size(); ++through)
    for (std::size_t a = 0; a < chain.size(); ++a)
      if (after[a][through]) after[a] |= after[through];
  for (std::size_t a = 0; a < chain.size(); ++a)
    if (after[a][a]) return {};
  return after;
}

/// The lightest set that has one of each pair; beyond `most_tries` steps, the lightest one found so far.
class Cover {
 public:
  Cover(std::vector<std::pair<std::size_t, std::size_t>> pairs, std::vector<std::size_t> weights)
      : pairs_(std::move(pairs)), weights_(std::move(weights)) {}

  Set find() {
    // What most pairs have in common is tried first, so that the first set found is a light one already.
    std::vector<std::size_t> degree(weights_.size());
    for (const auto& [a, b] : pairs_) ++degree[a], ++degree[b];
    for (auto& [a, b] : pairs_)
      if (degree[b] * weights_[a] > degree[a] * weights_[b]) std::swap(a, b);
    std::stable_sort(pairs_.begin(), pairs_.end(),
                     [&](const auto& x, const auto& y) { return degree[x.first] > degree[y.first]; });
    add({}, 0, 0);
    return best_;
  }

 private:
  static constexpr std::size_t most_tries = 100'000;

  void add(Set taken, std::size_t weight, std::size_t from) {
    if (weight >= best_weight_ || (++tries_ > most_tries && best_weight_ != SIZE_MAX)) return;
    while (from < pairs_.size() && (taken[pairs_[from].first] || taken[pairs_[from].second])) ++from;
    if (from == pairs_.size()) {
      best_ = taken;
      best_weight_ = weight;
      return;
    }
    for (const std::size_t one : {pairs_[from].first, pairs_[from].second})
      add(Set(taken).set(one), weight + weights_[one], from + 1);
  }

  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
  std::vector<std::size_t> weights_;
  Set best_;
  std::size_t best_weight_ = SIZE_MAX, tries_ = 0;
};

/// Puts each moved element back, as near to its old place as what is there allows.
std::vector<std::size_t> put_back(const std::vector<Set>& after, const Set& moved) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < after.size(); ++i)
    if (!moved[i]) out.push_back(i);
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (!moved[i]) continue;
    std::size_t first = 0, last = out.size(), old = 0;
    for (std::size_t k = 0; k < out.size(); ++k) {
      if (after[out[k]][i]) first = k + 1;
      if (after[i][out[k]]) last = std::min(last, k);
      if (out[k] < i) old = k + 1;
    }
    out.insert(out.begin() + static_cast<std::ptrdiff_t>(std::clamp(old, first, std::max(first, last))), i);
  }
  return out;
}

}  // namespace

namespace {

void load_plugins(const Dialect& dialect, Library& library) {
  DiagnosticList ignored;
  for (const PluginReference& p : dialect.plugins) library.load(p.name, p.where, ignored);
}

/// The elements on the shortest way from one back to it; empty: there is none.
std::vector<std::size_t> way_back(const std::vector<Set>& after, std::size_t begin) {
  std::vector<std::size_t> from(after.size(), SIZE_MAX), reached{begin};
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (std::size_t b = 0; b < after.size(); ++b) {
      if (!after[reached[next]][b] || from[b] != SIZE_MAX) continue;
      from[b] = reached[next];
      if (b != begin) {
        reached.push_back(b);
        continue;
      }
      std::vector<std::size_t> way{begin};
      for (std::size_t at = from[begin]; at != begin; at = from[at]) way.push_back(at);
      std::reverse(way.begin() + 1, way.end());
      return way;
    }
  return {};
}

}  // namespace

std::vector<std::string> order_ring(const Dialect& dialect, Library& library) {
  load_plugins(dialect, library);
  const std::vector<ChainElement>& chain = dialect.chain;
  if (chain.size() > longest_chain) return {};
  const Constraints constraints(dialect, library);
  const std::vector<Set> after = straight_after(constraints);
  std::vector<std::size_t> ring;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (std::vector<std::size_t> way = way_back(after, i); !way.empty() && (ring.empty() || way.size() < ring.size()))
      ring = std::move(way);
  std::vector<std::string> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t a = ring[i], b = ring[(i + 1) % ring.size()];
    const Because because = constraints.of(a, b);
    out.push_back(fmt::format(
        "{} must stand before {}: {}", chain[a].alias, chain[b].alias,
        because == Because::stage
            ? fmt::format("the stage {} comes before {}", to_string(chain[a].stage), to_string(chain[b].stage))
            : fmt::format("{} declares it", chain[because == Because::first_declares ? a : b].syntax)));
  }
  return out;
}

std::vector<std::string> suggest_order(const Dialect& dialect, Library& library) {
  load_plugins(dialect, library);
  const std::vector<ChainElement>& chain = dialect.chain;
  if (chain.size() > longest_chain) return {};
  const std::vector<Set> after = order_of(dialect, library);
  if (after.empty()) return {};
  std::vector<std::pair<std::size_t, std::size_t>> wrong;
  for (std::size_t a = 0; a < chain.size(); ++a)
    for (std::size_t b = a + 1; b < chain.size(); ++b)
      if (after[b][a]) wrong.emplace_back(a, b);
  // An inherited element is moved only where nothing of the dialect's own can be.
  std::vector<std::size_t> weights;
  const std::size_t foreign = 1000;
  for (const ChainElement& e : chain)
    weights.push_back(e.where.file == dialect.file.string() || dialect.ancestors.empty() ? 1 : foreign);
  std::vector<std::string> out;
  for (const std::size_t i : put_back(after, Cover(std::move(wrong), std::move(weights)).find()))
    out.push_back(chain[i].alias);
  return out;
}

}  // namespace isogloss
