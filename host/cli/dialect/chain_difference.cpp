// What differs between two dialects: plugins, tables, initial state, chain and options, one row each.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dialect/chain_map.hpp"

namespace isogloss::cli {

namespace {

struct Value {
  std::string text;
  Location where;
};
using Values = std::map<std::string, Value>;

Json place_or_null(const Value* value) {
  if (value == nullptr || value->where.file.empty()) return nullptr;
  return fmt::format("{}:{}", value->where.file, value->where.line);
}

class Difference {
 public:
  explicit Difference(Library& library) : library_(library) {}

  void compare(std::string_view part, const std::string& prefix, const Values& left, const Values& right) {
    const auto find = [](const Values& values, const std::string& name) -> const Value* {
      const auto found = values.find(name);
      return found == values.end() ? nullptr : &found->second;
    };
    Values all = left;
    all.insert(right.begin(), right.end());
    for (const auto& [name, unused] : all) {
      const Value *a = find(left, name), *b = find(right, name);
      if (a == nullptr || b == nullptr || a->text != b->text) add(part, prefix + name, a, b);
    }
  }

  void add(std::string_view part, const std::string& name, const Value* left, const Value* right) {
    const auto text = [](const Value* v) { return v == nullptr ? Json(nullptr) : Json(v->text); };
    rows.push_back({{"Part", part},
                    {"Name", name},
                    {"Left", text(left)},
                    {"Right", text(right)},
                    {"LeftPlace", place_or_null(left)},
                    {"RightPlace", place_or_null(right)}});
  }

  /// The given values on top of the defaults; where a part has no plugin, the given ones alone.
  static Values options(const ig_option_decl* declared, std::uint32_t count, const std::vector<Attribute>& given) {
    Values out;
    for (std::uint32_t i = 0; i < count; ++i)
      if (declared[i].fallback != nullptr) out[declared[i].name] = {declared[i].fallback, {}};
    for (const Attribute& a : given) out[a.name] = {a.value, a.where};
    return out;
  }

  Values options(const ChainElement& e) const {
    const ig_syntax* const s = library_.syntax(e.syntax);
    return s == nullptr ? options(nullptr, 0, e.options) : options(s->options, s->option_count, e.options);
  }
  Values options(const DependencyElement& e) const {
    const ig_dependency* const d = library_.dependency(e.id);
    return d == nullptr ? options(nullptr, 0, e.options) : options(d->options, d->option_count, e.options);
  }

  /// The cells of a table, by the key of the row: G54.X.
  Values cells(const DependencyElement& e) const {
    const ig_dependency* const d = library_.dependency(e.id);
    const std::string key = d == nullptr || d->row_key == nullptr ? "" : d->row_key;
    Values out;
    for (std::size_t i = 0; i < e.rows.size(); ++i) {
      std::string row = std::to_string(i + 1);
      for (const Attribute& a : e.rows[i].attributes)
        if (a.name == key) row = a.value;
      for (const Attribute& a : e.rows[i].attributes)
        if (a.name != key) out[row + "." + a.name] = {a.value, a.where};
    }
    return out;
  }

  template <class Element>
  void compare_options(std::string_view part, const std::vector<Element>& left, const std::vector<Element>& right) {
    for (const Element& a : left)
      for (const Element& b : right)
        if (a.alias == b.alias) compare(part, a.alias + " ", options(a), options(b));
  }

  void compare_chains(const Dialect& left, const Dialect& right);

  Json rows = Json::array();

