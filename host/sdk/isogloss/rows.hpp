/// The names of the rows of a dependency's table, for a dependency that reads all rows.
#pragma once

#include "isogloss/dependency.hpp"

namespace ig {

/// A member of a dependency: the names of its rows, in their order, at the time when the dependency is created.
class RowNames {
 public:
  RowNames() {
    if (detail::binding == nullptr) return;
    const ig_link_api& api = *detail::binding->api;
    const ig_table* const table = api.table(detail::binding->link);
    for (std::uint32_t i = 0; table != nullptr && i < api.row_count(table); ++i)
      names_.emplace_back(to_view(api.row_name(table, i)));
  }
  auto begin() const { return names_.begin(); }
  auto end() const { return names_.end(); }

 private:
  std::vector<std::string> names_;
};

}  // namespace ig
