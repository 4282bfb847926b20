#include "diff/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace isogloss::cli::parting {

namespace {

std::string place_text(const Location& where) {
  return where.file.empty() ? std::string() : fmt::format("{}:{}", where.file, where.line);
}

}  // namespace

EvidenceFinder::EvidenceFinder(const SideOf& a, const SideOf& b) : sides_{&a, &b} {}

void EvidenceFinder::set_rows_at_start(int side, const std::vector<AskedRow>& rows) { at_start_[side] = rows; }

std::uint16_t EvidenceFinder::counterpart(int side, std::uint16_t position) const {
  if (position == 0) return 0;
  const LinkedSyntax& s = sides_[side]->linked->chain[position - 1u];
  const std::vector<LinkedSyntax>& others = sides_[1 - side]->linked->chain;
  for (std::size_t i = 0; i < others.size(); ++i)
    if (others[i].element.alias == s.element.alias && others[i].element.syntax == s.element.syntax)
      return static_cast<std::uint16_t>(i + 1);
  return 0;
}

std::vector<EvidenceFinder::Row> EvidenceFinder::rows_of(int side, std::uint16_t position,
                                                         const Snapshot& block) const {
  std::vector<Row> out;
  for (const std::vector<AskedRow>* rows : {&block.rows, &at_start_[side]})
    for (const AskedRow& r : *rows) {
      const auto is_it = [&r](const Row& row) { return row.dependency == r.dependency && row.row == r.row; };
      if (r.syntax == position && std::none_of(out.begin(), out.end(), is_it))
        out.push_back({r.dependency, r.row, r.text});
    }
  return out;
}

std::string EvidenceFinder::place_of(int side, const Row& row) const {
  const LinkedDependency& d = dependency(side, row.dependency);
  for (const auto& [path, value] : sides_[side]->assignments) {
    const std::string cell = d.element.alias + "." + row.row;
    if (path == cell || path.starts_with(cell + ".")) return "--set";
  }
  Location out;
  const auto look = [&](const DependencyElement& element) {
    for (const TableRow& one : element.rows)
      for (const Attribute& cell : one.attributes)
        if (d.dependency->row_key != nullptr && cell.name == d.dependency->row_key && cell.value == row.row)
          out = one.where;
  };
  look(d.element);
  for (const DependencyElement& given : sides_[side]->given)
    if (given.alias == d.element.alias) look(given);
  return place_text(out);
}

/// The cells of row B that would have to change, and the values that they need; empty where that cannot be said.
std::vector<std::pair<std::string, std::string>> EvidenceFinder::cells_as_a(const Row& a, const Row& b) const {
  std::vector<std::pair<std::string, std::string>> out;
  const std::string &alias_a = dependency(0, a.dependency).element.alias,
                    &alias_b = dependency(1, b.dependency).element.alias;
  const auto path = [&](const RowCell& cell) { return alias_b + "." + b.row + "." + cell.column; };
  if (alias_a == alias_b && a.row == b.row) {
    for (const RowCell& cell : a.text->cells) out.emplace_back(path(cell), cell.given);
    return out;
  }
  // Another table: one value each, of the same meaning and unit.
  if (a.text->title != b.text->title || a.text->title.empty()) return out;
  if (a.text->cells.size() != 1 || b.text->cells.size() != 1) return out;
  const RowCell &from = a.text->cells[0], &to = b.text->cells[0];
  if (from.unit != to.unit || from.unit.empty()) return out;
  out.emplace_back(path(to), fmt::format("{:.12g}", std::stod(from.given) * from.scale / to.scale));
  return out;
}

Evidence EvidenceFinder::row_evidence(const Row* a, const Row* b) const {
  Evidence out;
  out.kind = Evidence::Kind::row;
  if (a != nullptr) {
    out.name_a = a->text->name;
    out.a = a->text->value;
    out.place_a = place_of(0, *a);
  }
  if (b != nullptr) {
    out.name_b = b->text->name;
    out.b = b->text->value;
    out.place_b = place_of(1, *b);
  }
  if (a == nullptr || b == nullptr) {
    out.title = (a != nullptr ? a : b)->text->title;
    return out;
  }
  if (a->text->title == b->text->title) out.title = a->text->title;
  const bool is_same_row =
      a->row == b->row && dependency(0, a->dependency).element.alias == dependency(1, b->dependency).element.alias;
  out.is_sure = is_same_row || !out.title.empty();
  out.as_a = cells_as_a(*a, *b);
  return out;
}

