/// The datum tables of the machine, which cycle 7 #n and TRANS DATUM TABLE read. The dependency HeidenhainDatums owns
/// them; the syntaxes of this plugin reach them through its service. mm and degrees.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace heidenhain {

inline constexpr const char* datum_table_service = "heidenhain.datum-table/1";

/// What a row gives for X Y Z A B C; bit i of `mask` is set where axis i has a value.
struct DatumRow {
  std::uint32_t mask = 0;
  std::array<double, 6> value{};
};

struct DatumTable {
  std::string name;  ///< of the file, without its folder
  std::map<std::int64_t, DatumRow> rows;
};

/// The name of a table and the number of a row in it.
struct DatumKey {
  std::string_view table;
  std::int64_t row = 0;

  /// Of "ZERO.D#5"; nothing where it is no such key.
  static std::optional<DatumKey> read(std::string_view key);
};

class DatumTables {
 public:
  /// The table that a program names, with or without a folder and an ending, in any case of letters.
  const DatumTable* find(std::string_view path) const;
  /// The table that is in force without SEL TABLE: the one that the machine marks, or the only one.
  const DatumTable* standard() const;
  std::size_t size() const { return tables_.size(); }

  /// False where the row has been added before.
  bool add(const DatumKey& key, const DatumRow& row);
  void mark(std::string_view name) { marked_ = name; }

 private:
  std::map<std::string, DatumTable, std::less<>> tables_;  // by the name in capitals
  std::map<std::string, const DatumTable*, std::less<>> without_ending_;
  std::string marked_;
};

}  // namespace heidenhain
