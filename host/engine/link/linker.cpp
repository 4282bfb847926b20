// Linking: find the parts, type the options, collect the fields, give them dense ids, check, make the wake masks.
// One class holds the work in progress; each step is a member function and reports all faults that it finds.
#include "isogloss/engine/linker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <tuple>
#include <unordered_map>

#include <fmt/format.h>

#include "dialect/options.hpp"
#include "dialect/row_checks.hpp"
#include "link/link_checks.hpp"
#include "link/pattern.hpp"

namespace isogloss {

namespace {

constexpr std::size_t maximum_chain = 256;
constexpr std::size_t maximum_previous = 63;
constexpr std::string_view words_prefix = "Parsing.";
constexpr std::string_view flags_prefix = "Parsing.Flags.";

/// A field while the layout is being made.
struct Draft {
  FieldInfo info;
  std::string_view declared_by;
  bool has_previous = false;
};

class Linker {
 public:
  Linker(const Dialect& dialect, Library& library, DiagnosticSink& sink, LinkMode mode)
      : library_(library), sink_(sink), mode_(mode), out_(std::make_unique<LinkedDialect>()) {
    out_->dialect = dialect;
  }

  std::unique_ptr<LinkedDialect> link() {
    find_parts();
    if (failed_) return nullptr;
    collect_fields();
    if (failed_) return nullptr;
    assign_ids();
    resolve_ids();
    set_initial_state();
    check();
    make_wake_masks();
    return failed_ ? nullptr : std::move(out_);
  }

 private:
  void say(std::string_view code, const Location& where, std::initializer_list<std::string> arguments,
           std::string hint = {}) {
    add(host_diagnostic(code, where, arguments, std::move(hint)));
  }
  void add(Diagnostic d) {
    const auto severity = out_->dialect.severities.find(d.code);
    if (severity != out_->dialect.severities.end() && d.severity != Severity::error) d.severity = severity->second;
    failed_ = failed_ || d.severity == Severity::error;
    sink_.add(std::move(d));
  }
  static std::string meant(const std::string& near) { return near.empty() ? near : "did you mean " + near + "?"; }

  // ---- parts

  void find_parts() {
    for (const PluginReference& p : out_->dialect.plugins)
      if (!library_.load(p.name, p.where, sink_)) failed_ = true;
    if (out_->dialect.chain.size() > maximum_chain)
      say("IG-0216", {out_->dialect.file.string(), 0, 0},
          {std::to_string(out_->dialect.chain.size()), std::to_string(maximum_chain)});
    for (const ChainElement& element : out_->dialect.chain) find_syntax(element);
    for (const DependencyElement& element : out_->dialect.dependencies) find_dependency(element);
    const auto count_before = [&](Stage stage) {
      return static_cast<std::uint32_t>(std::count_if(out_->chain.begin(), out_->chain.end(),
                                                      [&](const LinkedSyntax& s) { return s.element.stage < stage; }));
    };
    out_->post_logic_begin = count_before(Stage::post_logic);
    out_->inspection_begin = count_before(Stage::inspection);
  }

  bool is_named(const ig_plugin* plugin) const {
    const auto& names = out_->dialect.plugins;
    return std::any_of(names.begin(), names.end(), [&](const PluginReference& p) { return p.name == plugin->name; });
  }

  /// For a name that the dialect's plugins lack: the plugin that has it, or one with a similar name.
  template <class NamesOf>
  std::string cure(const std::string& name, const std::vector<std::string>& own, const NamesOf& names_of) {
    library_.load_all();
    std::vector<std::string> others;
    for (const LoadedPlugin& p : library_.plugins()) {
      if (is_named(p.plugin)) continue;
      for (std::string& other : names_of(*p.plugin)) {
        if (other == name) return "the plugin " + of_plugin(p);
        others.push_back(std::move(other));
      }
    }
    if (const std::string near = nearest_name(name, own); !near.empty()) return meant(near);
    const std::string near = nearest_name(name, others);
    for (const LoadedPlugin& p : library_.plugins())
      for (const std::string& other : names_of(*p.plugin))
        if (!near.empty() && other == near) return fmt::format("did you mean {}? The plugin {}", near, of_plugin(p));
    return {};
  }
  static std::string of_plugin(const LoadedPlugin& p) {
    return fmt::format("{0} has it: <Plugins> <Plugin name=\"{0}\"/> </Plugins>", p.plugin->name);
  }

