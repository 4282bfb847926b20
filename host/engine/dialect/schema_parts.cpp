#include "dialect/schema_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "dialect/xml_source.hpp"

namespace isogloss {
namespace {

/// Without exponent, which xs:decimal does not have.
std::string decimal(double value) {
  char text[512];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, end};
}

std::vector<std::string> choices_of(const ig_option_decl& option) {
  std::vector<std::string> out;
  std::istringstream choices(option.choices);
  for (std::string choice; std::getline(choices, choice, '|');) out.push_back(choice);
  return out;
}

void add_enumeration(pugi::xml_node restriction, const std::string& value) {
  set_attribute(add_element(restriction, "xs:enumeration"), "value", value);
}

/// Below an attribute or a union: a type without a name.
pugi::xml_node add_restriction(pugi::xml_node parent, const char* base) {
  pugi::xml_node restriction = add_element(add_element(parent, "xs:simpleType"), "xs:restriction");
  set_attribute(restriction, "base", base);
  return restriction;
}

void add_number_type(pugi::xml_node parent, const ig_option_decl& option) {
  if (option.type == IG_OPTION_NUMBER)
    return add_range(add_restriction(parent, "xs:decimal"), option.minimum, option.maximum);
  pugi::xml_node restriction = add_restriction(parent, "xs:integer");
  set_attribute(add_element(restriction, "xs:pattern"), "value", "-?[0-9]+");
  add_range(restriction, option.minimum, option.maximum);
}

std::string text_of(const ig_option_decl& option) {
  std::string doc = with_unit(option.doc, option.unit);
  if (option.type == IG_OPTION_FIELDS) doc += " Field patterns, separated by blanks.";
  return doc;
}

/// What several owners take, without repetition.
struct Union {
  std::vector<std::string> words;
  std::vector<const ig_option_decl*> numbers;
  bool any_text = false;

  void add(const ig_option_decl& option) {
    switch (option.type) {
      case IG_OPTION_BOOLEAN:
        add_word("true");
        add_word("false");
        return;
      case IG_OPTION_CHOICE:
        for (const std::string& choice : choices_of(option)) add_word(choice);
        return;
      case IG_OPTION_NUMBER:
      case IG_OPTION_INTEGER:
        if (std::none_of(numbers.begin(), numbers.end(), [&](const ig_option_decl* n) {
              return n->type == option.type && n->minimum == option.minimum && n->maximum == option.maximum;
            }))
          numbers.push_back(&option);
        return;
      default: any_text = true;
    }
  }
  void add_word(const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  std::size_t members() const { return (words.empty() ? 0 : 1) + numbers.size() + (any_text ? 1 : 0); }
};

}  // namespace

pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& name) {
  pugi::xml_node node = parent.append_child(element);
  if (!name.empty()) set_attribute(node, "name", name);
  return node;
}

void add_documentation(pugi::xml_node node, const std::string& text) {
  if (text.empty()) return;
  add_element(add_element(node, "xs:annotation"), "xs:documentation").text().set(text.c_str());
}

void add_type(pugi::xml_node attribute, const char* type) { set_attribute(attribute, "type", type); }

pugi::xml_node restrict_to(pugi::xml_node attribute, const char* base) { return add_restriction(attribute, base); }

void add_range(pugi::xml_node restriction, double minimum, double maximum) {
  if (std::isfinite(minimum)) set_attribute(add_element(restriction, "xs:minInclusive"), "value", decimal(minimum));
  if (std::isfinite(maximum)) set_attribute(add_element(restriction, "xs:maxInclusive"), "value", decimal(maximum));
}

std::string with_unit(const char* doc, const char* unit) {
  return *unit == '\0' ? std::string(doc) : fmt::format("{} [{}]", doc, unit);
}

void add_option(pugi::xml_node type, const ig_option_decl& option) {
  pugi::xml_node attribute = add_element(type, "xs:attribute", option.name);
  // An inherited element may get it from a Configure, so a schema cannot demand it.
  std::string doc = text_of(option);
  if (option.fallback == nullptr) doc += doc.empty() ? "Required." : " Required.";
  if (option.fallback != nullptr) set_attribute(attribute, "default", option.fallback);
  if (option.type == IG_OPTION_BOOLEAN) add_type(attribute, "dialect.Boolean");
  if (option.type == IG_OPTION_TEXT || option.type == IG_OPTION_FIELDS) add_type(attribute, "xs:string");
  add_documentation(attribute, doc);
  if (option.type == IG_OPTION_NUMBER || option.type == IG_OPTION_INTEGER) add_number_type(attribute, option);
  if (option.type != IG_OPTION_CHOICE) return;
  pugi::xml_node restriction = add_restriction(attribute, "xs:string");
  for (const std::string& choice : choices_of(option)) add_enumeration(restriction, choice);
}

void add_shared_option(pugi::xml_node type, const std::vector<OwnedOption>& owned) {
  pugi::xml_node attribute = add_element(type, "xs:attribute", owned.front().second->name);
  Union all;
  std::vector<NamedText> texts;  // owners, by text
  for (const auto& [owner, option] : owned) {
    all.add(*option);
    const std::string text = text_of(*option);
    const auto same = std::find_if(texts.begin(), texts.end(), [&](const NamedText& t) { return t.second == text; });
    if (same == texts.end())
      texts.emplace_back(owner, text);
    else
      same->first += fmt::format(", {}", owner);
  }
  std::string doc;
  for (const auto& [owners, text] : texts) doc += fmt::format("{}{}: {}", doc.empty() ? "" : " ", owners, text);
  if (all.any_text && all.members() == 1) add_type(attribute, "xs:string");
  add_documentation(attribute, doc);
  if (all.any_text && all.members() == 1) return;
  pugi::xml_node place = attribute;
  if (all.members() > 1) place = add_element(add_element(attribute, "xs:simpleType"), "xs:union");
  if (!all.words.empty()) {
    pugi::xml_node restriction = add_restriction(place, "xs:string");
    for (const std::string& word : all.words) add_enumeration(restriction, word);
  }
  for (const ig_option_decl* number : all.numbers) add_number_type(place, *number);
  if (all.any_text) set_attribute(place, "memberTypes", "xs:string");
}

void add_name_type(pugi::xml_node schema, const char* name, const std::vector<NamedText>& names, const char* more) {
  pugi::xml_node place = add_element(schema, "xs:simpleType", name);
  if (more != nullptr) {
    place = add_element(place, "xs:union");
    set_attribute(place, "memberTypes", more);
    place = add_element(place, "xs:simpleType");
  }
  pugi::xml_node restriction = add_element(place, "xs:restriction");
  set_attribute(restriction, "base", "xs:string");
  for (const auto& [word, text] : names) {
    pugi::xml_node enumeration = add_element(restriction, "xs:enumeration");
    set_attribute(enumeration, "value", word);
    add_documentation(enumeration, text);
  }
}

}  // namespace isogloss
