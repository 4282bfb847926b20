// Counts what was found, by cause, and keeps the first examples.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "diff/comparison.hpp"
#include "diff/values.hpp"

namespace isogloss::cli::parting {

namespace {

constexpr std::size_t most_examples = 3, most_values = 8;

/// Reports that are alike, by their numbers: a block may have as many as it has bytes.
struct Unanswered {
  std::vector<std::size_t> all;
  std::size_t next = 0;

  /// The first that nothing has answered.
  std::optional<std::size_t> take(std::vector<bool>& answered) {
    while (next < all.size() && answered[all[next]]) ++next;
    if (next == all.size()) return std::nullopt;
    answered[all[next]] = true;
    return all[next];
  }
};

}  // namespace

std::string_view to_string(Group::Kind kind) {
  static constexpr std::string_view names[] = {"Syntax", "Syntaxes",   "InitialState", "Text",
                                               "Blocks", "Diagnostic", "Unknown"};
  return names[static_cast<std::size_t>(kind)];
}

PartedBlock Comparison::block_of(const Snapshot* a, const Snapshot* b) {
  PartedBlock out;
  if (a != nullptr && a->line != 0) {
    out.file_a = a->file;
    out.line_a = a->line;
    out.text_a = a->text;
  }
  if (b != nullptr && b->line != 0) {
    out.file_b = b->file;
    out.line_b = b->line;
    out.text_b = b->text;
  }
  return out;
}

Parting Comparison::parting_of(const Difference& d, const Snapshot* a, const Snapshot* b) const {
  const CommonField& field = map_.fields[d.field];
  Parting out;
  out.field = field.path;
  out.unit = field.unit;
  if (const std::size_t brackets = out.field.find("[]"); d.stroke >= 0 && brackets != std::string::npos)
    out.field.insert(brackets + 1, std::to_string(d.stroke));
  const bool is_boolean = field.type == IG_BOOLEAN;
  if (field.path.ends_with("[]")) {
    out.a = d.a != nullptr ? "there" : "";
    out.b = d.b != nullptr ? "there" : "";
  } else {
    out.a = value_text(d.a, *a, is_boolean);
    out.b = value_text(d.b, *b, is_boolean);
    if (out.a == out.b && d.a != nullptr && d.b != nullptr && d.a->kind == Cell::Kind::number) {
      out.a = number_text(d.a->number, 12);
      out.b = number_text(d.b->number, 12);
    }
  }
  out.writer_a = alias(0, d.writer_a);
  out.writer_b = alias(1, d.writer_b);
  return out;
}

void Comparison::count(int group, const Difference* d, bool is_direct, const Snapshot* a, const Snapshot* b) {
  parts_ = true;
  Group& g = report_.groups[static_cast<std::size_t>(group)];
  const bool is_new = g.last_block != number_;
  if (is_new) ++g.blocks;
  if (g.first_block == 0) g.first_block = number_;
  if (is_direct && g.last_direct_block != number_) ++g.direct_blocks;
  if (is_direct) g.last_direct_block = number_;
  g.last_block = number_;
  if (is_new && g.examples.size() < most_examples) g.examples.push_back(block_of(a, b));
  const bool is_example = !g.examples.empty() && g.blocks <= most_examples;
  if (options_.keeps_all && kept_ != number_) {
    kept_ = number_;
    report_.all.push_back(block_of(a, b));
    report_.all_groups.push_back(static_cast<std::size_t>(group));
  }
  if (d == nullptr) return;
  FieldCount& field = g.fields[map_.fields[d->field].path];
  if (field.last_block != number_) ++field.blocks;
  field.last_block = number_;
  field.is_direct |= is_direct;
  const bool is_probe = is_direct || g.kind == Group::Kind::initial;
  if (is_probe && g.probe.empty() && a != nullptr && b != nullptr && a->line != 0 && b->line != 0) {
    g.probe = map_.fields[d->field].path;
    g.probed = block_of(a, b);
    g.probed_block = number_;
    g.beside = report_of_one_side(*a, *b);
  }
  if (options_.probe.line_a != 0 && a != nullptr && a->line == options_.probe.line_a &&
      a->file == options_.probe.file_a && map_.fields[d->field].path == options_.probe.field)
    report_.is_probe_there = true;
  // What follows is of interest where nothing shows the cause itself.
  const bool is_shown = is_direct || g.examples.empty() || g.examples.back().values.empty();
  if (is_example && is_shown && g.examples.back().values.size() < most_values)
    g.examples.back().values.push_back(parting_of(*d, a, b));
  if (options_.keeps_all) report_.all.back().values.push_back(parting_of(*d, a, b));
}

/// An error or warning that one side alone reports in this block: "DRL-1, which only fanuc reports".
std::string Comparison::report_of_one_side(const Snapshot& a, const Snapshot& b) const {
  const auto has = [](const Snapshot& block, const std::string& code) {
    return std::any_of(block.reported.begin(), block.reported.end(),
                       [&](const Diagnostic& d) { return d.code == code; });
  };
  const Diagnostic* worst = nullptr;
  std::size_t of = 0;
  for (std::size_t side = 0; side < 2; ++side)
    for (const Diagnostic& d : (side == 0 ? a : b).reported)
      if (d.severity != Severity::note && !has(side == 0 ? b : a, d.code) &&
          (worst == nullptr || d.severity > worst->severity)) {
        worst = &d;
        of = side;
      }
  return worst == nullptr ? std::string() : fmt::format("{}, which only {} reports", worst->code, sides_[of]->name);
}

void Comparison::compare_reports(const Snapshot& a, const Snapshot& b) {
  if (a.reported.empty() && b.reported.empty()) return;
  std::vector<bool> answered(b.reported.size());
  std::map<std::pair<std::string_view, std::string_view>, Unanswered> alike;
  std::map<std::string_view, Unanswered> of_code;
  const auto wording = [&](const Diagnostic& d) {
    return options_.are_two_programs ? std::string_view() : std::string_view(d.message);
  };
  for (std::size_t i = 0; i < b.reported.size(); ++i) {
    alike[{b.reported[i].code, wording(b.reported[i])}].all.push_back(i);
    of_code[b.reported[i].code].all.push_back(i);
  }
  for (const Diagnostic& one : a.reported) {
    if (const auto same = alike[{one.code, wording(one)}].take(answered)) {
      if (one.severity == Severity::error) ++errors_of_both_;
      continue;
    }
    const auto other = of_code[one.code].take(answered);
    add_report(0, one, other ? &b.reported[*other] : nullptr, a, b);
  }
  for (std::size_t i = 0; i < b.reported.size(); ++i)
    if (!answered[i]) add_report(1, b.reported[i], nullptr, a, b);
}

/// `other`: what the other side reports with the same code; null: it does not.
void Comparison::add_report(std::size_t side, const Diagnostic& diagnostic, const Diagnostic* other, const Snapshot& a,
                            const Snapshot& b) {
  Group group;
  group.kind = Group::Kind::diagnostic;
  group.cause = other == nullptr ? fmt::format("only {} reports {} ({})", sides_[side]->name, diagnostic.code,
                                               isogloss::to_string(diagnostic.severity))
                                 : fmt::format("{} ({}) with other values", diagnostic.code,
                                               isogloss::to_string(diagnostic.severity));
  const int number =
      group_of(fmt::format("reports{} {}", other == nullptr ? side : 2, diagnostic.code), std::move(group));
  const bool has_a = a.line != 0 || a.is_end, has_b = b.line != 0 || b.is_end;
  count(number, nullptr, true, has_a ? &a : nullptr, has_b ? &b : nullptr);
  Parting said;
  said.field = "diagnostic";
  (side == 0 ? said.a : said.b) = fmt::format("{} [{}]", diagnostic.message, diagnostic.code);
  if (other != nullptr) said.b = fmt::format("{} [{}]", other->message, other->code);
  Group& g = report_.groups[static_cast<std::size_t>(number)];
  if (g.blocks <= most_examples && !g.examples.empty() && g.examples.back().values.size() < most_values) {
    PartedBlock& example = g.examples.back();
    if (example.line_a == 0 && example.line_b == 0) {  // after the last block, or before the first
      (side == 0 ? example.file_a : example.file_b) = diagnostic.where.file;
      (side == 0 ? example.line_a : example.line_b) = diagnostic.where.line;
    }
    example.values.push_back(said);
  }
  if (options_.keeps_all) report_.all.back().values.push_back(std::move(said));
}

void Comparison::add_ends(const Snapshot& a, const Snapshot& b) {
  ++number_;
  parts_ = false;
  compare_reports(a, b);
  if (parts_) ++report_.parted;
}

Report Comparison::finish() {
  // `all` names groups by their number, which sorting changes.
  std::vector<std::size_t> order(report_.groups.size()), place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [this](std::size_t one, std::size_t other) {
    return report_.groups[one].blocks > report_.groups[other].blocks;
  });
  std::vector<Group> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    if (report_.groups[order[i]].blocks > 0) sorted.push_back(std::move(report_.groups[order[i]]));
  }
  report_.groups = std::move(sorted);
  for (std::size_t& group : report_.all_groups) group = place[group];
  return std::move(report_);
}

}  // namespace isogloss::cli::parting
