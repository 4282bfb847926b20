/// Makes a plugin of structs: SyntaxSpec, DependencySpec and ImporterSpec, Register, and the entry function
/// ISOGLOSS_PLUGIN. No exception leaves the functions that cross the boundary: the host reports its text.
#pragma once

#include <isogloss_scan.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <span>

#include "isogloss/dependency.hpp"
#include "isogloss/diagnostics.hpp"
#include "isogloss/importer.hpp"
#include "isogloss/motion.hpp"
#include "isogloss/pages.hpp"
#include "isogloss/spec.hpp"

namespace ig {

/// What a syntax declares besides its members; a static member `spec` of the struct. Make it with ig::syntax().
struct SyntaxSpec {
  const char* id;
  const char* summary;
  NameList after_names{}, before_names{};
  const char* exclusive_slot = nullptr;
  const char* first_writer_slot = nullptr;
  const char* trigger_bytes = nullptr;
  std::uint32_t look_ahead = 0;
  std::uint32_t inspects = 0;
  std::uint32_t scan_flags = 0;

  /// The syntax runs after (before) the syntaxes with these ids, where the chain has them.
  template <class... S>
  constexpr SyntaxSpec after(S... ids) const {
    SyntaxSpec s = *this;
    (s.after_names.add(ids), ...);
    return s;
  }
  template <class... S>
  constexpr SyntaxSpec before(S... ids) const {
    SyntaxSpec s = *this;
    (s.before_names.add(ids), ...);
    return s;
  }
  /// Only one syntax of a chain may claim this slot.
  constexpr SyntaxSpec exclusive(const char* slot) const {
    SyntaxSpec s = *this;
    s.exclusive_slot = slot;
    return s;
  }
  /// Several syntaxes may share this slot; the first one that writes in a block wins.
  constexpr SyntaxSpec first_writer(const char* slot) const {
    SyntaxSpec s = *this;
    s.first_writer_slot = slot;
    return s;
  }
  /// The host calls scan() where one of these bytes begins text that no scanner has taken yet.
  constexpr SyntaxSpec scans(const char* bytes) const {
    SyntaxSpec s = *this;
    s.trigger_bytes = bytes;
    return s;
  }
  /// scan() may be asked ahead of the block's turn, on another instance, in another thread, for text that may never be
  /// executed. But for values that it gets from the block, the text alone decides what it finds. Before it does
  /// anything outside the block, or keeps something for build(), it asks Block::is_in_turn().
  constexpr SyntaxSpec scans_ahead() const {
    SyntaxSpec s = *this;
    s.scan_flags |= IG_SCANS_AHEAD;
    return s;
  }
  /// build() may read as many executed blocks ahead with Block::ahead().
  constexpr SyntaxSpec looks_ahead(std::uint32_t blocks) const {
    SyntaxSpec s = *this;
    s.look_ahead = blocks;
    return s;
  }
  /// build() runs in blocks that have leftovers.
  constexpr SyntaxSpec inspects_leftovers() const {
    SyntaxSpec s = *this;
    s.inspects = 1;
    return s;
  }
};

/// `id` is the XML element of the dialect file, `summary` one sentence.
constexpr SyntaxSpec syntax(const char* id, const char* summary) { return {.id = id, .summary = summary}; }

/// What a dependency declares besides its members; a static member `spec` of the struct. Make it with ig::dependency().
struct DependencySpec {
  const char* id;
  const char* summary;
  const char* row_element = nullptr;
  const char* row_key = nullptr;
  NameList services{};
  std::span<const char* const> shipped{};

