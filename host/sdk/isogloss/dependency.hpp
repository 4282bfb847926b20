/// Members of a dependency: a named part of a dialect that answers questions from a table. The host holds the table: it
/// reads it from XML, copies it for each run and writes it back.
#pragma once

#include "isogloss/options.hpp"

namespace ig {

/// One column of the table. `fallback` is the default as text, nullptr for none; `range` is inclusive and in `unit`.
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
      detail::binding->expect("column", &detail::Recorder::columns, &ig_column_decl::name, detail::binding->column,
                              name);
      index_ = detail::binding->column++;
    } else {
      detail::refuse_stray("column", {name, {}, {}, {}});
    }
  }
  std::uint32_t index() const { return index_; }

 private:
  std::uint32_t index_ = 0;
};

/// The rows of the dependency that holds this member. A value is nothing where the row or its value is missing;
/// set_value() and set_text() add a row that is missing, and are false where the dependency has no table.
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
  /// For a column of texts; false with a host of contract 1.7 and older, too.
  bool set_text(std::string_view row, const Column& column, std::string_view value) const {
    return table_ != nullptr && api_->host_minor >= 8 &&
           api_->set_text_value(table_, to_text(row), column.index(), to_text(value)) != 0;
  }
  std::string_view text(std::string_view row, const Column& column) const {
    return table_ == nullptr ? std::string_view{} : to_view(api_->text_value(table_, to_text(row), column.index()));
  }

 private:
  const ig_link_api* api_ = nullptr;
  ig_table* table_ = nullptr;
};

}  // namespace ig
