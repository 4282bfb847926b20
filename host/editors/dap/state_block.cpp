// What a client sees of the block that was finished last, and of the tables.
#include <fmt/format.h>

#include <algorithm>

#include "dap/state_view.hpp"
#include "isogloss/engine/document_json.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::dap {

namespace {

Json leaf(std::string name, std::string value, const std::string& type = {}) {
  Json out{{"name", std::move(name)}, {"value", std::move(value)}, {"variablesReference", 0}};
  if (!type.empty()) out["type"] = type;
  return out;
}

Json branch(std::string name, std::string value, std::int64_t reference) {
  Json out = leaf(std::move(name), std::move(value));
  out["variablesReference"] = reference;
  return out;
}

/// A word or code of the text, which a syntax may have taken since.
bool is_word_of_block(const Document& d, ig_field f) {
  const FieldInfo& info = d.layout().fields[f];
  const bool is_of_text = d.present(f) || d.taken(f);
  return is_of_text && info.life == IG_LIFE_WORD && !info.hidden && d.word_end(f) > d.word_begin(f) &&
         d.word_end(f) <= d.source.text.size();
}

/// Lists and transforms have no fields of their own below their path: they count as fresh.
bool is_any_fresh(const Document& d, const std::string& beginning) {
  bool has_fields = false;
  for (ig_field f = 0; f < d.size(); ++f) {
    if (!d.layout().fields[f].path.starts_with(beginning)) continue;
    if (d.present(f) && d.fresh(f)) return true;
    has_fields = true;
  }
  return !has_fields;
}

}  // namespace

void StateView::add_block(const Standing& standing, Json& out) {
  const Document& d = *standing.document;
  if (d.source.line == 0) return;
  out.push_back(leaf("text", printable(d.source.text, "\t")));
  out.push_back(leaf("place", fmt::format("{}:{}", d.source.file, d.source.line)));
  out.push_back(branch("words", "", add({Kind::words})));
  const std::size_t count = standing.strokes.size();
  out.push_back(branch("motions", std::to_string(count), add({Kind::motions})));
  out.push_back(branch("written", "", add({Kind::written})));
}

void StateView::add_words(const Standing& standing, Json& out) const {
  const Document& d = *standing.document;
  std::vector<std::pair<std::uint32_t, Json>> words;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (ig_field f = 0; f < d.size(); ++f) {
    if (!is_word_of_block(d, f)) continue;
    const std::uint32_t begin = d.word_begin(f), end = d.word_end(f);
    // A word that a syntax has moved stands at the same columns in another field.
    if (std::ranges::find(seen, std::pair(begin, end)) != seen.end()) continue;
    seen.emplace_back(begin, end);
    const FieldInfo& info = d.layout().fields[f];
    const bool is_code = info.type == IG_CODE;
    const std::string text = printable(d.source.text.substr(begin, end - begin));
    const std::string value = is_code ? std::string(Layout::code_name(info.path)) : number_text(d.number(f));
    words.emplace_back(begin, leaf(text, value, d.taken(f) || is_code ? "" : "Nothing has used this word."));
  }
  std::ranges::sort(words, {}, [](const auto& word) { return word.first; });
  for (auto& [begin, word] : words) out.push_back(std::move(word));
}

void StateView::add_motions(const Standing& standing, Json& out) {
  AxisValues before = standing.start && standing.position.is_within ? standing.start->program : AxisValues{};
  for (std::size_t i = 0; i < standing.strokes.size(); ++i) {
    out.push_back(branch(std::to_string(i + 1), describe(standing.strokes[i], before), add({Kind::motion, i})));
    before = standing.strokes[i].program;
  }
}

void StateView::add_motion(const Standing& standing, std::size_t index, Json& out) const {
  if (index >= standing.strokes.size()) return;
  const Stroke& stroke = standing.strokes[index];
  for (unsigned i = 0; i < 6; ++i) {
    const std::string axis(1, "XYZABC"[i]);
    if (stroke.program.has(i)) out.push_back(leaf(axis, number_text(stroke.program.at[i]) + " mm"));
    if (stroke.machine.has(i))
      out.push_back(leaf("machine." + axis, number_text(stroke.machine.at[i]) + (i < 3 ? " mm" : " deg")));
  }
  if (stroke.feed_mm_min) out.push_back(leaf("feed", number_text(*stroke.feed_mm_min) + " mm/min"));
}

void StateView::add_written(const Standing& standing, Json& out) const {
  const Document& d = *standing.document;
  const isogloss::Json shown = show_json(d, *standing.symbols);
  for (const auto& [section, value] : shown.items()) {
    if (section == "Source" || !value.is_object()) continue;
    for (const auto& [name, one] : value.items()) {
      const auto f = d.layout().find(section + "." + name);
      if (f ? !d.fresh(*f) : !is_any_fresh(d, section + "." + name + ".")) continue;
      constexpr std::size_t longest = 200;
      std::string text = one.dump(-1, ' ', false, isogloss::Json::error_handler_t::replace);
      if (text.size() > longest) text = text.substr(0, longest) + "…";
      out.push_back(leaf(section + "." + name, text, f ? d.layout().fields[*f].doc : ""));
    }
  }
}

void StateView::add_tables(const Standing& standing, Json& out) {
  const auto& dependencies = standing.chain->linked().dependencies;
  for (std::size_t i = 0; i < dependencies.size(); ++i) {
    const DependencyTable* const table = standing.chain->table(dependencies[i].element.alias);
    if (table == nullptr || table->rows().empty()) continue;
    out.push_back(
        branch(dependencies[i].element.alias, fmt::format("{} rows", table->rows().size()), add({Kind::table, i})));
  }
}

void StateView::add_rows(const Standing& standing, std::size_t dependency, Json& out) {
  const DependencyTable* const table =
      standing.chain->table(standing.chain->linked().dependencies[dependency].element.alias);
  const ig_dependency& d = table->dependency();
  for (const std::string& row : table->rows()) {
    std::string cells;
    for (std::uint32_t column = 0; column < d.column_count && cells.size() < 60; ++column)
      if (const std::string_view text = table->text(row, column); !text.empty())
        cells += fmt::format("{}{} {}", cells.empty() ? "" : ", ", d.columns[column].name, printable(text));
    out.push_back(branch(row, cells, add({Kind::row, dependency, row})));
  }
}

void StateView::add_cells(const Standing& standing, std::size_t dependency, const std::string& row, Json& out) const {
  const DependencyTable* const table =
      standing.chain->table(standing.chain->linked().dependencies[dependency].element.alias);
  const ig_dependency& d = table->dependency();
  for (std::uint32_t column = 0; column < d.column_count; ++column)
    if (const std::string_view text = table->text(row, column); !text.empty())
      out.push_back(leaf(d.columns[column].name, printable(text)));
}

}  // namespace isogloss::dap
