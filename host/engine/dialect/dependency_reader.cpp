#include "dialect/dependency_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace isogloss {
namespace {

namespace fs = std::filesystem;

void set_option(DependencyElement& element, Attribute option) {
  for (Attribute& old : element.options) {
    if (old.name != option.name) continue;
    old = std::move(option);
    return;
  }
  element.options.push_back(std::move(option));
}

std::vector<Attribute> data_attributes(const XmlSource& xml, pugi::xml_node node,
                                       std::initializer_list<std::string_view> kept) {
  std::vector<Attribute> all;
  for (const pugi::xml_attribute a : node.attributes()) {
    const std::string_view name = a.name();
    if (!is_markup(name) && std::find(kept.begin(), kept.end(), name) == kept.end())
      all.push_back({a.name(), a.value(), xml.at(node, name)});
  }
  return all;
}

/// A file that begins with another byte than '<' is no XML; importers read it. One that is not there counts as XML.
bool is_of_control(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;  // to look into a pipe would block
  std::ifstream file(path, std::ios::binary);
  std::array<char, 512> head{};
  file.read(head.data(), head.size());
  std::string_view text(head.data(), static_cast<std::size_t>(file.gcount()));
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] != '<';
}

}  // namespace

DependencyElement DependencyReader::read(pugi::xml_node node) {
  DependencyElement element{node.name(), node.name(), {}, {}, {}, xml_.at(node)};
  for (const pugi::xml_attribute a : node.attributes()) {
    const std::string_view name = a.name();
    if (name == "as") element.alias = alias(node);
    if (name == "src") read_table(node, element);
    if (name == "format" && !node.attribute("src"))
      report_("IG-0108", xml_.at(node, "format"), {shown(element.id), "format"},
              "format says what the file is that src names");
  }
  for (Attribute& option : data_attributes(xml_, node, {"as", "src", "format"})) set_option(element, std::move(option));
  read_rows(xml_, node, element);
  return element;
}

void DependencyReader::read_table(pugi::xml_node node, DependencyElement& element) {
  const Location where = xml_.at(node, "src");
  const fs::path path = path_of_src(node);
  if (path.empty()) return;
  const std::string format = node.attribute("format").value();
  if (!format.empty() || is_of_control(path)) {
    element.control_file = Import{path, format, {}, where};
    return;
  }
  const std::unique_ptr<XmlSource> table = XmlSource::open(path, where, budget_, report_.sink());
  if (table == nullptr) {
    report_.failed = true;
    return;
  }
  const pugi::xml_node root = table->root();
  if (element.id != root.name())
    return report_("IG-0118", table->at(root), {table->file(), shown(root.name()), shown(element.id)});
  element.source_file = path.string();
  element.options = data_attributes(*table, root, {});
  read_rows(*table, root, element);
}

void DependencyReader::read_rows(const XmlSource& xml, pugi::xml_node node, DependencyElement& element) {
  XmlElements inside(xml, report_);
  for (const pugi::xml_node row : inside.elements(node)) {
    inside.leaves(row, {});
    element.rows.push_back({row.name(), data_attributes(xml, row, {}), xml.at(row)});
  }
}

void DependencyReader::add(std::vector<DependencyElement>& all, DependencyElement element) {
  const auto [same, is_new] = names_.emplace(element.alias, element.where);
  if (!is_new)
    return report_("IG-0113", element.where, {shown(element.alias), place(same->second)},
                   fmt::format("give the second one a name of its own: <{} as=\"second\"/>", shown(element.id)));
  all.push_back(std::move(element));
}

std::vector<DependencyElement> read_dependency_file(const XmlSource& xml, XmlBudget& budget, Report& report) {
  DependencyReader reader(xml, budget, report);
  const pugi::xml_node root = xml.root();
  if (std::string_view(root.name()) != "Dependencies") return {reader.read(root)};
  XmlElements inside(xml, report);
  inside.only_attributes(root, {});
  std::vector<DependencyElement> all;
  for (const pugi::xml_node node : inside.elements(root)) reader.add(all, reader.read(node));
  return all;
}

}  // namespace isogloss
