// From a value that differs to its cause. Differences are looked at in the order of their writers: where a syntax read
// something that differs already, that cause is handed on; otherwise the syntax itself is where both sides part.
#include <fmt/format.h>

#include <algorithm>

#include "diff/comparison.hpp"

namespace isogloss::cli::parting {

namespace {

// How strongly something speaks for being the cause; the strongest wins.
constexpr double same_row_differs = 6, word_differs = 5, same_unit = 4, other_syntax = 3.5, number_differs = 3,
                 name_differs = 2, own_option = 1, term_differs = 0.5;
constexpr std::size_t most_groups = 500;

}  // namespace

void Comparison::find_causes(const Snapshot& a, const Snapshot& b) {
  cause_before_ = cause_;
  own_of_block_.clear();
  for (const std::uint32_t field : open_) cause_[field] = none;
  open_before_.swap(open_);
  open_.clear();
  std::stable_sort(differences_.begin(), differences_.end(), [](const Difference& one, const Difference& other) {
    return one.needs_cause != other.needs_cause ? !one.needs_cause : one.rank < other.rank;
  });
  for (const Difference& d : differences_) {
    bool is_direct = false;
    int cause = d.needs_cause ? none : cause_before_[d.field];
    if (d.needs_cause) cause = a.is_initial ? initial_cause(d, a, b) : cause_of(d, a, b, is_direct);
    if (cause_[d.field] == none) {
      open_.push_back(d.field);
      cause_[d.field] = cause;
      ranks_[d.field] = d.needs_cause ? d.rank : 0;
    }
    if (d.needs_cause && map_.fields[d.field].is_shown && !a.is_initial) count(cause, &d, is_direct, &a, &b);
  }
}

int Comparison::cause_of(const Difference& d, const Snapshot& a, const Snapshot& b, bool& is_direct) {
  const Input input = best_input(d);
  // Nothing of its own can outweigh this: the usual case where everything follows from one difference.
  if (input.cause != none && input.weight > same_row_differs) return input.cause;
  const Own own = own_cause(d, a, b);
  is_direct = input.cause == none || own.weight > input.weight;
  return is_direct ? own.group : input.cause;
}

/// The strongest of the differing fields that the writers have read.
Comparison::Input Comparison::best_input(const Difference& d) const {
  Input best;
  const auto consider = [&](std::uint32_t field, int cause) {
    const double weight = weight_of_input(field, d);
    if (cause != none && weight > best.weight) best = {cause, weight};
  };
  const auto is_read = [&](const std::array<std::vector<std::vector<bool>>, 2>& reads, std::uint32_t field) {
    return (d.writer_a != 0 && reads[0][d.writer_a - 1u][field]) ||
           (d.writer_b != 0 && reads[1][d.writer_b - 1u][field]);
  };
  for (const std::uint32_t field : open_)
    if (field != d.field && ranks_[field] < d.rank && is_read(map_.reads, field)) consider(field, cause_[field]);
  for (const std::uint32_t field : open_before_)
    if (is_read(map_.reads_before, field)) consider(field, cause_before_[field]);
  // The field itself, as it was before: a syntax adds to it, or keeps it.
  if (cause_before_[d.field] != none && is_read(map_.reads, d.field)) consider(d.field, cause_before_[d.field]);
  return best;
}

double Comparison::weight_of_input(std::uint32_t field, const Difference& d) const {
  const CommonField &input = map_.fields[field], &output = map_.fields[d.field];
  if (input.is_read) return word_differs;
  if (input.type == IG_SYMBOL || input.type == IG_TEXT)
    return input.path.ends_with(".Term") ? term_differs : name_differs;
  return input.type == IG_NUMBER && !input.unit.empty() && input.unit == output.unit ? same_unit : number_differs;
}

std::string Comparison::alias(std::size_t side, std::uint16_t writer) const {
  return writer == 0 ? std::string() : sides_[side]->linked->chain[writer - 1u].element.alias;
}

/// The syntax that makes the difference, as the two sides have it. Where two syntaxes have written that both sides
/// have, the later one has changed what the earlier one wrote, on one side alone.
void Comparison::find_acting(std::uint16_t& one, std::uint16_t& other) const {
  const std::uint16_t of_one = evidence_.counterpart(0, one), of_other = evidence_.counterpart(1, other);
  if (one == 0 || other == 0 || (of_one != 0 && of_other != 0)) {
    const bool is_one = other == 0 || (one != 0 && one > of_other);
    (is_one ? other : one) = is_one ? of_one : of_other;
    return;
  }
  // A syntax that one side alone has, behind one that both have.
  if (of_one != 0 && other > of_one) one = 0;
  if (of_other != 0 && one > of_other) other = 0;
}

/// What the writers themselves have that may make them differ.
Comparison::Own Comparison::own_cause(const Difference& d, const Snapshot& a, const Snapshot& b) {
  const std::string& path = map_.fields[d.field].path;
  std::uint16_t one = d.writer_a, other = d.writer_b;
  const auto is_scanner = [this](std::size_t side, std::uint16_t writer) {
    return writer != 0 && writer <= sides_[side]->linked->first_build;
  };
  Group group;
  if (texts_differ_ && (map_.fields[d.field].is_read || is_scanner(0, one) || is_scanner(1, other))) {
    group.kind = Group::Kind::text;
    group.cause = fmt::format("the text of the programs: {}", path);
    return {group_of("text " + path, std::move(group)), same_row_differs};
  }
  if (one == 0 && other == 0) {
    one = last_writer(0, d.field, a);
    other = last_writer(1, d.field, b);
  }
  const std::uint64_t writers = std::uint64_t{one} << 16 | other;
  if (const auto known = own_of_block_.find(writers); known != own_of_block_.end() && writers != 0)
    return known->second;
  Own own;
  find_acting(one, other);
  group.syntax_a = alias(0, one);
  group.syntax_b = alias(1, other);
  const bool is_same = one != 0 && evidence_.counterpart(0, one) == other;
  if (one == 0 && other == 0) {
    group.cause = fmt::format("not found: no syntax that was called writes {}", path);
  } else if (!is_same) {
    group.kind = Group::Kind::syntaxes;
    group.cause = one == 0     ? fmt::format("{}, which only {} has", group.syntax_b, sides_[1]->name)
                  : other == 0 ? fmt::format("{}, which only {} has", group.syntax_a, sides_[0]->name)
                               : fmt::format("{} against {}", group.syntax_a, group.syntax_b);
    own.weight = other_syntax;
  } else {
    group.evidence = evidence_.find(one, other, a, b);
    for (const Evidence& e : group.evidence) {
      const bool is_first = group.cause.empty();
      if (!is_first && !e.is_sure) continue;
      group.cause += (is_first ? "" : "; ") + text_of(e);
      own.weight = std::max(own.weight, e.is_sure && e.kind == Evidence::Kind::row ? same_row_differs : own_option);
    }
    group.kind = group.evidence.empty() ? Group::Kind::unknown : Group::Kind::syntax;
    if (group.evidence.empty() && texts_differ_) {
      group.kind = Group::Kind::text;
      group.cause = "the text of the programs";
    } else if (group.evidence.empty() && (d.writer_a == 0 || d.writer_b == 0)) {
      group.cause = fmt::format("not found: {} acts in {} alone, with the same options on both sides", group.syntax_a,
                                sides_[d.writer_a == 0 ? 1 : 0]->name);
    } else if (group.evidence.empty()) {
      group.cause =
          fmt::format("not found: {} has the same options on both sides; a table, or what it kept from earlier blocks",
                      group.syntax_a);
    }
  }
  const std::string key = fmt::format("{} {} {}", group.syntax_a, group.syntax_b, group.cause);
  own.group = group_of(key, std::move(group));
  note_codes(report_.groups[static_cast<std::size_t>(own.group)], d, a, b);
  own_of_block_[writers] = own;
  return own;
}

/// The dialects' initial states differ: no difference by itself, but the cause of those that follow from it.
int Comparison::initial_cause(const Difference& d, const Snapshot& a, const Snapshot& b) {
  const Parting values = parting_of(d, &a, &b);
  const auto text = [](const std::string& value) { return value.empty() ? std::string("nothing") : value; };
  Group group;
  group.kind = Group::Kind::initial;
  group.initial = values.field;
  group.cause = fmt::format("before the first block: {} = {} against {}", values.field, text(values.a), text(values.b));
  group.syntax_a = values.writer_a;
  group.syntax_b = values.writer_b;
  if (const std::uint16_t one = d.writer_a; one != 0 && evidence_.counterpart(0, one) != 0)
    group.evidence = evidence_.find(one, evidence_.counterpart(0, one), a, b);
  return group_of("initial " + values.field, std::move(group));
}

int Comparison::group_of(const std::string& key, Group group) {
  const auto [found, is_new] = groups_.try_emplace(key, static_cast<int>(report_.groups.size()));
  if (!is_new) return found->second;
  if (report_.groups.size() > most_groups) {
    groups_.erase(found);
    return static_cast<int>(most_groups);
  }
  if (report_.groups.size() == most_groups) {
    groups_.erase(found);
    report_.has_more_causes = true;
    group = {};
    group.cause = "further causes";
    report_.groups.push_back(std::move(group));
    return static_cast<int>(most_groups);
  }
  report_.groups.push_back(std::move(group));
  return found->second;
}

/// The codes of the block that the writers answer: "G83".
void Comparison::note_codes(Group& group, const Difference& d, const Snapshot& a, const Snapshot& b) const {
  constexpr std::size_t most = 4;
  const auto note = [&](std::size_t side, std::uint16_t writer, const Snapshot& block) {
    for (const Cell& cell : block.cells) {
      if (group.codes.size() >= most || writer == 0) return;
      if (cell.kind != Cell::Kind::code || !map_.takes[side][writer - 1u][cell.field]) continue;
      const std::string name(Layout::code_name(map_.fields[cell.field].path));
      if (std::find(group.codes.begin(), group.codes.end(), name) == group.codes.end()) group.codes.push_back(name);
    }
  };
  note(0, d.writer_a, a);
  note(1, d.writer_b, b);
}

}  // namespace isogloss::cli::parting
