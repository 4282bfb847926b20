#include "isogloss/engine/chain.hpp"

#include <algorithm>
#include <stdexcept>

#include "contract/flow_host.hpp"
#include "contract/host_table.hpp"
#include "dialect/options.hpp"
#include "dialect/row_checks.hpp"
#include "run/cursor.hpp"

namespace isogloss {

namespace {

thread_local const Document* running = nullptr;

/// The call of a plugin that is under way outside the blocks of a run.
thread_local Breadcrumb outside_blocks;

class Calling {
 public:
  Calling(const ig_plugin& plugin, const char* id, const char* phase) : before_(outside_blocks) {
    outside_blocks = {plugin.name, id, phase, nullptr};
  }
  ~Calling() { outside_blocks = before_; }
  Calling(const Calling&) = delete;
  Calling& operator=(const Calling&) = delete;

 private:
  Breadcrumb before_;
};

/// Reports an exception that left a function of the contract, which none may.
[[gnu::cold]] Diagnostic exception_diagnostic(const ig_plugin& plugin, const std::string& alias, const char* phase,
                                              Location where) {
  std::string words;
  try {
    throw;
  } catch (const std::exception& e) {
    words = e.what();
  } catch (...) {
    words = "no std::exception";
  }
  return host_diagnostic("IG-0350", std::move(where), {alias, plugin.name, phase, words});
}

bool is_blank(unsigned char c) { return c == ' ' || c == '\t'; }

/// Does an element of a file that was given to the run mean this dependency of the dialect?
bool is_given(const DependencyElement& element, const DependencyElement& of_dialect) {
  return of_dialect.alias == element.alias || of_dialect.id == element.id;
}

/// True for tables whose rows have one main value, even if they also have values by axis.
bool has_one_value(const ig_dependency& d) {
  return d.column_count == 1 || std::string_view(d.columns[0].name) == "Value";
}

std::string columns_of(const ig_dependency& d) {
  std::string text = "the columns of " + std::string(d.id) + " are ";
  for (std::uint32_t i = 0; i < d.column_count; ++i) text += (i == 0 ? "" : ", ") + std::string(d.columns[i].name);
  return text;
}

void set_row(DependencyTable& table, const TableRow& row) {
  const std::string_view key = key_of(table.dependency(), row);
  table.add(key);
  for (const Attribute& a : row.attributes)
    if (const auto column = table.column(a.name)) table.set(key, static_cast<std::uint32_t>(*column), a.value);
}

/// The place where the user, or the dialect, gave the dependency its values.
const Location& place_of(const DependencyElement& of_dialect, const std::vector<DependencyElement>& of_user) {
  const Location* place = &of_dialect.where;
  for (const DependencyElement& given : of_user)
    if (is_given(given, of_dialect)) place = &given.where;
  return *place;
}

/// NULL where the dependency does not provide it, or does not exist yet.
const void* service_of(const ig_dependency& d, void* self, std::string_view id) {
  if (self == nullptr || d.provides == nullptr) return nullptr;
  for (const char* const* provided = d.provides; *provided != nullptr; ++provided)
    if (id == *provided)
      if (const void* const s = d.service(self, *provided)) return s;
  return nullptr;
}

}  // namespace

Chain::Interlude::Interlude() : before_(running) {}
Chain::Interlude::~Interlude() { running = before_; }

Chain::Chain(const LinkedDialect& linked, ChainSettings settings, DiagnosticSink& sink)
    : linked_(linked),
      settings_(std::move(settings)),
      sink_(sink),
      symbols_(linked.symbols),
      document_(linked.layout, linked.wake, linked.wake_words),
      host_(&host_table(settings_.mode)),
      flow_service_(flow_service()),
      is_plain_(settings_.mode == Mode::fast && !settings_.call_all) {
  document_.chain = this;
  if (settings_.mode == Mode::traced) document_.set_line.resize(document_.size());
  try {
    create_dependencies();
    create_syntaxes();
    watch_modal_state();
  } catch (...) {
    destroy();
    throw;
  }
}

Chain::~Chain() {
  if (running == &document_) running = nullptr;
  destroy();
}

void Chain::destroy() {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const LinkedSyntax& s = linked_.chain[i];
    destroy_part(*s.plugin, s.element.alias, s.syntax->destroy, steps_[i].self);
  }
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    destroy_part(*d.plugin, d.element.alias, d.dependency->destroy, dependencies_[i]);
  }
  steps_.clear();
  dependencies_.clear();
}

