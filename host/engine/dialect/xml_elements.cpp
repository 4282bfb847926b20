#include "dialect/xml_elements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dialect/dialect_path.hpp"

namespace isogloss {

std::vector<pugi::xml_node> XmlElements::elements(pugi::xml_node node) {
  std::vector<pugi::xml_node> all;
  for (const pugi::xml_node child : node.children()) {
    if (child.type() == pugi::node_element) all.push_back(child);
    if (child.type() != pugi::node_pcdata && child.type() != pugi::node_cdata) continue;
    const std::vector<std::string> text = words(child.value());
    report_("IG-0119", xml_.at(child), {node.name(), text.empty() ? "" : shown(text[0])});
  }
  return all;
}

std::vector<pugi::xml_node> XmlElements::leaves(pugi::xml_node node, const std::vector<std::string>& names) {
  std::vector<pugi::xml_node> all;
  for (const pugi::xml_node child : elements(node)) {
    if (std::find(names.begin(), names.end(), child.name()) == names.end()) {
      unknown(child, names);
      continue;
    }
    leaves(child, {});
    all.push_back(child);
  }
  return all;
}

void XmlElements::only_attributes(pugi::xml_node node, const std::vector<std::string>& names) {
  for (const pugi::xml_attribute a : node.attributes()) {
    if ((node == xml_.root() && is_markup(a.name())) || std::find(names.begin(), names.end(), a.name()) != names.end())
      continue;
    report_("IG-0108", xml_.at(node, a.name()), {node.name(), shown(a.name())}, meant(a.name(), names));
  }
}

std::string XmlElements::required(pugi::xml_node node, const char* attribute) {
  const pugi::xml_attribute a = node.attribute(attribute);
  if (a && *a.value() != '\0') return a.value();
  report_("IG-0109", xml_.at(node, attribute), {node.name(), attribute});
  return {};
}

std::filesystem::path XmlElements::path_of_src(pugi::xml_node node) {
  const std::string src = node.attribute("src").value();
  std::filesystem::path path = below_folder_of(xml_.file(), src);
  if (path.empty()) {
    const std::filesystem::path folder = std::filesystem::path(xml_.file()).parent_path();
    report_("IG-0117", xml_.at(node, "src"), {shown(src), folder.empty() ? "the dialect's folder" : folder.string()});
  }
  return path;
}

std::string XmlElements::alias(pugi::xml_node node) {
  std::string as = node.attribute("as").value();
  if (as.empty() || as.find_first_of(" \t\r\n") != std::string::npos) bad_value(node, "as", "a name without blanks");
  return as.empty() ? node.name() : as;
}

void XmlElements::bad_value(pugi::xml_node node, const char* attribute, const char* wanted,
                            const std::vector<std::string>& words) {
  const char* const value = node.attribute(attribute).value();
  report_("IG-0110", xml_.at(node, attribute), {node.name(), attribute, wanted, shown(value)}, meant(value, words));
}

void XmlElements::unknown(pugi::xml_node node, const std::vector<std::string>& names) {
  report_("IG-0107", xml_.at(node), {shown(node.name()), node.parent().name()}, meant(node.name(), names));
}

bool XmlElements::once(pugi::xml_node node) {
  const pugi::xml_node first = node.parent().child(node.name());
  if (first == node) return true;
  report_("IG-0114", xml_.at(node), {node.name(), place(xml_.at(first))});
  return false;
}

std::string XmlElements::place(const Location& where) { return fmt::format("line {}", where.line); }

bool is_markup(std::string_view attribute) {
  return attribute == "xmlns" || attribute.starts_with("xmlns:") || attribute.starts_with("xsi:");
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> all;
  for (std::size_t i = 0; (i = text.find_first_not_of(" \t\r\n", i)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", i), text.size());
    all.emplace_back(text.substr(i, end - i));
    i = end;
  }
  return all;
}

std::string meant(std::string_view name, const std::vector<std::string>& names) {
  constexpr std::size_t longest_misspelling = 100;
  if (name.size() > longest_misspelling) return {};
  const std::string near = nearest_name(name, names);
  return near.empty() ? near : "did you mean " + near + "?";
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 80;
  return text.size() <= longest ? std::string(text) : std::string(text.substr(0, longest)) + "…";
}

}  // namespace isogloss