  /// The dependencies that provide a service, each with its plugin where the dialect does not name that.
  std::string providers(std::string_view service) {
    library_.load_all();
    std::string out;
    for (const LoadedPlugin& p : library_.plugins())
      for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i)
        for (const char* const* id = p.plugin->dependencies[i]->provides; id != nullptr && *id != nullptr; ++id)
          if (service == *id)
            out += fmt::format("{}<{}/>{}", out.empty() ? "add " : " or ", p.plugin->dependencies[i]->id,
                               is_named(p.plugin) ? "" : fmt::format(" of the plugin {}", p.plugin->name));
    return out.empty() ? out : out + " to <Dependencies>";
  }

  /// The syntaxes that write a field.
  std::string writers(std::string_view path) {
    library_.load_all();
    std::string out;
    for (const LoadedPlugin& p : library_.plugins())
      for (std::uint32_t i = 0; i < p.plugin->syntax_count; ++i) {
        const ig_syntax& s = *p.plugin->syntaxes[i];
        for (std::uint32_t f = 0; f < s.field_count; ++f)
          if ((s.fields[f].access & IG_WRITE) != 0 && path == s.fields[f].path) {
            out += fmt::format("{}{}{}", out.empty() ? "add " : " or ", s.id,
                               is_named(p.plugin) ? "" : fmt::format(" of the plugin {}", p.plugin->name));
            break;
          }
      }
    return out.empty() ? out : out + ", or give the field an initial value";
  }

  void find_syntax(const ChainElement& element) {
    LinkedSyntax s;
    s.element = element;
    s.syntax = library_.syntax(element.syntax, &s.plugin);
    if (s.syntax == nullptr || !is_named(s.plugin)) {
      std::vector<std::string> names;
      for (const LoadedPlugin& p : library_.plugins())
        if (is_named(p.plugin))
          for (std::uint32_t i = 0; i < p.plugin->syntax_count; ++i) names.emplace_back(p.plugin->syntaxes[i]->id);
      say("IG-0202", element.where, {element.syntax}, cure(element.syntax, names, [](const ig_plugin& p) {
            std::vector<std::string> all;
            for (std::uint32_t i = 0; i < p.syntax_count; ++i) all.emplace_back(p.syntaxes[i]->id);
            return all;
          }));
      return;
    }
    s.options = read_options(element.alias, element.where, s.syntax->options, s.syntax->option_count, element.options);
    if (s.syntax->look_ahead > 0) {
      out_->look_ahead = std::max(out_->look_ahead, s.syntax->look_ahead);
      if (element.stage != Stage::post_logic && mode_ == LinkMode::whole)
        say("IG-0221", element.where, {element.alias});
    }
    if (s.syntax->inspects != 0 && element.stage != Stage::inspection && mode_ == LinkMode::whole)
      say("IG-0223", element.where, {element.alias});
    out_->chain.push_back(std::move(s));
  }

  void find_dependency(const DependencyElement& element) {
    LinkedDependency d;
    d.element = element;
    d.dependency = library_.dependency(element.id, &d.plugin);
    if (d.dependency == nullptr || !is_named(d.plugin)) {
      std::vector<std::string> names;
      for (const LoadedPlugin& p : library_.plugins())
        if (is_named(p.plugin))
          for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i)
            names.emplace_back(p.plugin->dependencies[i]->id);
      say("IG-0203", element.where, {element.id}, cure(element.id, names, [](const ig_plugin& p) {
            std::vector<std::string> all;
            for (std::uint32_t i = 0; i < p.dependency_count; ++i) all.emplace_back(p.dependencies[i]->id);
            return all;
          }));
      return;
    }
    d.options =
        read_options(element.alias, element.where, d.dependency->options, d.dependency->option_count, element.options);
    for (Diagnostic& fault : check_rows(*d.dependency, element.alias, element.rows)) add(std::move(fault));
    out_->dependencies.push_back(std::move(d));
  }

