/// Tells the host which row of a table has answered, so that `isogloss explain` shows its line in the XML.
#pragma once

#include <isogloss_provenance.h>

#include <map>
#include <string>

#include "isogloss/block.hpp"

namespace ig {

/// A member of each syntax that asks a table by the names of its rows. `service` is what the table provides.
class AnsweredRows {
 public:
  explicit AnsweredRows(const char* service) : service_(service) {}

  bool is_heard() const { return host_ && host_->is_listening != 0; }
  /// The row has answered for this block. Does nothing where nobody listens.
  void add(Block& b, std::string_view row) const {
    if (is_heard()) host_->answered(b.raw(), to_text(service_), to_text(row));
  }

 private:
  std::string_view service_;
  Service<ig_provenance_1> host_{IG_PROVENANCE_SERVICE, Need::optional, "Which rows have answered; the host has it."};
};

/// A member of a store whose values come from rows until the program overwrites them: which row has given which value.
template <class Key>
class RowOrigins {
 public:
  void give(const Key& key, std::string_view row) { rows_[key] = row; }
  void overwrite(const Key& key) {
    if (!rows_.empty()) rows_.erase(key);
  }
  /// nullptr: the value is none of a row.
  const std::string* of(const Key& key) const {
    const auto row = rows_.find(key);
    return row == rows_.end() ? nullptr : &row->second;
  }

 private:
  std::map<Key, std::string> rows_;
};

}  // namespace ig