void Chain::destroy_part(const ig_plugin& plugin, const std::string& alias, void (*end)(void*), void* self) {
  if (self == nullptr) return;
  const Calling calling(plugin, alias.c_str(), "destroy");
  try {
    end(self);
  } catch (...) {
    sink_.add(exception_diagnostic(plugin, alias, "destroy", {}));
  }
}

void Chain::create_dependencies() {
  const auto create_row = [](DependencyTable& table, std::string_view shipped) {
    const std::size_t bar = shipped.find('|');
    const std::string_view key = shipped.substr(0, bar);
    table.add_row(key);
    table.add(key);
    while (shipped.find('|') != std::string_view::npos) {
      shipped.remove_prefix(shipped.find('|') + 1);
      const std::string_view cell = shipped.substr(0, shipped.find('|'));
      const std::size_t equals = cell.find('=');
      const std::optional<std::size_t> column = table.column(cell.substr(0, equals));
      if (column && equals != std::string_view::npos)
        table.set(key, static_cast<std::uint32_t>(*column), cell.substr(equals + 1));
    }
  };
  for (const LinkedDependency& d : linked_.dependencies) {
    auto table = std::make_unique<DependencyTable>(*d.dependency);
    for (std::uint32_t i = 0; i < d.dependency->default_row_count; ++i)
      create_row(*table, d.dependency->default_rows[i]);
    for (const TableRow& row : d.element.rows) set_row(*table, row);
    tables_.push_back(std::move(table));
    dependency_options_.push_back(d.options);
  }
  for (const DependencyElement& element : settings_.dependencies) overlay(element);
  for (const auto& [path, value] : settings_.assignments) assign(path, value);
  dependencies_.resize(linked_.dependencies.size());
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    ig_link link{this, &dependency_options_[i], nullptr, tables_[i].get(), {}, false};
    const Calling calling(*d.plugin, d.element.alias.c_str(), "create");
    ig_status status = IG_FAILED;
    try {
      status = d.dependency->create(&link_api(), &link, nullptr, &dependencies_[i]);
    } catch (...) {
      dependencies_[i] = nullptr;
      sink_.add(
          exception_diagnostic(*d.plugin, d.element.alias, "create", place_of(d.element, settings_.dependencies)));
      throw std::runtime_error(d.element.alias + " could not be created");
    }
    if (status == IG_FAILED) {
      dependencies_[i] = nullptr;
      sink_.add(
          host_diagnostic("IG-0308", place_of(d.element, settings_.dependencies), {d.element.alias, link.failure}));
      throw std::runtime_error(d.element.alias + " could not be created");
    }
    refuse_rows(i);
  }
  check_answers();
}

/// Refuses rows that have no meaning; each is reported.
void Chain::refuse_rows(std::size_t dependency) {
  const LinkedDependency& d = linked_.dependencies[dependency];
  if (d.dependency->row_fault == nullptr) return;
  const Calling calling(*d.plugin, d.element.alias.c_str(), "row_fault");
  bool is_sound = true;
  const auto check = [&](const std::string& row, const Location& where) {
    ig_text fault{};
    try {
      fault = d.dependency->row_fault(dependencies_[dependency], {row.data(), row.size()});
    } catch (...) {
      is_sound = false;
      sink_.add(exception_diagnostic(*d.plugin, d.element.alias, "row_fault", where));
      return;
    }
    if (fault.size == 0) return;
    is_sound = false;
    sink_.add(host_diagnostic("IG-0432", where, {d.element.alias, row, std::string(fault.data, fault.size)}));
  };
  const auto check_all = [&](const DependencyElement& element) {
    for (const TableRow& row : element.rows) check(std::string(key_of(*d.dependency, row)), row.where);
  };
  check_all(d.element);
  for (const DependencyElement& given : settings_.dependencies)
    if (is_given(given, d.element)) check_all(given);
  for (const AssignedRow& row : assigned_rows_)
    if (row.dependency == dependency) check(row.name, {"--set"});
  if (!is_sound) throw std::runtime_error(d.element.alias + " has no such row");
}