  std::vector<OptionValue> read_options(const std::string& owner, const Location& where, const ig_option_decl* declared,
                                        std::uint32_t count, const std::vector<Attribute>& given) {
    std::vector<OptionValue> values(count);
    std::vector<bool> is_given(count);
    for (const Attribute& a : given) {
      const ig_option_decl* const option =
          std::find_if(declared, declared + count, [&](const ig_option_decl& o) { return a.name == o.name; });
      if (option == declared + count) {
        std::vector<std::string> names;
        for (std::uint32_t i = 0; i < count; ++i) names.emplace_back(declared[i].name);
        say("IG-0204", a.where, {owner, a.name}, meant(nearest_name(a.name, names)));
        continue;
      }
      const auto number = static_cast<std::size_t>(option - declared);
      is_given[number] = true;
      if (std::optional<OptionValue> v = parse_option(*option, a.value))
        values[number] = std::move(*v);
      else
        say("IG-0205", a.where, {a.name, owner, describe_option(*option), a.value});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_given[i]) continue;
      if (declared[i].fallback == nullptr)
        say("IG-0213", where, {owner, declared[i].name});
      else if (std::optional<OptionValue> v = parse_option(declared[i], declared[i].fallback))
        values[i] = std::move(*v);
    }
    return values;
  }

  // ---- fields

  static const char* type_name(ig_type type) {
    static constexpr std::array names{"nothing", "number", "integer",   "boolean", "name",
                                      "text",    "code",   "transform", "switch"};
    return type < names.size() ? names[type] : "nothing";
  }

  /// "Parsing.Flags.X" is the same field as "Parsing.X" when some syntax lets X own words.
  std::string_view canonical(std::string_view path) const {
    if (!path.starts_with(flags_prefix)) return path;
    const auto owner = owners_.find(path.substr(flags_prefix.size()));
    return owner == owners_.end() ? path : owner->second;
  }
  void add_owner(std::string_view path) {
    if (path.starts_with(words_prefix) && !path.starts_with(flags_prefix))
      owners_.emplace(path.substr(words_prefix.size()), path);
  }

  void collect_fields() {
    std::size_t declarations = 0;
    for (const LinkedSyntax& s : out_->chain) declarations += s.syntax->field_count;
    declared_.reserve(declarations);
    drafts_.reserve(declarations / 2);  // most fields are declared several times
    draft_of_.reserve(declarations / 2);
    for (const FieldInfo& info : standard_fields()) add_draft(info.path, {info, "the standard sections"});
    out_->layout.lists = standard_lists();
    for (const LinkedSyntax& s : out_->chain)
      for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
        const ig_field_decl& decl = s.syntax->fields[i];
        if (decl.type != IG_CODE) continue;
        if ((decl.access & IG_PATTERN) == 0) {
          add_owner(decl.path);
          continue;
        }
        for (const FieldPattern& p : patterns(s, decl)) {
          if (!p.is_literal()) continue;
          add_owner(p.path());
          if (!p.path().starts_with(words_prefix)) say("IG-0243", s.element.where, {s.element.alias, p.path()});
        }
      }
    for (const LinkedSyntax& s : out_->chain)
      for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
        const ig_field_decl& decl = s.syntax->fields[i];
        if ((decl.access & IG_PATTERN) == 0) {
          declared_.push_back(declare(s, decl, decl.path));
          continue;
        }
        declared_.push_back(IG_NO_FIELD);
        for (const FieldPattern& p : patterns(s, decl))
          if (p.is_literal()) declare(s, decl, p.path());
      }
  }

  /// Read once, since paths of fields are views of them.
  const std::vector<FieldPattern>& patterns(const LinkedSyntax& s, const ig_field_decl& decl) {
    const auto [where, added] = patterns_.try_emplace({&s, &decl});
    if (!added) return where->second;
    if (*decl.path != '@') return where->second = parse_patterns(decl.path);
    for (std::uint32_t i = 0; i < s.syntax->option_count; ++i)
      if (std::string_view(decl.path).substr(1) == s.syntax->options[i].name) {
        where->second = parse_patterns(s.options[i].text);
        break;
      }
    return where->second;
  }

  std::uint32_t add_draft(std::string_view path, Draft draft) {
    const auto number = static_cast<std::uint32_t>(drafts_.size());
    draft_of_.emplace(path, number);
    drafts_.push_back(std::move(draft));
    return number;
  }

  /// The number of the draft, or the id of a record's field.
  std::uint32_t declare(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view written) {
    const std::size_t brackets = written.find("[].");
    if (brackets != std::string_view::npos)
      return declare_record(s, decl, written.substr(0, brackets), written.substr(brackets + 3));
    const std::string_view path = canonical(written);
    const auto where = draft_of_.find(path);
    const std::uint32_t number =
        where != draft_of_.end()
            ? where->second
            : add_draft(path, {{std::string(path), decl.type,
                                decl.life == IG_LIFE_STANDARD ? default_life(path, decl.type) : decl.life, decl.unit,
                                decl.doc, decl.type == IG_SWITCH, IG_NO_FIELD},
                               s.element.alias});
    Draft& known = drafts_[number];
    if (decl.type == IG_TEXT && is_carried(decl.life))
      say("IG-0222", s.element.where, {s.element.alias, std::string(path)});
    const bool same_life = decl.life == IG_LIFE_STANDARD || known.info.life == decl.life;
    if (known.info.type != decl.type || !same_life)
      say("IG-0209", s.element.where,
          {s.element.alias, std::string(path), type_name(decl.type), std::string(known.declared_by),
           type_name(known.info.type)},
          same_life ? "" : "their lives differ");
    if (known.info.unit.empty() && *decl.unit != '\0') known.info.unit = decl.unit;
    if (known.info.doc.empty() && *decl.doc != '\0') known.info.doc = decl.doc;
    known.has_previous |= (decl.access & IG_PREVIOUS) != 0;
    return number;
  }

  static ig_life default_life(std::string_view path, ig_type type) {
    if (type == IG_TRANSFORM) return IG_LIFE_MODAL;
    if (type == IG_SWITCH || type == IG_TEXT) return IG_LIFE_BLOCK;
    return path.starts_with(words_prefix) ? IG_LIFE_WORD : IG_LIFE_BLOCK;
  }

  ig_field declare_record(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view list,
                          std::string_view path) {
    auto& lists = out_->layout.lists;
    auto l = std::find_if(lists.begin(), lists.end(), [&](const ListInfo& info) { return info.path == list; });
    if (l == lists.end()) {
      lists.push_back({std::string(list), {}});
      l = lists.end() - 1;
    }
    auto f = std::find_if(l->fields.begin(), l->fields.end(), [&](const FieldInfo& i) { return i.path == path; });
    if (f == l->fields.end()) {
      l->fields.push_back({std::string(path), decl.type, IG_LIFE_BLOCK, decl.unit, decl.doc, false, IG_NO_FIELD});
      f = l->fields.end() - 1;
    } else if (f->type != decl.type) {
      say("IG-0209", s.element.where,
          {s.element.alias, std::string(list) + "[]." + std::string(path), type_name(decl.type), "another syntax",
           type_name(f->type)});
    }
    return record_field(static_cast<std::size_t>(l - lists.begin()), static_cast<std::size_t>(f - l->fields.begin()));
  }

  // ---- ids: modal fields first, among them those that are read as `previous`, with their copies;
  // then the block's, switches, codes, words, words of codes (Parsing.G81.X)

  static std::size_t rank(const Draft& draft) {
    const FieldInfo& info = draft.info;
    if (is_carried(info.life)) return draft.has_previous && info.type != IG_TRANSFORM ? 0 : 1;
    if (info.type == IG_SWITCH) return 3;
    if (info.type == IG_CODE) return 4;
    if (info.life != IG_LIFE_WORD) return 2;
    return std::count(info.path.begin(), info.path.end(), '.') > 1 ? 6 : 5;
  }

  /// X Y Z of a section are read and written at once where the bits of the three lie in one word. Where three would
  /// cross a word, fields that belong to no such group are placed first.
  void keep_points_whole(std::vector<std::uint32_t>& numbers, std::size_t first_id) const {
    for (std::size_t i = 0; i < numbers.size();) {
      if (!begins_point(numbers, i)) {
        ++i;
        continue;
      }
      std::size_t room = 64 - (first_id + i) % 64;
      for (std::size_t single = i + 3; room < 3 && room > 0 && single < numbers.size();) {
        if (begins_point(numbers, single)) {
          single += 3;
          continue;
        }
        const auto found = numbers.begin() + static_cast<std::ptrdiff_t>(single++);
        if (drafts_[*found].info.type == IG_TRANSFORM) continue;  // they compose in their order
        std::rotate(numbers.begin() + static_cast<std::ptrdiff_t>(i), found, found + 1);
        ++i;
        --room;
      }
      i += 3;
    }
  }
  bool begins_point(const std::vector<std::uint32_t>& numbers, std::size_t i) const {
    if (numbers.size() - i < 3) return false;
    const auto section = [&](std::size_t k, char axis) -> std::string_view {
      const std::string_view path = drafts_[numbers[i + k]].info.path;
      return path.size() > 2 && path[path.size() - 2] == '.' && path.back() == axis ? path.substr(0, path.size() - 1)
                                                                                    : std::string_view();
    };
    const std::string_view x = section(0, 'X');
    return !x.empty() && section(1, 'Y') == x && section(2, 'Z') == x;
  }

  void assign_ids() {
    Layout& layout = out_->layout;
    std::array<std::vector<std::uint32_t>, 7> order;
    for (std::uint32_t i = 0; i < drafts_.size(); ++i) order[rank(drafts_[i])].push_back(i);
    std::vector<std::uint32_t> previous;  // in the order of their ids, so that one piece of memory holds them
    for (const std::vector<std::uint32_t>& same_rank : order)
      for (const std::uint32_t number : same_rank)
        if (drafts_[number].has_previous) previous.push_back(number);
    if (previous.size() > maximum_previous)
      say("IG-0224", {out_->dialect.file.string(), 0, 0},
          {std::to_string(previous.size()), std::to_string(maximum_previous)});

    ig_field next = 0;
    const auto give = [&](std::vector<std::uint32_t>& numbers, std::vector<ig_field>& ids) {
      keep_points_whole(numbers, next);
      for (const std::uint32_t number : numbers) ids[number] = next++;
    };
    id_of_.resize(drafts_.size(), IG_NO_FIELD);
    previous_id_of_.resize(drafts_.size(), IG_NO_FIELD);
    for (std::vector<std::uint32_t>& same_rank : order) {
      give(same_rank, id_of_);
      if (&same_rank == &order[0]) give(previous, previous_id_of_);
    }
    layout.fields.resize(next);
    for (const std::vector<std::uint32_t>& same_rank : order)
      for (const std::uint32_t number : same_rank) {
        const ig_field id = id_of_[number];
        if (drafts_[number].info.type == IG_TRANSFORM) layout.transforms.push_back(id);
        layout.fields[id] = std::move(drafts_[number].info);
      }
    for (const std::uint32_t number : previous) {
      FieldInfo& copy = layout.fields[previous_id_of_[number]];
      copy = layout.fields[id_of_[number]];
      copy.life = IG_LIFE_BLOCK;
      copy.hidden = true;
      copy.previous_of = id_of_[number];
    }
    layout.index();
    order_for_show();
  }

  /// By section; in a section what is carried first, words last, each in the order in which it is mentioned.
  void order_for_show() {
    Layout& layout = out_->layout;
    std::unordered_map<std::string_view, std::size_t> sections;
    for (const std::string& s : section_order()) sections.emplace(s, sections.size());
    using Place = std::tuple<std::size_t, int, std::uint32_t>;
    std::vector<std::pair<Place, ig_field>> shown;
    for (std::uint32_t number = 0; number < id_of_.size(); ++number) {
      const FieldInfo& info = layout.fields[id_of_[number]];
      if (info.hidden || info.type == IG_CODE || info.type == IG_TRANSFORM) continue;
      const std::string_view path = info.path;
      const auto found = sections.find(path.substr(0, path.find('.')));
      const int life = is_carried(info.life) ? 0 : info.life == IG_LIFE_WORD ? 2 : 1;
      shown.push_back({{found != sections.end() ? found->second : sections.size(), life, number}, id_of_[number]});
    }
    std::sort(shown.begin(), shown.end());
    for (const auto& [place, field] : shown) layout.shown.push_back(field);
  }

  void resolve_ids() {
    const std::size_t mask_words = (out_->layout.fields.size() + 63) / 64;
    auto declared = declared_.begin();
    for (LinkedSyntax& s : out_->chain) {
      s.may_read.resize(mask_words);
      s.may_write.resize(mask_words);
      s.may_take.resize(mask_words);
      s.ids.reserve(s.syntax->field_count);
      for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
        const ig_field_decl& decl = s.syntax->fields[i];
        s.ids.push_back(resolve(decl, *declared++));
        permit(s, decl.access, s.ids.back());
        if ((decl.access & IG_PATTERN) == 0) continue;
        s.expansions.resize(i + 1);
        s.expansions[i] = expand(s, decl);
        for (const ig_field f : s.expansions[i]) permit(s, decl.access, f);
      }
    }
  }

  /// From what declare() answered to an id.
  ig_field resolve(const ig_field_decl& decl, std::uint32_t declared) const {
    if (is_record_field(declared)) return declared;  // or a pattern's IG_NO_FIELD
    return (decl.access & IG_PREVIOUS) != 0 ? previous_id_of_[declared] : id_of_[declared];
  }

  std::vector<ig_field> expand(const LinkedSyntax& s, const ig_field_decl& decl) {
    std::vector<ig_field> out;
    std::vector<bool> in(out_->layout.fields.size());
    const auto add = [&](ig_field f) {
      if (!in[f]) out.push_back(f);
      in[f] = true;
    };
    for (const FieldPattern& pattern : patterns(s, decl)) {
      if (pattern.is_literal()) {
        const std::optional<ig_field> f = out_->layout.find(canonical(pattern.path()));
        if (f && out_->layout.fields[*f].type == decl.type)
          add(*f);
        else
          say("IG-0214", s.element.where, {pattern.path()});
        continue;
      }
      bool is_met = false;
      for (ig_field f = 0; f < in.size(); ++f) {
        const FieldInfo& info = out_->layout.fields[f];
        if (info.hidden || info.type != decl.type || !pattern.matches(info.path, info.unit)) continue;
        if (!pattern.owner_unit().empty() && unit_of(pattern.owner(info.path)) != pattern.owner_unit()) continue;
        add(f);
        is_met = true;
      }
      if (!is_met && mode_ == LinkMode::whole && *decl.path == '@')
        say_unmet(s, std::string_view(decl.path).substr(1), pattern.path());
    }
    return out;
  }

  std::string_view unit_of(std::string_view path) const {
    const std::optional<ig_field> f = out_->layout.find(canonical(path));
    return f ? std::string_view(out_->layout.fields[*f].unit) : std::string_view();
  }

  /// Only for options that the dialect writes: a default may be for other chains.
  void say_unmet(const LinkedSyntax& s, std::string_view option, const std::string& pattern) {
    for (const Attribute& given : s.element.options)
      if (given.name == option) say("IG-0244", given.where, {s.element.alias, given.name, pattern});
  }

  static void permit(LinkedSyntax& s, std::uint32_t access, ig_field f) {
    if (f == IG_NO_FIELD || is_record_field(f)) return;
    const std::uint64_t bit = std::uint64_t{1} << (f & 63);
    if ((access & (IG_READ | IG_PREVIOUS | IG_WAKE | IG_WAKE_WHILE)) != 0) s.may_read[f >> 6] |= bit;
    if ((access & IG_WRITE) != 0) s.may_write[f >> 6] |= bit;
    if ((access & IG_TAKE) != 0) s.may_take[f >> 6] |= bit;
  }

  // ---- initial state

  void set_initial_state() {
    for (const InitialField& initial : out_->dialect.initial) {
      const std::optional<ig_field> f = out_->layout.find(canonical(initial.path));
      if (!f) {
        std::vector<std::string> names;
        for (const FieldInfo& info : out_->layout.fields) names.push_back(info.path);
        say("IG-0214", initial.where, {initial.path}, meant(nearest_name(initial.path, names)));
        continue;
      }
      const FieldInfo& info = out_->layout.fields[*f];
      ig_value v{};
      const std::optional<double> number = parse_number(initial.value);
      bool ok = true;
      if (info.type == IG_NUMBER) {
        ok = number.has_value();
        v.number = number.value_or(0);
      } else if (info.type == IG_INTEGER) {
        constexpr double largest = 9007199254740992.0;  // beyond it a double skips integers
        ok = number.has_value() && std::abs(*number) <= largest && *number == std::trunc(*number);
        v.integer = ok ? static_cast<std::int64_t>(*number) : 0;
      } else if (info.type == IG_BOOLEAN) {
        ok = initial.value == "true" || initial.value == "false";
        v.integer = initial.value == "true" ? 1 : 0;
      } else if (info.type == IG_SYMBOL) {
        v.symbol = out_->symbols.intern(initial.value);
      } else {
        ok = false;
      }
      if (ok)
        out_->initial.emplace_back(*f, v);
      else
        say("IG-0215", initial.where, {initial.value, type_name(info.type), initial.path});
    }
  }

  void check() {
    if (mode_ == LinkMode::parts) {
      for (const LinkFault& fault : check_services(*out_)) say(fault.code, fault.where, fault);
      return;
    }
    for (const LinkFault& fault : check_links(*out_)) say(fault.code, fault.where, fault);
  }
  void say(std::string_view code, const Location& where, const LinkFault& fault) {
    Diagnostic d = host_diagnostic(code, where, {}, fault.hint);
    if (code == "IG-0211") d.hint = providers(fault.arguments[1]);
    if (code == "IG-0208") d.hint = writers(fault.arguments[1]);
    for (const DiagnosticInfo& info : host_diagnostics())
      if (info.code == code) d.message = fill_in(info.text, fault.arguments);
    add(std::move(d));
  }

  // ---- wake masks

  void make_wake_masks() {
    std::uint32_t& first = out_->first_build;
    while (first < out_->chain.size() && out_->chain[first].syntax->build == nullptr) ++first;
    // The last bit of two words is the document's; two cost no more than one.
    out_->wake_words = out_->chain.size() - first < 128 ? 2 : 4;
    const std::size_t fields = out_->layout.fields.size();
    out_->wake.assign((fields + out_->layout.lists.size()) * out_->wake_words, 0);
    for (std::uint32_t position = first; position < out_->chain.size(); ++position) {
      const LinkedSyntax& s = out_->chain[position];
      if (s.syntax->build == nullptr) continue;
      const std::uint32_t place = position - first;
      for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
        const ig_field_decl& decl = s.syntax->fields[i];
        if ((decl.access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
        const std::span<const ig_field> one(&s.ids[i], 1);
        for (const ig_field f : (decl.access & IG_PATTERN) != 0 ? s.expansions[i] : one) {
          if (f == IG_NO_FIELD) continue;
          const std::size_t row = is_record_field(f) ? fields + list_of(f) : f;
          if ((decl.access & IG_WAKE) != 0)
            out_->wake[row * out_->wake_words + place / 64] |= std::uint64_t{1} << (place % 64);
          if ((decl.access & IG_WAKE_WHILE) != 0 && !is_record_field(f))
            out_->wake_while.push_back(
                {f, decl.wake_value == nullptr ? 0 : out_->symbols.intern(decl.wake_value), position});
        }
      }
    }
  }

  Library& library_;
  DiagnosticSink& sink_;
  LinkMode mode_;
  std::unique_ptr<LinkedDialect> out_;
  bool failed_ = false;
  // The views below point into descriptors, standard sections and patterns, which outlive the linker.
  std::map<std::pair<const LinkedSyntax*, const ig_field_decl*>, std::vector<FieldPattern>> patterns_;
  std::unordered_map<std::string_view, std::string_view> owners_;  // codes that own words, their path by their name
  std::vector<Draft> drafts_;                                      // in the order in which they are mentioned first
  std::unordered_map<std::string_view, std::uint32_t> draft_of_;
  std::vector<std::uint32_t> declared_;           // what declare() answered, for the declarations of the whole chain
  std::vector<ig_field> id_of_, previous_id_of_;  // by draft
};

}  // namespace

std::optional<std::uint32_t> LinkedDialect::position(std::string_view alias) const {
  for (std::uint32_t i = 0; i < chain.size(); ++i)
    if (chain[i].element.alias == alias) return i;
  return std::nullopt;
}

std::unique_ptr<LinkedDialect> link(const Dialect& dialect, Library& library, DiagnosticSink& sink, LinkMode mode) {
  return Linker(dialect, library, sink, mode).link();
}

}  // namespace isogloss