  /// The dependency has a table: `element` is the XML element of a row, `key` the attribute that names it.
  constexpr DependencySpec rows(const char* element, const char* key) const {
    DependencySpec d = *this;
    d.row_element = element;
    d.row_key = key;
    return d;
  }
  template <class... S>
  constexpr DependencySpec provides(S... ids) const {
    DependencySpec d = *this;
    (d.services.add(ids), ...);
    return d;
  }
  /// The rows of the table before any file gives some, each "key|column=value|…".
  constexpr DependencySpec ships(std::span<const char* const> rows) const {
    DependencySpec d = *this;
    d.shipped = rows;
    return d;
  }
};

/// `id` is the XML element of the dialect file, `summary` one sentence.
constexpr DependencySpec dependency(const char* id, const char* summary) { return {.id = id, .summary = summary}; }

namespace detail {

inline void report_failure(const ig_link_api* api, ig_link* link, const char* what) { api->fail(link, to_text(what)); }

template <class T>
ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) noexcept {
  try {
    Binding bound{api, link, ids, &recorded_of<T>()};
    const Scope<Binding> scope(binding, &bound);
    auto made = std::make_unique<T>();
    bound.expect_all();
    *self = made.release();
    return IG_CHANGED;
  } catch (const std::exception& e) {
    report_failure(api, link, e.what());
  } catch (...) {
    report_failure(api, link, "an exception that is no std::exception");
  }
  return IG_FAILED;
}

template <class T>
void destroy(void* self) noexcept {
  delete static_cast<T*>(self);
}

inline ig_status fault(const ig_host* host, ig_block* block, const char* what) noexcept {
  host->fault(block, {what, std::char_traits<char>::length(what)});
  return IG_FAILED;
}

template <class T, class F>
ig_status guarded(void* self, const ig_host* host, ig_block* block, F&& f) noexcept {
  try {
    Block b(host, block);
    return static_cast<ig_status>(f(*static_cast<T*>(self), b));
  } catch (const std::exception& e) {
    return fault(host, block, e.what());
  } catch (...) {
    return fault(host, block, "an exception that is no std::exception");
  }
}

template <class T>
ig_status build(void* self, const ig_host* host, ig_block* block) noexcept {
  return guarded<T>(self, host, block, [](T& t, Block& b) { return t.build(b); });
}

template <class T>
ig_status restart(void* self, const ig_host* host, ig_block* block) noexcept {
  return guarded<T>(self, host, block, [](T& t, Block& b) { return t.restart(b); });
}

template <class T>
std::size_t scan(void* self, const ig_host* host, ig_block* block, const char* text, std::size_t size,
                 std::size_t position) noexcept {
  try {
    Block b(host, block);
    return static_cast<T*>(self)->scan(b, std::string_view(text, size), position);
  } catch (const std::exception& e) {
    fault(host, block, e.what());
  } catch (...) {
    fault(host, block, "an exception that is no std::exception");
  }
  return position;
}

template <class T>
std::uint32_t count(const std::vector<T>& v) {
  return static_cast<std::uint32_t>(v.size());
}

template <class T>
class SyntaxDescriptor {
 public:
  SyntaxDescriptor() {
    recorded_.fields.reserve(16);  // most have as many
    {
      const Scope<Recorder> scope(recorder, &recorded_);
      [[maybe_unused]] const T prototype{};
    }
    out_.struct_size = sizeof out_;
    out_.look_ahead = T::spec.look_ahead;
    out_.id = T::spec.id;
    out_.summary = T::spec.summary;
    const std::string file = snake_case(T::spec.id);
    out_.page = embedded_page(file.c_str());
    out_.folder = embedded_folder(file.c_str());
    out_.cases = embedded_page((file + ".cases").c_str());
    out_.fields = recorded_.fields.data();
    out_.options = recorded_.options.data();
    out_.services = recorded_.services.data();
    out_.field_count = count(recorded_.fields);
    out_.option_count = count(recorded_.options);
    out_.service_count = count(recorded_.services);
    out_.inspects = T::spec.inspects;
    out_.scan_flags = T::spec.scan_flags;
    out_.after = T::spec.after_names.data();
    out_.before = T::spec.before_names.data();
    out_.exclusive_slot = T::spec.exclusive_slot;
    out_.first_writer_slot = T::spec.first_writer_slot;
    out_.triggers = T::spec.trigger_bytes;
    out_.create = &detail::create<T>;
    out_.destroy = &detail::destroy<T>;
    if constexpr (requires(T & t, Block & b) { t.restart(b); }) out_.restart = &detail::restart<T>;
    if constexpr (requires(T & t, Block & b) { t.scan(b, std::string_view{}, std::size_t{}); })
      out_.scan = &detail::scan<T>;
    if constexpr (requires(T & t, Block & b) { t.build(b); }) out_.build = &detail::build<T>;
  }
  const ig_syntax* get() const { return &out_; }
  const Recorder& recorded() const { return recorded_; }

 private:
  Recorder recorded_;
  ig_syntax out_{};
};

/// Asks T::row_fault() why a row has no meaning; an empty text where it has one.
template <class T>
ig_text row_fault(void* self, ig_text row) noexcept {
  try {
    thread_local std::string answer;
    answer = static_cast<const T*>(self)->row_fault(to_view(row));
    return to_text(answer);
  } catch (...) {
    return to_text("it cannot be looked at");
  }
}

template <class T>
class DependencyDescriptor {
 public:
  DependencyDescriptor() {
    {
      const Scope<Recorder> scope(recorder, &recorded_);
      [[maybe_unused]] const T prototype{};
    }
    out_.struct_size = sizeof out_;
    out_.column_count = count(recorded_.columns);
    out_.id = T::spec.id;
    out_.summary = T::spec.summary;
    out_.page = embedded_page(snake_case(T::spec.id).c_str());
    out_.row_element = T::spec.row_element;
    out_.row_key = T::spec.row_key;
    out_.columns = recorded_.columns.data();
    out_.options = recorded_.options.data();
    out_.provides = T::spec.services.data();
    out_.option_count = count(recorded_.options);
    out_.default_row_count = static_cast<std::uint32_t>(T::spec.shipped.size());
    out_.default_rows = T::spec.shipped.data();
    out_.create = &detail::create<T>;
    out_.destroy = &detail::destroy<T>;
    out_.service = [](void* self, const char* id) noexcept -> const void* {
      try {
        return static_cast<T*>(self)->service(id);
      } catch (...) {
        return nullptr;
      }
    };
    if constexpr (requires(const T& t) { t.row_fault(std::string_view{}); }) out_.row_fault = &detail::row_fault<T>;
  }
  const ig_dependency* get() const { return &out_; }
  const Recorder& recorded() const { return recorded_; }