/// Reports a dependency that was given values although another one answers in its place.
void Chain::check_answers() {
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    if (d.dependency->provides == nullptr || d.dependency->provides[0] == nullptr) continue;
    const bool is_assigned =
        std::any_of(settings_.assignments.begin(), settings_.assignments.end(),
                    [&](const auto& a) { return a.first.substr(0, a.first.find('.')) == d.element.alias; });
    if (d.element.rows.empty() && !is_assigned) continue;
    std::string other;
    bool answers = false;
    for (const char* const* id = d.dependency->provides; *id != nullptr && !answers; ++id) {
      const std::optional<std::size_t> who = answering(*id);
      answers = !who || *who == i;
      if (!answers) other = linked_.dependencies[*who].element.alias;
    }
    if (!answers)
      sink_.add(
          host_diagnostic("IG-0434", is_assigned ? Location{"--set"} : d.element.where, {d.element.alias, other}));
  }
}

void Chain::overlay(const DependencyElement& element) {
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    if (!is_given(element, d.element)) continue;
    for (const Attribute& option : element.options) assign(d.element.alias + "." + option.name, option.value);
    std::vector<Diagnostic> faults = check_rows(*d.dependency, d.element.alias, element.rows);
    for (Diagnostic& fault : faults) sink_.add(std::move(fault));
    if (!faults.empty()) throw std::runtime_error("no such rows of " + d.element.alias);
    for (const TableRow& row : element.rows) set_row(*tables_[i], row);
    return;
  }
  std::vector<std::string> names;
  for (const LinkedDependency& d : linked_.dependencies) names.push_back(d.element.alias);
  const std::string near = nearest_name(element.id, names);
  sink_.add(host_diagnostic("IG-0410", element.where, {element.id}, near.empty() ? "" : "did you mean " + near + "?"));
  throw std::runtime_error("no dependency " + element.id);
}

void Chain::assign(const std::string& path, const std::string& value) {
  const std::size_t dot = path.find('.');
  const std::string name = path.substr(0, dot);
  const std::string rest = dot == std::string::npos ? std::string() : path.substr(dot + 1);
  std::vector<std::string> names;
  std::string hint;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    names.push_back(d.element.alias);
    if (d.element.alias != name) continue;
    for (std::uint32_t o = 0; o < d.dependency->option_count; ++o) {
      if (rest != d.dependency->options[o].name) continue;
      const std::optional<OptionValue> parsed = parse_option(d.dependency->options[o], value);
      if (!parsed) {
        sink_.add(host_diagnostic("IG-0411", {"--set"}, {path, value},
                                  "it must be " + describe_option(d.dependency->options[o])));
        throw std::runtime_error("no value for " + path);
      }
      dependency_options_[i][o] = *parsed;
      return;
    }
    if (rest.empty() || d.dependency->column_count == 0) break;
    // "ROW.COLUMN", or "ROW" alone where it has one value; rows may hold points.
    const std::size_t last = rest.rfind('.');
    std::optional<std::size_t> column;
    if (last != std::string::npos) column = tables_[i]->column(rest.substr(last + 1));
    const std::string row = column ? rest.substr(0, last) : rest;
    if (!column && !has_one_value(*d.dependency)) {
      hint = columns_of(*d.dependency);
      break;
    }
    assigned_rows_.push_back({i, row});
    if (!tables_[i]->set(row, static_cast<std::uint32_t>(column.value_or(0)), std::string_view(value))) {
      sink_.add(host_diagnostic("IG-0411", {"--set"}, {path, value}));
      throw std::runtime_error("no value for " + path);
    }
    return;
  }
  const std::string near = nearest_name(name, names);
  if (hint.empty() && !near.empty() && near != name) hint = "did you mean " + near + "?";
  sink_.add(host_diagnostic("IG-0410", {"--set"}, {path}, hint));
  throw std::runtime_error("no dependency or column " + path);
}

