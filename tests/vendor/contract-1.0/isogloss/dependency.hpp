/// Dependencies: named parts that answer questions from a table, which the host holds.
#pragma once

#include "isogloss/options.hpp"

namespace ig {

class Column {
 public:
  Column(const char* name, const char* fallback, const char* unit, Range range, const char* doc, bool is_text = false) {
    if (detail::recorder != nullptr) {
      ig_column_decl out{};
      out.struct_size = sizeof out;
      out.is_text = is_text ? 1 : 0;
      out.name = name;
      out.unit = unit;
      out.fallback = fallback;
      out.minimum = range.minimum;
      out.maximum = range.maximum;
      out.doc = doc;
      detail::recorder->columns.push_back(out);
    } else if (detail::binding != nullptr) {
      index_ = detail::binding->column++;
    }
  }
  std::uint32_t index() const { return index_; }

 private:
  std::uint32_t index_ = 0;
};

/// The rows of the dependency that holds this member.
class Table {
 public:
  Table() {
    if (detail::binding == nullptr) return;
    api_ = detail::binding->api;
    table_ = api_->table(detail::binding->link);
  }
  std::optional<double> value(std::string_view row, const Column& column) const {
    double v = 0;
    if (table_ == nullptr || api_->value(table_, to_text(row), column.index(), &v) == 0) return std::nullopt;
    return v;
  }
  bool set_value(std::string_view row, const Column& column, double value) const {
    return table_ != nullptr && api_->set_value(table_, to_text(row), column.index(), value) != 0;
  }
  std::string_view text(std::string_view row, const Column& column) const {
    return table_ == nullptr ? std::string_view{} : to_view(api_->text_value(table_, to_text(row), column.index()));
  }

 private:
  const ig_link_api* api_ = nullptr;
  ig_table* table_ = nullptr;
};

}  // namespace ig
