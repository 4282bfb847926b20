/// The rows of tables that have answered, as people read them: values with their unit, and what the row means.
#pragma once

#include <map>
#include <memory>

#include "diff/snapshot.hpp"
#include "isogloss/engine/chain.hpp"

namespace isogloss::cli::parting {

class RowReader {
 public:
  explicit RowReader(const LinkedDialect& linked) : linked_(linked) {}
  void read_from(Chain& chain) { chain_ = &chain; }
  /// The row as it is now; shared as long as its cells keep their values.
  std::shared_ptr<const RowText> read(std::size_t dependency, const std::string& row);

 private:
  struct Known {
    std::vector<std::optional<ig_row_meaning>> meanings;  // by column
    std::vector<std::string> cells;                       // the values that `text` shows
    std::shared_ptr<const RowText> text;
  };
  std::shared_ptr<const RowText> text_of(std::size_t dependency, const std::string& row, const Known& known) const;

  const LinkedDialect& linked_;
  Chain* chain_ = nullptr;
  std::map<std::pair<std::size_t, std::string>, Known> known_;
};

}  // namespace isogloss::cli::parting
