/// Rows of SiemensVariables and SiemensMacros from data files: R parameters, values of global user data (GUD), their
/// definitions, and macros.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "archive/data_line.hpp"
#include "language/variable.hpp"

namespace siemens {

/// Collects the rows, so that a value has precedence over the definition of its variable in any order.
class VariableRows {
 public:
  using Sizes = std::vector<std::uint32_t>;

  /// R5=…, NAME=…, NAME[1,2]=…, NAME[0]=SET(…).
  void assign(ig::Import& file, const Assignment& a);
  /// DEF …, REDEF …, DEFINE … AS …; false where the line is none of them.
  bool define(ig::Import& file, std::string_view code);
  /// Gives the rows to the file.
  void give(ig::Import& file) const;

 private:
  struct Row {
    std::string key;
    std::optional<Value> value;  ///< none: that of the definition, which leaves the value of another file as it is
    std::size_t begin, end;
    bool is_assigned;
    bool is_axis = false;  ///< the value is a bare name
  };
  struct Definition {
    Declared type;
    Sizes sizes;
    std::optional<double> lowest, highest;  ///< as they are written
  };
  struct Macro {
    std::string name;
    std::string_view text;
    std::size_t place;
  };

  // ---- definition.cpp

  /// False where the definition has another form.
  bool read_attributes(Cursor& cursor, std::string_view code, Definition& d, std::string_view& name, bool& is_global);
  bool read_names(ig::Import& file, Cursor& cursor, const Definition& d, std::string_view name);
  void define_one(ig::Import& file, Definition d, std::string_view name, std::string_view initial);
  /// The value of a definition; with a diagnostic that of a variable without one where its type cannot hold it, and
  /// nothing where it cannot be read.
  std::optional<Value> initial_value(ig::Import& file, const Definition& d, const std::string& key,
                                     std::string_view name, std::string_view text) const;
  void define_macro(ig::Import& file, std::string_view code, Cursor cursor);

  // ---- variable_rows.cpp

  void assign_list(ig::Import& file, const Assignment& a);
  /// A value of a variable whose definition may not be known; `is_axis`: it is a bare name.
  static std::optional<Value> read_value(std::string_view text, bool& is_axis);
  void give_row(ig::Import& file, const Row& row) const;
  static constexpr double most_elements = 10'000;  ///< of one array
  static double element_count(const Sizes& sizes);
  /// A short line can fill many elements: those of one array and of a file are limited.
  bool has_room_for(double elements);
  void put(Row row);

  std::vector<Row> rows_;
  std::vector<Macro> macros_;
  std::unordered_map<std::string, std::size_t> known_;
  std::unordered_map<std::string, Definition> definitions_;
  std::unordered_set<std::string> local_;  // variables of one program
  std::unordered_set<std::string> macro_names_;
  std::size_t repeated_ = 0;
  std::int64_t highest_r_ = 0;
};

/// R5, and R of R[5].
constexpr bool is_r_name(std::string_view name) {
  return !name.empty() && name[0] == 'R' && skip_digits(name, 1) == name.size();
}

/// A list of values: (1,,3), SET(1,2), REP(0) or REP(0,5).
struct ValueList {
  std::vector<std::string_view> values;
  bool repeats = false;  ///< values[0] goes to all elements, or to `count` of them
  std::optional<std::size_t> count;
};
std::optional<ValueList> read_list(std::string_view value);

}  // namespace siemens
