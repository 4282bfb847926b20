/// One dialect file as it is written, before what it extends is folded in.
#pragma once

#include "dialect/xml_elements.hpp"
#include "isogloss/engine/dialect.hpp"

namespace isogloss {

enum class EditKind : std::uint8_t { replace, insert_before, insert_after, remove, configure };
std::string_view to_string(EditKind kind);

/// A change to an inherited element.
template <class Element>
struct Edit {
  EditKind kind;
  std::string anchor;
  std::vector<Element> elements;   ///< what is inserted
  std::vector<Attribute> options;  ///< configure
  bool override_slot = false;      ///< configure
  Location where, anchor_where;
};

struct DialectFile {
  Dialect own;
  std::string extends;
  Location extends_where;
  bool has_files = false;
  bool has_search_order = false;
  bool is_machine = false;  ///< a <Machine>, or a part of one
  std::vector<Edit<ChainElement>> chain_edits;
  std::vector<Edit<DependencyElement>> dependency_edits;
};

/// Everything that is wrong is reported; what can be read is.
DialectFile read_dialect_file(const XmlSource& xml, XmlBudget& budget, Report& report);

/// A file that a machine includes: a <Machine> without attributes, or tables.
DialectFile read_machine_part(const XmlSource& xml, XmlBudget& budget, Report& report);

/// Name, title and how programs are recognised; nothing else is read.
Dialect read_dialect_head(const XmlSource& xml, Report& report);

}  // namespace isogloss
