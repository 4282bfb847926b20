/// Tells the host which row of a table has answered, which variables a block reads and writes, and which conditions it
/// examines, so that `isogloss explain` shows the line in the XML, or in the program, behind a value. And what the rows
/// of a table mean.
#pragma once

#include <isogloss_provenance.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
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

/// A member of each syntax that reads or writes variables of the program. Does nothing where nobody listens.
class UsedVariables {
 public:
  bool is_heard() const {
    return host_ && host_->is_listening != 0 && host_->struct_size >= sizeof(ig_provenance_1) &&
           host_->variable != nullptr;
  }
  /// `name` as a program writes it; `scope` is 0, or tells local variables of several calls apart. NaN: no value.
  void read(Block& b, std::string_view name, double value, std::uint64_t scope = 0) const {
    tell(b, IG_READ, name, scope, value);
  }
  void wrote(Block& b, std::string_view name, double value, std::uint64_t scope = 0) const {
    tell(b, IG_WRITE, name, scope, value);
  }
  void read(Block& b, std::string_view name, std::string_view text, std::uint64_t scope = 0) const {
    tell(b, IG_READ, name, scope, text);
  }
  void wrote(Block& b, std::string_view name, std::string_view text, std::uint64_t scope = 0) const {
    tell(b, IG_WRITE, name, scope, text);
  }

 private:
  void tell(Block& b, std::uint32_t access, std::string_view name, std::uint64_t scope, double value) const {
    const ig_argument shown{0, 0, value, {nullptr, 0}};
    if (is_heard()) host_->variable(b.raw(), access, to_text(name), scope, std::isnan(value) ? nullptr : &shown);
  }
  void tell(Block& b, std::uint32_t access, std::string_view name, std::uint64_t scope, std::string_view text) const {
    const ig_argument shown{1, 0, 0, to_text(text)};
    if (is_heard()) host_->variable(b.raw(), access, to_text(name), scope, &shown);
  }
  Service<ig_provenance_1> host_{IG_PROVENANCE_SERVICE, Need::optional, "Variables of the block; the host has it."};
};

/// A member of each syntax that examines conditions: IF, WHILE, the repeats of a call. Does nothing where nobody
/// listens.
class ExaminedConditions {
 public:
  bool is_heard() const {
    return host_ && host_->is_listening != 0 &&
           host_->struct_size >= offsetof(ig_provenance_1, condition) + sizeof host_->condition &&
           host_->condition != nullptr;
  }
  /// `text` as the program writes it.
  void add(Block& b, std::string_view text, bool holds) const {
    tell(b, text, holds ? IG_CONDITION_HOLDS : IG_CONDITION_FAILS);
  }
  /// A reason in words, "pass 2 of 3". Build it where is_heard() alone.
  void add_reason(Block& b, std::string_view words) const { tell(b, words, IG_CONDITION_TELLS); }

 private:
  void tell(Block& b, std::string_view text, std::int32_t outcome) const {
    if (is_heard()) host_->condition(b.raw(), to_text(text), outcome);
  }
  Service<ig_provenance_1> host_{IG_PROVENANCE_SERVICE, Need::optional, "Conditions of the block; the host has it."};
};

/// What a row of a table means: see ig_row_meaning. The texts are literals.
struct RowMeaning {
  std::string_view title, unit;
  double scale = 1;
  std::string_view prefix = {};
};

/// The service isogloss.row-meaning/1 from `Table::meaning_of(row, column)`, which gives an optional RowMeaning.
/// `Table` declares this class its friend.
template <class Table>
class RowMeanings {
 public:
  explicit RowMeanings(Table* table) : service_{sizeof(ig_row_meaning_1), 0, table, &ask} {}
  const void* find(std::string_view id) const { return id == IG_ROW_MEANING_SERVICE ? &service_ : nullptr; }

 private:
  static std::int32_t ask(void* self, ig_text row, ig_text column, ig_row_meaning* out) {
    const std::optional<RowMeaning> meaning =
        static_cast<const Table*>(self)->meaning_of(to_view(row), to_view(column));
    if (!meaning || out->struct_size < sizeof *out) return 0;
    *out = {out->struct_size, 0, to_text(meaning->title), to_text(meaning->prefix), to_text(meaning->unit),
            meaning->scale};
    return 1;
  }
  ig_row_meaning_1 service_;
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