 private:
  Library& library_;
};

Value position(const Dialect& d, std::size_t i) {
  const std::string name = d.chain[i].alias == d.chain[i].syntax ? "" : fmt::format(" {}", d.chain[i].syntax);
  const std::string after = i == 0 ? "first" : "after " + d.chain[i - 1].alias;
  return {fmt::format("{}{}, {}", to_string(d.chain[i].stage), name, after), d.chain[i].where};
}

/// Syntaxes of one side, and those that stand elsewhere: the longest part that both have in one order is the same.
void Difference::compare_chains(const Dialect& left, const Dialect& right) {
  const auto &a = left.chain, &b = right.chain;
  const auto is_same = [&](std::size_t i, std::size_t j) {
    return a[i].alias == b[j].alias && a[i].syntax == b[j].syntax && a[i].stage == b[j].stage;
  };
  std::vector<std::vector<std::size_t>> common(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      common[i][j] = is_same(i, j) ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  const auto find = [](const std::vector<ChainElement>& chain, const std::string& alias) {
    return static_cast<std::size_t>(
        std::find_if(chain.begin(), chain.end(), [&](const ChainElement& e) { return e.alias == alias; }) -
        chain.begin());
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && is_same(i, j)) {
      ++i, ++j;
    } else if (j == b.size() || (i < a.size() && common[i + 1][j] >= common[i][j + 1])) {
      const Value own = position(left, i);
      const std::size_t there = find(b, a[i].alias);
      const Value other = there < b.size() ? position(right, there) : Value{};
      add(there < b.size() ? "moved" : "chain", a[i].alias, &own, there < b.size() ? &other : nullptr);
      ++i;
    } else {
      const Value own = position(right, j);
      if (find(a, b[j].alias) == a.size()) add("chain", b[j].alias, nullptr, &own);
      ++j;
    }
  }
}

Values plugins(const Dialect& d) {
  Values out;
  for (const PluginReference& p : d.plugins) out[p.name] = {"named", p.where};
  return out;
}

Values dependencies(const Dialect& d) {
  Values out;
  for (const DependencyElement& e : d.dependencies) out[e.alias] = {e.id, e.where};
  return out;
}

Values initial(const Dialect& d) {
  Values out;
  for (const InitialField& f : d.initial) out[f.path] = {f.value, f.where};
  return out;
}

Values reading(const Dialect& d) {
  Values out;
  std::string extensions;
  for (const std::string& e : d.extensions) extensions += (extensions.empty() ? "" : " ") + e;
  out["extensions"] = {extensions, d.files_where};
  out["continuation"] = {d.segmenter.continuation, d.segmenter_where};
  out["comment after the continuation"] = {d.segmenter.comment, d.segmenter_where};
  for (const auto& [code, given] : d.severities)
    out["severity of " + code] = {std::string(to_string(given.severity)), given.where};
  for (const Signature& s : d.signatures)
    out["signature " + s.pattern] = {fmt::format("weight {}", s.weight), d.files_where};
  for (const Signature& s : d.names) out["name " + s.pattern] = {fmt::format("weight {}", s.weight), d.files_where};
  return out;
}

}  // namespace

Json describe_difference(const Dialect& left, const Dialect& right, Library& library) {
  DiagnosticList unheard;  // `lint` reports plugins that are missing
  for (const Dialect* const d : {&left, &right})
    for (const PluginReference& p : d->plugins) library.load(p.name, p.where, unheard);
  Difference difference(library);
  difference.compare("file", "", reading(left), reading(right));
  difference.compare("plugin", "", plugins(left), plugins(right));
  difference.compare("table", "", dependencies(left), dependencies(right));
  difference.compare_options("table option", left.dependencies, right.dependencies);
  for (const DependencyElement& a : left.dependencies)
    for (const DependencyElement& b : right.dependencies)
      if (a.alias == b.alias) difference.compare("row", a.alias + " ", difference.cells(a), difference.cells(b));
  difference.compare("initial", "", initial(left), initial(right));
  difference.compare_chains(left, right);
  difference.compare_options("option", left.chain, right.chain);
  return {{"Left", left.name},
          {"Right", right.name},
          {"Same", difference.rows.empty()},
          {"Differences", std::move(difference.rows)}};
}

std::string difference_as_text(const Json& difference) {
  const Json& rows = difference["Differences"];
  if (rows.empty()) return {};
  constexpr std::size_t widest = 44;
  const auto cell = [](const Json& value) { return value.is_null() ? std::string("-") : value.get<std::string>(); };
  std::size_t name = 4, left = difference["Left"].get<std::string>().size();
  for (const Json& row : rows) {
    name = std::max(name, std::min(widest, cell(row["Name"]).size()));
    left = std::max(left, std::min(widest, cell(row["Left"]).size()));
  }
  const auto line = [&](std::string_view part, const std::string& what, const std::string& a, const std::string& b) {
    return fmt::format("{:<12} {:<{}}  {:<{}} | {}\n", part, what, name, a, left, b);
  };
  std::string out = line("", "", difference["Left"], difference["Right"]);
  for (const Json& row : rows)
    out += line(row["Part"].get<std::string>(), row["Name"], cell(row["Left"]), cell(row["Right"]));
  return out;
}

}  // namespace isogloss::cli
