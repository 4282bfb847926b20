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
        out.push_back({r.dependency, r.row, r.value});
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

void EvidenceFinder::add_rows(std::uint16_t a, std::uint16_t b, const Snapshot& block_a, const Snapshot& block_b,
                              std::vector<Evidence>& out) const {
  const std::vector<Row> rows_a = a == 0 ? std::vector<Row>{} : rows_of(0, a, block_a);
  const std::vector<Row> rows_b = b == 0 ? std::vector<Row>{} : rows_of(1, b, block_b);
  const auto alias = [this](int side, const Row& row) { return dependency(side, row.dependency).element.alias; };
  const auto name = [&](int side, const Row& row) { return fmt::format("{} {}", alias(side, row), row.row); };
  std::vector<const Row*> only_a, only_b;
  for (const Row& r : rows_a) {
    const auto found = std::find_if(rows_b.begin(), rows_b.end(), [&](const Row& other) {
      return other.row == r.row && alias(1, other) == alias(0, r);
    });
    if (found == rows_b.end())
      only_a.push_back(&r);
    else if (found->value != r.value)
      out.push_back({Evidence::Kind::row,
                     name(0, r),
                     name(1, *found),
                     r.value,
                     found->value,
                     place_of(0, r),
                     place_of(1, *found),
                     true,
                     Evidence::Trial::none,
                     {},
                     {}});
  }
  for (const Row& r : rows_b)
    if (std::none_of(rows_a.begin(), rows_a.end(),
                     [&](const Row& other) { return other.row == r.row && alias(0, other) == alias(1, r); }))
      only_b.push_back(&r);
  // Another table answers: its rows in the order in which they were asked.
  for (std::size_t i = 0; i < std::max(only_a.size(), only_b.size()); ++i) {
    const Row* const one = i < only_a.size() ? only_a[i] : nullptr;
    const Row* const other = i < only_b.size() ? only_b[i] : nullptr;
    out.push_back({Evidence::Kind::row,
                   one == nullptr ? "" : name(0, *one),
                   other == nullptr ? "" : name(1, *other),
                   one == nullptr ? "" : one->value,
                   other == nullptr ? "" : other->value,
                   one == nullptr ? "" : place_of(0, *one),
                   other == nullptr ? "" : place_of(1, *other),
                   false,
                   Evidence::Trial::none,
                   {},
                   {}});
  }
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
    out.push_back({Evidence::Kind::option, name, name, value(one, i), value(other, i), place(one), place(other), true,
                   Evidence::Trial::none, o.name, one.options[i].text});
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
  if (e.name_b.empty()) return fmt::format("{} = {} against nothing", e.name_a, value(e.a));
  if (e.name_a.empty()) return fmt::format("nothing against {} = {}", e.name_b, value(e.b));
  if (e.name_a == e.name_b) return fmt::format("{} = {} against {}", e.name_a, value(e.a), value(e.b));
  return fmt::format("{} = {} against {} = {}", e.name_a, value(e.a), e.name_b, value(e.b));
}

}  // namespace isogloss::cli::parting
