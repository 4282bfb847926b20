/// What a syntax declares may not depend on its options. The host gives ids for what the prototype declared; an
/// instance that declares more, fewer or others in between takes the ids of its neighbours, and writes into fields that
/// are not its own.
#pragma once

#include <catch2/catch.hpp>

#include <cstdlib>
#include <isogloss/sdk.hpp>

namespace isogloss_test {

/// Creates a syntax outside a host and writes down how many fields it had declared at each question that it asked.
class Observer {
 public:
  Observer(const ig_syntax& syntax, std::uint32_t changed, std::int64_t choice)
      : syntax_(syntax), changed_(changed), choice_(choice) {
    api_.struct_size = sizeof api_;
    api_.symbol = [](ig_link* link, ig_text) { return self(link).note(), ig_symbol{1}; };
    api_.option_number = [](ig_link* link, std::uint32_t i) {
      self(link).note(i);
      return std::strtod(self(link).option(i).fallback, nullptr);
    };
    api_.option_integer = [](ig_link* link, std::uint32_t i) {
      self(link).note(i);
      return i == self(link).changed_ ? self(link).choice_ : self(link).fallback(i);
    };
    api_.option_text = [](ig_link* link, std::uint32_t i) {
      self(link).note(i);
      return ig::to_text(self(link).option(i).fallback);
    };
    api_.expand = [](ig_link* link, std::uint32_t declaration, const ig_field** ids) {
      self(link).note(declaration);
      *ids = nullptr;
      return std::uint32_t{0};
    };
    api_.field_path = [](ig_link*, ig_field) { return ig_text{"", 0}; };
    api_.field_unit = api_.field_path;
    api_.service = [](ig_link* link, const char*) -> const void* { return self(link).note(), nullptr; };
    api_.setting = [](ig_link*, const char*) { return ig_text{"", 0}; };
    api_.fail = [](ig_link*, ig_text) {};
    api_.idle = [](ig_link*) {};
  }

  /// Pairs: declared fields, and the option or pattern that was asked for.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> run() {
    const std::vector<ig_field> ids(syntax_.field_count);  // no more than that: a sanitizer sees one read past the end
    void* instance = nullptr;
    if (syntax_.create(&api_, reinterpret_cast<ig_link*>(this), ids.data(), &instance) == IG_CHANGED)
      syntax_.destroy(instance);
    return seen_;
  }

 private:
  static Observer& self(ig_link* link) { return *reinterpret_cast<Observer*>(link); }
  const ig_option_decl& option(std::uint32_t i) const {
    REQUIRE(i < syntax_.option_count);
    return syntax_.options[i];
  }
  /// The number of the default among the choices.
  std::int64_t fallback(std::uint32_t i) const {
    const ig_option_decl& o = option(i);
    if (o.type == IG_OPTION_INTEGER) return std::strtoll(o.fallback, nullptr, 10);
    if (o.type == IG_OPTION_BOOLEAN) return std::string_view(o.fallback) == "true" ? 1 : 0;
    std::int64_t index = 0;
    for (std::string_view rest = o.choices; !rest.empty(); ++index) {
      const std::size_t bar = rest.find('|');
      if (rest.substr(0, bar) == o.fallback) return index;
      rest.remove_prefix(bar == std::string_view::npos ? rest.size() : bar + 1);
    }
    return 0;
  }
  void note(std::uint32_t what = ~0u) {
    const std::uint32_t declared = ig::detail::binding->field;
    CHECK(declared <= syntax_.field_count);
    seen_.emplace_back(declared, what);
  }

  const ig_syntax& syntax_;
  std::uint32_t changed_;
  std::int64_t choice_;
  ig_link_api api_{};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> seen_;
};

inline std::int64_t choices(const ig_option_decl& option) {
  if (option.type == IG_OPTION_BOOLEAN) return 2;
  return option.type == IG_OPTION_CHOICE ? 1 + std::ranges::count(std::string_view(option.choices), '|') : 0;
}

inline void check_declarations(const ig_plugin& plugin) {
  for (std::uint32_t s = 0; s < plugin.syntax_count; ++s) {
    const ig_syntax& syntax = *plugin.syntaxes[s];
    const auto by_default = Observer(syntax, ~0u, 0).run();
    for (std::uint32_t o = 0; o < syntax.option_count; ++o)
      for (std::int64_t choice = 0; choice < choices(syntax.options[o]); ++choice) {
        INFO(syntax.id << " " << syntax.options[o].name << ", choice " << choice);
        CHECK(Observer(syntax, o, choice).run() == by_default);
      }
  }
}

}  // namespace isogloss_test
