/// Members of a syntax or dependency for what comes from outside: options of the dialect file, services of
/// dependencies, settings of the command line. The host checks the types and ranges of options before an instance is
/// created.
#pragma once

#include "isogloss/fields.hpp"

namespace ig {

/// The allowed values, inclusive; without bounds by default.
struct Range {
  double minimum = -HUGE_VAL;
  double maximum = HUGE_VAL;
};

namespace detail {

inline std::uint32_t declare_option(const char* name, ig_option_type type, const char* fallback, const char* choices,
                                    Range range, const char* unit, const char* doc) {
  if (recorder != nullptr) {
    ig_option_decl out{};
    out.struct_size = sizeof out;
    out.type = type;
    out.name = name;
    out.fallback = fallback;
    out.choices = choices;
    out.minimum = range.minimum;
    out.maximum = range.maximum;
    out.unit = unit;
    out.doc = doc;
    recorder->options.push_back(out);
    return 0;
  }
  if (binding == nullptr) refuse_stray("option", {name, {}, {}, {}});
  binding->expect("option", &Recorder::options, &ig_option_decl::name, binding->option, name);
  return binding->option++;
}

}  // namespace detail

/// An option. `fallback` is its default, written as in the dialect file; nullptr: the option must be given.
class NumberOption {
 public:
  NumberOption(const char* name, const char* fallback, Range range, const char* unit, const char* doc) {
    const std::uint32_t i = detail::declare_option(name, IG_OPTION_NUMBER, fallback, "", range, unit, doc);
    if (detail::binding != nullptr) value_ = detail::binding->api->option_number(detail::binding->link, i);
  }
  operator double() const { return value_; }

 private:
  double value_ = 0;
};

class IntegerOption {
 public:
  IntegerOption(const char* name, const char* fallback, Range range, const char* doc) {
    const std::uint32_t i = detail::declare_option(name, IG_OPTION_INTEGER, fallback, "", range, "", doc);
    if (detail::binding != nullptr) value_ = detail::binding->api->option_integer(detail::binding->link, i);
  }
  operator std::int64_t() const { return value_; }

 private:
  std::int64_t value_ = 0;
};

class BooleanOption {
 public:
  BooleanOption(const char* name, const char* fallback, const char* doc) {
    const std::uint32_t i = detail::declare_option(name, IG_OPTION_BOOLEAN, fallback, "", {}, "", doc);
    if (detail::binding != nullptr) value_ = detail::binding->api->option_integer(detail::binding->link, i) != 0;
  }
  operator bool() const { return value_; }

 private:
  bool value_ = false;
};

class TextOption {
 public:
  TextOption(const char* name, const char* fallback, const char* doc) {
    const std::uint32_t i = detail::declare_option(name, IG_OPTION_TEXT, fallback, "", {}, "", doc);
    if (detail::binding != nullptr) value_ = to_view(detail::binding->api->option_text(detail::binding->link, i));
  }
  std::string_view text() const { return value_; }

 private:
  std::string value_;
};

/// An option that is one of several words, "a|b|c"; E's enumerators stand in the same order.
template <class E>
class Choice {
 public:
  Choice(const char* name, const char* choices, const char* fallback, const char* doc) {
    const std::uint32_t i = detail::declare_option(name, IG_OPTION_CHOICE, fallback, choices, {}, "", doc);
    if (detail::binding != nullptr)
      value_ = static_cast<E>(detail::binding->api->option_integer(detail::binding->link, i));
  }
  operator E() const { return value_; }

 private:
  E value_{};
};

/// Fields that are known only when the chain is created, by a pattern: `Parsing.?` (all words of one address),
/// `Parsing.*.X` (X of every code), `Parsing.**{mm}` (all words whose unit is mm), `Parsing.*{canned-cycle}.X` (X of
/// all codes whose own unit is canned-cycle).
class MatchedFields {
 public:
  MatchedFields(std::string_view pattern, Access access, ig_type type = IG_NUMBER) {
    detail::declare_field({pattern, type, access | static_cast<std::uint32_t>(IG_PATTERN)});
    if (detail::binding == nullptr) return;
    const ig_link_api* const api = detail::binding->api;
    ig_link* const link = detail::binding->link;
    const ig_field* ids = nullptr;
    const std::uint32_t n = api->expand(link, detail::last_field(), &ids);
    ids_ = {ids, n};
    paths_.reserve(n);
    units_.reserve(n);
    for (const ig_field id : ids_) {
      paths_.push_back(to_view(api->field_path(link, id)));
      units_.push_back(to_view(api->field_unit(link, id)));
    }
  }
  std::size_t size() const { return ids_.size(); }
  const ig_field* ids() const { return ids_.data(); }
  ig_field id(std::size_t i) const { return ids_[i]; }
  std::string_view path(std::size_t i) const { return paths_[i]; }
  std::string_view unit(std::size_t i) const { return units_[i]; }

 private:
  std::span<const ig_field> ids_;  // owned by the host, like the texts, as long as the chain lives
  std::vector<std::string_view> paths_;
  std::vector<std::string_view> units_;
};

/// Fields that the dialect names: the option holds their patterns, separated by blanks.
class Fields : public MatchedFields {
 public:
  Fields(const char* option, const char* fallback, Access access, const char* doc, ig_type type = IG_NUMBER)
      : MatchedFields(
            (detail::declare_option(option, IG_OPTION_FIELDS, fallback, "", {}, "", doc), "@" + std::string(option)),
            access, type) {}
};

/// Whether a dialect without the service is refused.
enum class Need { required, optional };

/// A service of the nearest dependency that provides it. Linking fails where a required one is missing; only an
/// optional one may be empty, so test it before use.
template <class T>
class Service {
 public:
  explicit Service(const char* id, Need need = Need::required, const char* doc = "") {
    if (detail::recorder != nullptr) {
      ig_service_decl out{};
      out.struct_size = sizeof out;
      out.is_optional = need == Need::optional ? 1 : 0;
      out.id = id;
      out.doc = doc;
      detail::recorder->services.push_back(out);
    } else if (detail::binding != nullptr) {
      detail::binding->expect("service", &detail::Recorder::services, &ig_service_decl::id, detail::binding->service,
                              id);
      ++detail::binding->service;
      service_ = static_cast<const T*>(detail::binding->api->service(detail::binding->link, id));
    } else {
      detail::refuse_stray("service", {id, {}, {}, {}});
    }
  }
  explicit operator bool() const { return service_ != nullptr; }
  const T* operator->() const { return service_; }

 private:
  const T* service_ = nullptr;
};

/// The service isogloss.config/1, which answers names with numbers; nothing where it does not know the name.
class Config : public Service<ig_config_1> {
 public:
  using Service::Service;
  std::optional<double> number(std::string_view name) const {
    double value = 0;
    if (!*this || (*this)->number((*this)->self, to_text(name), &value) == 0) return std::nullopt;
    return value;
  }
};

/// Call it in the constructor of a syntax whose options and services leave it nothing to do: build() is then not called
/// in this chain.
inline void stay_idle() {
  if (detail::binding != nullptr) detail::binding->api->idle(detail::binding->link);
}

/// What the user gave on the command line for this run; empty where nothing was given.
class Setting {
 public:
  explicit Setting(const char* name) {
    if (detail::binding != nullptr) text_ = to_view(detail::binding->api->setting(detail::binding->link, name));
  }
  std::string_view text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace ig
