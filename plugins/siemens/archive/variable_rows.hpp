/// Rows of SiemensVariables from data files: R parameters, values of global user data (GUD), and their definitions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "archive/data_line.hpp"

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
    std::optional<double> value;  ///< none: the 0 of a definition, which leaves the value of another file as it is
    std::size_t place;
    bool is_assigned;
  };
  struct Definition {
    std::string_view type;
    std::optional<double> lowest, highest;
    double initial() const;
  };

  /// False where the definition has another form.
  bool read_attributes(Cursor& cursor, Definition& d, std::string_view& name, bool& is_global);
  bool read_names(ig::Import& file, Cursor& cursor, const Definition& d, std::string_view name);
  void define_one(ig::Import& file, const Definition& d, std::string_view name, const Sizes& sizes,
                  std::string_view initial);
  void assign_list(ig::Import& file, const Assignment& a);
  static double element_count(const Sizes& sizes);
  /// A short line can fill many elements: those of one array and of a file are limited.
  bool has_room_for(double elements);
  void put(std::string key, std::optional<double> value, std::size_t place, bool is_assigned);

  std::vector<Row> rows_;
  std::unordered_map<std::string, std::size_t> known_;
  std::unordered_map<std::string, Sizes> sizes_;
  std::unordered_set<std::string> local_;  // variables of one program
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