 private:
  Recorder recorded_;
  ig_dependency out_{};
};

template <class T>
constexpr bool is_syntax = std::is_same_v<std::remove_cv_t<decltype(T::spec)>, SyntaxSpec>;

template <class T>
constexpr bool is_importer = std::is_same_v<std::remove_cv_t<decltype(T::spec)>, ImporterSpec>;

template <class T>
const auto& descriptor_of() {
  static const std::conditional_t<is_syntax<T>, SyntaxDescriptor<T>,
                                  std::conditional_t<is_importer<T>, ImporterDescriptor<T>, DependencyDescriptor<T>>>
      descriptor;
  return descriptor;
}

template <class T>
const Recorder& recorded_of() {
  return descriptor_of<T>().recorded();
}

/// The syntaxes, dependencies and importers of the plugin's files, complete before the entry function can be called.
struct Contributions {
  std::vector<const ig_syntax* (*)()> syntaxes;
  std::vector<const ig_dependency* (*)()> dependencies;
  std::vector<const ig_importer* (*)()> importers;
};
inline Contributions& contributions() {
  static Contributions all;
  return all;
}

class PluginDescriptor {
 public:
  PluginDescriptor(const char* name, const char* version, const char* vendor,
                   std::span<const ig_diagnostic_decl> leading = {}) {
    for (const auto describe : contributions().syntaxes) syntaxes_.push_back(describe());
    for (const auto describe : contributions().dependencies) dependencies_.push_back(describe());
    for (const auto describe : contributions().importers) importers_.push_back(describe());
    const auto by_id = [](const auto* a, const auto* b) { return std::string_view(a->id) < b->id; };
    std::sort(syntaxes_.begin(), syntaxes_.end(), by_id);
    std::sort(dependencies_.begin(), dependencies_.end(), by_id);
    std::sort(importers_.begin(), importers_.end(), by_id);
    const std::span<const ig_diagnostic_decl> diagnostics = diagnostic_table().complete(leading);
    out_.struct_size = sizeof out_;
    out_.abi_major = IG_ABI_MAJOR;
    out_.abi_minor = IG_ABI_MINOR;
    out_.syntax_count = count(syntaxes_);
    out_.name = name;
    out_.version = version;
    out_.vendor = vendor;
    out_.built_with = "isogloss sdk, " __VERSION__;
    out_.syntaxes = syntaxes_.data();
    out_.dependencies = dependencies_.data();
    out_.diagnostics = diagnostics.data();
    out_.dependency_count = count(dependencies_);
    out_.diagnostic_count = static_cast<std::uint32_t>(diagnostics.size());
    out_.importers = importers_.data();
    out_.importer_count = count(importers_);
  }
  const ig_plugin* get() const { return &out_; }

 private:
  std::vector<const ig_syntax*> syntaxes_;
  std::vector<const ig_dependency*> dependencies_;
  std::vector<const ig_importer*> importers_;
  ig_plugin out_{};
};

}  // namespace detail

/// Puts a syntax, a dependency or an importer into the plugin, with its diagnostics: `const ig::Register<DrillingCycle>
/// drilling_cycle_syntax;` at the end of its file, under any name that is unique in the plugin.
template <class T>
struct Register {
  Register() {
    if constexpr (requires { T::diagnostics; }) detail::diagnostic_table().add(T::diagnostics);
    if constexpr (detail::is_syntax<T>)
      detail::contributions().syntaxes.push_back([] { return detail::descriptor_of<T>().get(); });
    else if constexpr (detail::is_importer<T>)
      detail::contributions().importers.push_back([] { return detail::descriptor_of<T>().get(); });
    else
      detail::contributions().dependencies.push_back([] { return detail::descriptor_of<T>().get(); });
  }
};

}  // namespace ig

/// Defines the plugin's entry function, once in a plugin: ISOGLOSS_PLUGIN("acme", "1.0.0", "Acme"). An optional fourth
/// argument, an array of ig_diagnostic_decl, comes first in the table of diagnostics, for a plugin that raises its
/// diagnostics by index.
#define ISOGLOSS_PLUGIN(name, version, vendor, ...)                                                           \
  extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) {                                                  \
    try {                                                                                                     \
      static const ig::detail::PluginDescriptor descriptor(name, version, vendor __VA_OPT__(, ) __VA_ARGS__); \
      return descriptor.get();                                                                                \
    } catch (...) {                                                                                           \
      return nullptr;                                                                                         \
    }                                                                                                         \
  }
