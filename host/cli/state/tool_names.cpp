#include "state/tool_names.hpp"

#include <algorithm>

#include "isogloss/engine/document.hpp"

namespace isogloss::cli {

namespace {

constexpr std::string_view name_service = "isogloss.tool-name/1", name_column = "Name";

/// A number in quotation marks is not a name.
bool is_tool_number(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void ToolNames::begin(Document& initial, const SymbolTable&) {
  name_ = initial.layout().id("ToolName.Text");
  number_ = initial.layout().id("ToolChange.ToolId");
}

bool ToolNames::block(Document& document, const SymbolTable&) {
  if (!document.fresh(number_)) return true;
  const std::int64_t number = document.value(number_).integer;
  if (document.present(name_) && document.fresh(name_))
    names_[number] = std::string(document.text(name_));
  else
    names_.erase(number);
  return true;
}

std::string ToolNames::of(std::int64_t number) const {
  const auto found = names_.find(number);
  return found == names_.end() ? std::string() : found->second;
}

std::optional<DependencyElement> ToolNames::rows(const LinkedDialect& linked) const {
  for (const LinkedDependency& d : linked.dependencies) {
    const ig_dependency& table = *d.dependency;
    bool answers = false;
    for (const char* const* id = table.provides; id != nullptr && *id != nullptr; ++id) answers |= name_service == *id;
    const bool has_column = std::any_of(table.columns, table.columns + table.column_count,
                                        [](const ig_column_decl& c) { return name_column == c.name; });
    if (!answers || !has_column || table.row_element == nullptr) continue;
    DependencyElement out = d.element;
    out.rows.clear();
    out.options.clear();
    out.source_file.clear();
    for (const auto& [number, name] : names_)
      if (!is_tool_number(name))
        out.rows.push_back({table.row_element,
                            {{table.row_key, std::to_string(number), {}}, {std::string(name_column), name, {}}},
                            {}});
    return out.rows.empty() ? std::nullopt : std::optional(std::move(out));
  }
  return std::nullopt;
}

}  // namespace isogloss::cli
