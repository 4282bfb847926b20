/// From a struct with members and build() to the descriptor that crosses the boundary.
#pragma once

#include <algorithm>
#include <exception>
#include <memory>
#include <span>

#include "isogloss/dependency.hpp"
#include "isogloss/motion.hpp"
#include "isogloss/pages.hpp"

namespace ig {

/// Names at most N other syntaxes or services; literal so that a spec is a constant.
struct NameList {
  std::array<const char*, 12> names{};
  std::size_t count = 0;
  constexpr void add(const char* name) { names[count++] = name; }  // one past N does not compile: the spec is constexpr
  const char* const* data() const { return count == 0 ? nullptr : names.data(); }
};

struct SyntaxSpec {
  const char* id;
  const char* summary;
  NameList after_names{}, before_names{};
  const char* exclusive_slot = nullptr;
  const char* first_writer_slot = nullptr;
  const char* trigger_bytes = nullptr;
  std::uint32_t look_ahead = 0;
  std::uint32_t inspects = 0;

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
  /// Several share this slot; the first that writes in a block wins.
  constexpr SyntaxSpec first_writer(const char* slot) const {
    SyntaxSpec s = *this;
    s.first_writer_slot = slot;
    return s;
  }
  /// scan() is asked where one of these bytes begins what nobody took yet.
  constexpr SyntaxSpec scans(const char* bytes) const {
    SyntaxSpec s = *this;
    s.trigger_bytes = bytes;
    return s;
  }
  constexpr SyntaxSpec looks_ahead(std::uint32_t blocks) const {
    SyntaxSpec s = *this;
    s.look_ahead = blocks;
    return s;
  }
  /// build() runs in blocks of which something is left over.
  constexpr SyntaxSpec inspects_leftovers() const {
    SyntaxSpec s = *this;
    s.inspects = 1;
    return s;
  }
};

constexpr SyntaxSpec syntax(const char* id, const char* summary) { return {.id = id, .summary = summary}; }

struct DependencySpec {
  const char* id;
  const char* summary;
  const char* row_element = nullptr;
  const char* row_key = nullptr;
  NameList services{};
  std::span<const char* const> shipped{};

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
  /// "key|column=value|…", the rows it has before any file says something.
  constexpr DependencySpec ships(std::span<const char* const> rows) const {
    DependencySpec d = *this;
    d.shipped = rows;
    return d;
  }
};

constexpr DependencySpec dependency(const char* id, const char* summary) { return {.id = id, .summary = summary}; }

constexpr ig_diagnostic_decl diagnostic(ig_severity severity, const char* code, const char* text,
                                        const char* explanation, const char* example) {
  return {sizeof(ig_diagnostic_decl), severity, code, text, explanation, example};
}

namespace detail {

/// DrillingCycleSyntax -> drilling_cycle_syntax; a run of capitals or digits stays together.
inline std::string snake_case(std::string_view id) {
  std::string out;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const char c = id[i];
    const bool upper = c >= 'A' && c <= 'Z';
    const bool after_upper = i > 0 && id[i - 1] >= 'A' && id[i - 1] <= 'Z';
    if (upper && i > 0 && !after_upper) out += '_';
    out += upper ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

inline void report_failure(const ig_link_api* api, ig_link* link, const char* what) { api->fail(link, to_text(what)); }

template <class T>
ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) noexcept {
  try {
    Binding bound{api, link, ids};
    const Scope<Binding> scope(binding, &bound);
    *self = std::make_unique<T>().release();
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
    {
      const Scope<Recorder> scope(recorder, &recorded_);
      [[maybe_unused]] const T prototype{};
    }
    out_.struct_size = sizeof out_;
    out_.look_ahead = T::spec.look_ahead;
    out_.id = T::spec.id;
    out_.summary = T::spec.summary;
    out_.page = embedded_page(snake_case(T::spec.id).c_str());
    out_.fields = recorded_.fields.data();
    out_.options = recorded_.options.data();
    out_.services = recorded_.services.data();
    out_.field_count = count(recorded_.fields);
    out_.option_count = count(recorded_.options);
    out_.service_count = count(recorded_.services);
    out_.inspects = T::spec.inspects;
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

 private:
  Recorder recorded_;
  ig_syntax out_{};
};

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
  }
  const ig_dependency* get() const { return &out_; }

 private:
  Recorder recorded_;
  ig_dependency out_{};
};

/// What the .cpp files of one plugin have put in; filled before the entry function can be called.
struct Contributions {
  std::vector<const ig_syntax* (*)()> syntaxes;
  std::vector<const ig_dependency* (*)()> dependencies;
};
inline Contributions& contributions() {
  static Contributions all;
  return all;
}

class PluginDescriptor {
 public:
  PluginDescriptor(const char* name, const char* version, const char* vendor,
                   std::span<const ig_diagnostic_decl> diagnostics) {
    for (const auto describe : contributions().syntaxes) syntaxes_.push_back(describe());
    for (const auto describe : contributions().dependencies) dependencies_.push_back(describe());
    const auto by_id = [](const auto* a, const auto* b) { return std::string_view(a->id) < b->id; };
    std::sort(syntaxes_.begin(), syntaxes_.end(), by_id);
    std::sort(dependencies_.begin(), dependencies_.end(), by_id);
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
  }
  const ig_plugin* get() const { return &out_; }

 private:
  std::vector<const ig_syntax*> syntaxes_;
  std::vector<const ig_dependency*> dependencies_;
  ig_plugin out_{};
};

}  // namespace detail

/// `const ig::Register<DrillingCycle> registered;` at the end of a syntax's file puts it into the plugin.
template <class T>
struct Register {
  Register() {
    if constexpr (std::is_same_v<std::remove_cv_t<decltype(T::spec)>, SyntaxSpec>) {
      detail::contributions().syntaxes.push_back([]() -> const ig_syntax* {
        static const detail::SyntaxDescriptor<T> descriptor;
        return descriptor.get();
      });
    } else {
      detail::contributions().dependencies.push_back([]() -> const ig_dependency* {
        static const detail::DependencyDescriptor<T> descriptor;
        return descriptor.get();
      });
    }
  }
};

}  // namespace ig

/// The plugin's entry, once per plugin. `diagnostics` is its table, an array of ig_diagnostic_decl.
#define ISOGLOSS_PLUGIN(name, version, vendor, diagnostics)                                     \
  extern "C" IG_EXPORT const ig_plugin* ig_plugin_v1(void) {                                    \
    try {                                                                                       \
      static const ig::detail::PluginDescriptor descriptor(name, version, vendor, diagnostics); \
      return descriptor.get();                                                                  \
    } catch (...) {                                                                             \
      return nullptr;                                                                           \
    }                                                                                           \
  }