void EvidenceFinder::add_rows(std::uint16_t a, std::uint16_t b, const Snapshot& block_a, const Snapshot& block_b,
                              std::vector<Evidence>& out) const {
  const std::vector<Row> rows_a = a == 0 ? std::vector<Row>{} : rows_of(0, a, block_a);
  const std::vector<Row> rows_b = b == 0 ? std::vector<Row>{} : rows_of(1, b, block_b);
  const auto alias = [this](int side, const Row& row) { return dependency(side, row.dependency).element.alias; };
  std::vector<const Row*> only_a, only_b;
  for (const Row& r : rows_a) only_a.push_back(&r);
  for (const Row& r : rows_b) only_b.push_back(&r);
  /// Pairs rows of both sides, and takes them off the lists.
  const auto pair_by = [&](const auto& belong_together) {
    for (const Row*& one : only_a) {
      const auto found = std::find_if(only_b.begin(), only_b.end(), [&](const Row* other) {
        return other != nullptr && one != nullptr && belong_together(*one, *other);
      });
      if (found == only_b.end()) continue;
      if ((*found)->text->value != one->text->value) out.push_back(row_evidence(one, *found));
      only_b.erase(found);
      one = nullptr;
    }
    std::erase(only_a, nullptr);
  };
  pair_by([&](const Row& one, const Row& other) { return other.row == one.row && alias(1, other) == alias(0, one); });
  pair_by([](const Row& one, const Row& other) {
    return !one.text->title.empty() && one.text->title == other.text->title;
  });
  // Other tables answer: their rows in the order in which they were asked.
  for (std::size_t i = 0; i < std::max(only_a.size(), only_b.size()); ++i)
    out.push_back(row_evidence(i < only_a.size() ? only_a[i] : nullptr, i < only_b.size() ? only_b[i] : nullptr));
}

void EvidenceFinder::add_options(std::uint16_t a, std::uint16_t b, std::vector<Evidence>& out) const {
  if (a == 0 || b == 0) return;
  const LinkedSyntax &one = sides_[0]->linked->chain[a - 1u], &other = sides_[1]->linked->chain[b - 1u];
  if (one.syntax != other.syntax) return;
  for (std::uint32_t i = 0; i < one.syntax->option_count; ++i) {
    if (one.options[i].text == other.options[i].text) continue;
    const ig_option_decl& o = one.syntax->options[i];
    const auto value = [&o](const LinkedSyntax& s, std::uint32_t k) {
      const bool has_unit = o.unit != nullptr && *o.unit != '\0';
      return has_unit ? fmt::format("{} {}", s.options[k].text, o.unit) : s.options[k].text;
    };
    const auto place = [&o](const LinkedSyntax& s) {
      for (const Attribute& given : s.element.options)
        if (given.name == o.name) return place_text(given.where);
      return std::string();
    };
    const std::string name = fmt::format("option {} of {}", o.name, one.element.alias);
    Evidence e;
    e.name_a = e.name_b = name;
    e.a = value(one, i);
    e.b = value(other, i);
    e.place_a = place(one);
    e.place_b = place(other);
    e.is_sure = true;
    e.option = o.name;
    e.raw_a = one.options[i].text;
    out.push_back(std::move(e));
  }
}

std::vector<Evidence> EvidenceFinder::find(std::uint16_t a, std::uint16_t b, const Snapshot& block_a,
                                           const Snapshot& block_b) const {
  std::vector<Evidence> out;
  add_rows(a, b, block_a, block_b, out);
  add_options(a, b, out);
  std::stable_sort(out.begin(), out.end(), [](const Evidence& x, const Evidence& y) { return x.is_sure > y.is_sure; });
  return out;
}

std::string text_of(const Evidence& e) {
  const auto value = [](const std::string& text) { return text.empty() ? std::string("''") : text; };
  const std::string title = e.title.empty() ? "" : e.title + ": ";
  if (e.name_b.empty()) return title + fmt::format("{} = {} against nothing", e.name_a, value(e.a));
  if (e.name_a.empty()) return title + fmt::format("nothing against {} = {}", e.name_b, value(e.b));
  if (e.name_a == e.name_b) return title + fmt::format("{} = {} against {}", e.name_a, value(e.a), value(e.b));
  return title + fmt::format("{} = {} against {} = {}", e.name_a, value(e.a), e.name_b, value(e.b));
}

}  // namespace isogloss::cli::parting
