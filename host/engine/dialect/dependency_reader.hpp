/// Reads dependencies of a dialect or of a table file: their options and rows, also those of the file that src names.
#pragma once

#include <map>

#include "dialect/xml_elements.hpp"
#include "isogloss/engine/dialect.hpp"

namespace isogloss {

class DependencyReader : XmlElements {
 public:
  DependencyReader(const XmlSource& xml, XmlBudget& budget, Report& report)
      : XmlElements(xml, report), budget_(budget) {}

  DependencyElement read(pugi::xml_node node);
  /// Adds it to `all`; a second one of its name is reported instead.
  void add(std::vector<DependencyElement>& all, DependencyElement element);

 private:
  /// The file that src names: more options (those beside src win), and the first rows.
  void read_table(pugi::xml_node node, DependencyElement& element);
  void read_rows(const XmlSource& xml, pugi::xml_node node, DependencyElement& element);

  XmlBudget& budget_;
  std::map<std::string, Location> names_;  // of those that add() has added
};

/// A table file: one dependency, or <Dependencies> with several.
std::vector<DependencyElement> read_dependency_file(const XmlSource& xml, XmlBudget& budget, Report& report);

}  // namespace isogloss