void Chain::create_syntaxes() {
  steps_.resize(linked_.chain.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const LinkedSyntax& s = linked_.chain[i];
    ig_link link{this, &s.options, &s, nullptr, {}, false};
    const Calling calling(*s.plugin, s.element.alias.c_str(), "create");
    ig_status status = IG_FAILED;
    try {
      status = s.syntax->create(&link_api(), &link, s.ids.data(), &steps_[i].self);
    } catch (...) {
      steps_[i].self = nullptr;
      sink_.add(exception_diagnostic(*s.plugin, s.element.alias, "create", s.element.where));
      throw std::runtime_error(s.element.alias + " could not be created");
    }
    if (status == IG_FAILED) {
      steps_[i].self = nullptr;
      sink_.add(host_diagnostic("IG-0308", s.element.where, {s.element.alias, link.failure}));
      throw std::runtime_error(s.element.alias + " could not be created");
    }
    (s.syntax->look_ahead == 0 ? steps_[i].build : steps_[i].build_ahead) = link.is_idle ? nullptr : s.syntax->build;
    if (link.is_idle && i >= linked_.first_build)
      document_.silence(static_cast<std::uint32_t>(i) - linked_.first_build);
    steps_[i].scan = s.syntax->scan;
    if (steps_[i].any_build() != nullptr && i >= linked_.inspection_begin) {
      const std::size_t bit = i - linked_.first_build;
      inspection_[bit / 64] |= std::uint64_t{1} << (bit % 64);
      if (s.syntax->inspects != 0) inspectors_[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
    if (s.syntax->scan != nullptr && s.syntax->triggers != nullptr)
      for (const char* c = s.syntax->triggers; *c != '\0'; ++c)
        scanners_[static_cast<unsigned char>(*c)].push_back(static_cast<std::uint16_t>(i));
  }
}

void Chain::watch_modal_state() {
  for (const WakeWhile& w : linked_.wake_while)
    if (steps_[w.position].any_build() != nullptr) watched_.push_back(w);
  std::stable_sort(watched_.begin(), watched_.end(),
                   [](const WakeWhile& a, const WakeWhile& b) { return a.field < b.field; });
  const std::vector<FieldInfo>& fields = linked_.layout.fields;
  for (std::uint32_t i = 0; i < watched_.size(); ++i) {
    const ig_field field = watched_[i].field;
    if (watches_.empty() || watches_.back().field != field) {
      // A `previous` field changes one block after its source.
      const ig_field original = fields[field].previous_of != IG_NO_FIELD ? fields[field].previous_of : field;
      document_.watch(original, change_of(watches_.size()));
      watches_.push_back({field, i, i, is_carried(fields[original].life), {}});
      // Scanned words bypass `tell_watch`, so check them in every block.
      if (fields[original].life == IG_LIFE_WORD) always_ |= change_of(watches_.size() - 1);
    }
    ++watches_.back().end;
  }
  document_.changes = ~std::uint64_t{0};
}

/// Re-evaluates only the watches whose fields changed, or whose value ended with the previous block; caches the union
/// of the others.
void Chain::look_at_state() {
  const std::uint64_t changes = document_.changes;
  if (changes != changing_) {
    changing_ = changes;
    std::fill(std::begin(awake_by_rest_), std::end(awake_by_rest_), 0);
    for (std::size_t i = 0; i < watches_.size(); ++i)
      for (std::size_t k = 0; k < std::size(awake_by_rest_) && (changes & change_of(i)) == 0; ++k)
        awake_by_rest_[k] |= watches_[i].awake[k];
  }
  std::copy(std::begin(awake_by_rest_), std::end(awake_by_rest_), std::begin(awake_by_state_));
  document_.changes = 0;
  passing_ = always_;
  for (std::uint64_t open = changes; open != 0; open &= open - 1) {
    const auto first = static_cast<std::size_t>(__builtin_ctzll(open));
    const std::size_t last = first == last_change ? watches_.size() : first + 1;
    for (std::size_t i = first; i < std::min(last, watches_.size()); ++i) look_at(watches_[i], change_of(i));
  }
}

void Chain::look_at(Watch& watch, std::uint64_t change) {
  std::fill(std::begin(watch.awake), std::end(watch.awake), 0);
  if (!document_.present(watch.field)) return;
  if (!watch.is_modal) passing_ |= change;
  const std::uint64_t value = document_.value(watch.field).symbol;
  for (std::uint32_t i = watch.begin; i < watch.end; ++i) {
    const WakeWhile& w = watched_[i];
    if (w.value != 0 && w.value != value) continue;
    const std::uint32_t place = w.position - linked_.first_build;
    watch.awake[place / 64] |= std::uint64_t{1} << (place % 64);
    awake_by_state_[place / 64] |= std::uint64_t{1} << (place % 64);
  }
}

const void* Chain::service(std::string_view id) const {
  if (id == IG_FLOW_SERVICE) return &flow_service_;
  const std::optional<std::size_t> who = answering(id);
  return who ? service_of(*linked_.dependencies[*who].dependency, dependencies_[*who], id) : nullptr;
}

/// Dependencies from the run's files come first, those of the last file before all; then the dialect's, in its order.
std::optional<std::size_t> Chain::answering(std::string_view id) const {
  const auto answers = [&](std::size_t i) {
    return service_of(*linked_.dependencies[i].dependency, dependencies_[i], id) != nullptr;
  };
  for (std::size_t given = settings_.dependencies.size(); given-- > 0;)
    for (std::size_t i = 0; i < dependencies_.size(); ++i)
      if (is_given(settings_.dependencies[given], linked_.dependencies[i].element) && answers(i)) return i;
  for (std::size_t i = 0; i < dependencies_.size(); ++i)
    if (answers(i)) return i;
  return std::nullopt;
}

DependencyTable* Chain::table(std::string_view dependency) {
  for (std::size_t i = 0; i < tables_.size(); ++i)
    if (linked_.dependencies[i].element.alias == dependency) return tables_[i].get();
  return nullptr;
}

std::string_view Chain::setting(std::string_view name) const {
  const auto found = settings_.settings.find(name);
  return found == settings_.settings.end() ? std::string_view{} : found->second;
}

void Chain::start(std::string_view file) {
  running = &document_;
  document_.begin({file, 0, 0, {}, false});
  ends_program = ends_file = false;
  for (const auto& [field, value] : linked_.initial) document_.set(field, value);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const ig_run_fn restart = linked_.chain[i].syntax->restart;
    if (restart == nullptr) continue;
    document_.current = static_cast<std::uint16_t>(i + 1);
    const Calling calling(*linked_.chain[i].plugin, linked_.chain[i].element.alias.c_str(), "restart");
    try {
      restart(steps_[i].self, host_, document_.block());
    } catch (...) {
      tell_exception(document_, "restart");
    }
  }
  document_.current = 0;
}

void Chain::begin_block(const BlockSource& source) {
  running = &document_;
  if (source.is_joined && joined_ != nullptr) joined_->forget();
  document_.begin(source);
  document_.changes |= passing_;
  if (document_.changes != 0) look_at_state();
  std::copy(std::begin(awake_by_state_), std::end(awake_by_state_), std::begin(document_.active));
  ++blocks;
  ends_program = ends_file = alarmed = skip_rest = false;
  split_at = 0;
  failure_said_by = 0;
}

void Chain::wake(Document& d, std::size_t position) const {
  const std::size_t bit = position - linked_.first_build;
  d.active[bit / 64] |= std::uint64_t{1} << (bit % 64);
}

bool Chain::is_awake(const Document& d, std::size_t position) const {
  const std::size_t bit = position - linked_.first_build;
  return (d.active[bit / 64] >> (bit % 64) & 1) != 0;
}

/// No scanner accepted this byte of the text.
[[gnu::cold]] void Chain::leave_byte(Document& d, std::size_t position) {
  d.current = 0;
  const auto c = static_cast<unsigned char>(d.source.text[position]);
  const auto begin = static_cast<std::uint32_t>(position);
  if (c < 0x20) {
    constexpr char digits[] = "0123456789ABCDEF";
    const Diagnostic control = host_diagnostic("IG-0412", {}, {{digits[c >> 4], digits[c & 15]}});
    report(d, control.severity, control.code, control.message, begin, begin + 1);
  }
  d.add_leftover(IG_LEFT_TEXT, IG_NO_FIELD, begin, begin + 1, d.source.text.substr(position, 1));
}

/// A scanner that claims bytes beyond the text cannot have seen them: the byte stays unscanned.
[[gnu::cold]] std::size_t Chain::refuse_end(std::size_t at) {
  const LinkedSyntax& s = linked_.chain[document_.current - 1u];
  const Diagnostic text = host_diagnostic(
      "IG-0402", {}, {s.element.alias, "its scan() returned an end after the text, so its bytes stay unscanned"});
  report(document_, text.severity, text.code, text.message, static_cast<std::uint32_t>(at),
         static_cast<std::uint32_t>(at + 1));
  return at;
}

/// Scans from the position on. The position is the caller's variable, because a scanner may throw.
[[gnu::always_inline]] inline void Chain::scan_from(std::size_t& position) {
  Document& d = document_;
  const char* const text = d.source.text.data();
  const std::size_t size = d.source.text.size();
  while (position < size) {
    const auto c = static_cast<unsigned char>(text[position]);
    if (is_blank(c)) {
      ++position;
      continue;
    }
    if (c == '\r' || c == '\n') {  // a lone carriage return also ends a line
      if (d.source.is_joined) {
        ++position;
        continue;
      }
      split_at = position + 1;
      break;
    }
    std::size_t next = position;
    for (const std::uint16_t scanner : scanners_[c]) {
      const Step& step = steps_[scanner];
      d.current = static_cast<std::uint16_t>(scanner + 1);
      next = step.scan(step.self, host_, d.block(), text, size, position);
      if (next > position) break;
    }
    if (next > size) [[unlikely]]
      next = refuse_end(position);
    if (next <= position) {
      next = position + 1;
      leave_byte(d, position);
    }
    position = next;
    if (split_at != 0 || skip_rest || ends_file) break;
  }
}

std::size_t Chain::scan() {
  const std::size_t size = document_.source.text.size();
  std::size_t position = 0;
  is_scanning_ = true;
  for (bool is_done = false; !is_done;) try {
      scan_from(position);
      is_done = true;
    } catch (...) {
      tell_exception(document_, "scan");
      leave_byte(document_, position++);
    }
  is_scanning_ = false;
  document_.current = 0;
  return split_at != 0 ? std::min(split_at, size) : size;
}

std::size_t Chain::scan_with(std::uint32_t position) {
  for (auto& list : scanners_) list.clear();
  const ig_syntax& syntax = *linked_.chain[position].syntax;
  if (syntax.scan != nullptr && syntax.triggers != nullptr)
    for (const char* c = syntax.triggers; *c != '\0'; ++c)
      scanners_[static_cast<unsigned char>(*c)].push_back(static_cast<std::uint16_t>(position));
  return scan();
}

void Chain::call_watched(Document& d, std::uint32_t position) {
  const Step& step = steps_[position];
  const ig_run_fn run_step = step.any_build();
  if (settings_.mode == Mode::traced) {
    if (trace) trace(position, true);
    const ig_status status = run_step(step.self, host_, d.block());
    if (status == IG_FAILED) tell_failure(d, position);
    if (trace) trace(position, false);
    return;
  }
  const Document before = d;
  const bool is_awake_itself = is_awake(d, position);
  const std::uint64_t reports_before = reports_;
  const ig_status status = run_step(step.self, host_, d.block());
  if (status == IG_FAILED) tell_failure(d, position);
  if (!is_awake_itself && (reports_ != reports_before || !d.same_content(before))) {
    const Diagnostic text = host_diagnostic("IG-0240", {}, {linked_.chain[position].element.alias});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
  std::string fault;
  if (status != IG_UNCHANGED && status != IG_CHANGED && status != IG_FAILED)
    fault = "its build() returned the status " + std::to_string(status);
  else if (status == IG_UNCHANGED && !d.same_content(before))
    fault = "its build() says unchanged, but the block changed";
  if (!fault.empty()) {
    const Diagnostic text = host_diagnostic("IG-0402", {}, {linked_.chain[position].element.alias, fault});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
}

/// The SDK's trampoline has reported the reason; a plugin without the SDK may not have.
void Chain::tell_failure(const Document& d, std::uint32_t position) {
  if (failure_said_by != position + 1) {
    const Diagnostic text =
        host_diagnostic("IG-0401", {}, {linked_.chain[position].element.alias, "its build() gives no reason"});
    report(d, text.severity, text.code, text.message, 0, 0);
  }
  failure_said_by = 0;
}

/// Reports an exception of the running syntax; exceptions of the host are rethrown.
[[gnu::cold]] void Chain::tell_exception(const Document& d, const char* phase) {
  if (d.current == 0) throw;
  const std::uint32_t position = d.current - 1u;
  const LinkedSyntax& s = linked_.chain[position];
  const Diagnostic text = exception_diagnostic(*s.plugin, s.element.alias, phase, {});
  report(d, text.severity, text.code, text.message, 0, 0);
  failure_said_by = 0;
}

/// Calls a syntax that looks ahead. False when it, and every later syntax, has to wait for the blocks ahead.
bool Chain::call_looking_ahead(Document& d, std::uint32_t position, std::uint32_t first) {
  const Step& step = steps_[position];
  if (step.build_ahead == nullptr) return true;
  if (first < std::min(position, linked_.post_logic_begin)) {
    waits_at = position;
    d.current = 0;
    return false;
  }
  d.current = static_cast<std::uint16_t>(position + 1);
  ++builds;
  if (settings_.mode != Mode::fast)
    call_watched(d, position);
  else if (step.build_ahead(step.self, host_, d.block()) == IG_FAILED)
    tell_failure(d, position);
  return true;
}

/// Calls the syntaxes that are awake. `begin` is where this pass over the block began: a syntax that looks ahead may
/// have to wait. Plain is the fast mode without call_all, which pays for neither.
template <bool is_plain>
[[gnu::always_inline]] inline void Chain::call_steps(Document& d, std::uint32_t begin, std::uint32_t first,
                                                     std::uint32_t last) {
  const std::uint32_t origin = linked_.first_build;
  const bool is_watched = !is_plain && settings_.mode != Mode::fast;
  const std::uint64_t forced = !is_plain && settings_.call_all ? ~std::uint64_t{0} : 0;
  first = std::max(first, origin) - origin;
  last = std::max(last, origin) - origin;
  ig_block* const block = d.block();
  for (std::uint32_t base = first & ~63u; base < last; base += 64) {
    std::uint64_t reach = base < first ? ~std::uint64_t{0} << (first - base) : ~std::uint64_t{0};
    if (last - base < 64) reach &= ~(~std::uint64_t{0} << (last - base));
    const std::uint64_t& active = d.active[base / 64];
    const Step* const steps = steps_.data() + origin + base;
    while (const std::uint64_t awake = (active | forced) & reach) {
      const auto bit = static_cast<unsigned>(__builtin_ctzll(awake));
      reach &= ~std::uint64_t{1} << bit;
      const Step& step = steps[bit];
      const std::uint32_t position = origin + base + bit;
      if (step.build == nullptr) [[unlikely]] {
        if (!call_looking_ahead(d, position, begin)) return;
        continue;
      }
      d.current = static_cast<std::uint16_t>(position + 1);
      ++builds;
      if (is_watched)
        call_watched(d, position);
      else if (step.build(step.self, host_, block) == IG_FAILED) [[unlikely]]
        tell_failure(d, position);
    }
  }
  d.current = 0;
}

void Chain::run_range(Document& d, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t next = first; next < last;) try {
      if (is_plain_)
        call_steps<true>(d, first, next, last);
      else
        call_steps<false>(d, first, next, last);
      next = last;
    } catch (...) {
      next = d.current;
      tell_exception(d, "build");
    }
}

void Chain::run(Document& d, std::uint32_t first, std::uint32_t last) {
  running = &d;
  const std::uint32_t inspection = std::clamp(linked_.inspection_begin, first, last);
  run_range(d, first, inspection);
  if (inspection != last && waits_at == 0) inspect(d, inspection, last);
  running = &document_;  // a block of the look-ahead window ends before the chain does
}

inline void Chain::inspect(Document& d, std::uint32_t first, std::uint32_t last) {
  if (d.has_leftovers())
    for (std::size_t k = 0; k < std::size(inspectors_); ++k) d.active[k] |= inspectors_[k];
  std::uint64_t awake = 0;
  for (std::size_t k = 0; k < std::size(inspection_); ++k) awake |= d.active[k] & inspection_[k];
  if (awake != 0 || settings_.call_all) run_range(d, first, last);
}

ig_status Chain::build(std::uint32_t position) {
  const Step& step = steps_[position];
  const ig_run_fn run_step = step.any_build();
  if (run_step == nullptr) return IG_UNCHANGED;
  running = &document_;
  document_.current = static_cast<std::uint16_t>(position + 1);
  ig_status status = IG_FAILED;
  try {
    status = run_step(step.self, host_, document_.block());
    if (status == IG_FAILED) tell_failure(document_, position);
  } catch (...) {
    tell_exception(document_, "build");
  }
  document_.current = 0;
  return status;
}

/// A range that reaches into the next line is cut at the end of its own line.
void Chain::place_in_joined(const Document& d, std::uint32_t begin, std::uint32_t end, Diagnostic& out) {
  const BlockSource& source = d.source;
  if (joined_ == nullptr) joined_ = std::make_unique<LinePlaces>();
  const LinePlace place = &d == &document_ ? joined_->at(source.text, begin) : LinePlace::of(source.text, begin);
  const auto column = static_cast<std::uint32_t>(begin - place.begin) + (place.line == 0 ? source.column : 0);
  out.where.line = source.line + place.line;
  out.where.column = column + 1;
  if (end <= begin) return;
  const std::string_view behind = source.text.substr(std::min<std::size_t>(begin, source.text.size()));
  const std::size_t size = behind.substr(0, end - begin).find_first_of("\r\n");
  out.end_column = column + 1 + static_cast<std::uint32_t>(std::min<std::size_t>(end - begin, size));
}

void Chain::report(const Document& d, Severity severity, std::string_view code, std::string message,
                   std::uint32_t begin, std::uint32_t end, std::string hint) {
  ++reports_;
  const auto& severities = linked_.dialect.severities;
  if (!severities.empty())
    if (const auto found = severities.find(std::string(code)); found != severities.end()) severity = found->second;
  Diagnostic out{severity, std::string(code), std::move(message), {}, 0, std::move(hint)};
  out.where = {std::string(d.source.file), d.source.line, d.source.column + begin + 1};
  if (end > begin) out.end_column = d.source.column + end + 1;
  if (d.source.is_joined) [[unlikely]]
    place_in_joined(d, begin, end, out);
  sink_.add(std::move(out));
}

const Breadcrumb& Chain::breadcrumb() {
  static thread_local Breadcrumb crumb;
  crumb = outside_blocks;
  if (crumb.syntax != nullptr || running == nullptr) return crumb;
  crumb.document = running;
  if (running->current == 0 || running->chain == nullptr) return crumb;
  const LinkedSyntax& s = running->chain->linked_.chain[running->current - 1u];
  crumb.plugin = s.plugin->name;
  crumb.syntax = s.syntax->id;
  crumb.phase = running->chain->is_scanning_ ? "scan" : "build";
  return crumb;
}

}  // namespace isogloss
