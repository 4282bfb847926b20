/// Which ELSE, END_IF and END_FOR belong to which opening. While a file is indexed, each of these statements gets
/// labels: AT@12:0=3 (the statement at line 12, column 0 is of nesting level 3), OPEN@3, BRANCH@3 and CLOSE@3. The
/// partner of a statement is the nearest label of its level before or behind it, also where a GOTO has come into the
/// middle of a loop.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <isogloss/flow.hpp>

#include "macro/macro_scan.hpp"

namespace syntec {

class MacroStructure {
 public:
  static constexpr int deepest = 10;  ///< COM-007
  static constexpr int too_deep = deepest + 1;

  explicit MacroStructure(const ig::Flow& flow) : flow_(flow) {}

  void restart() {
    open_.clear();
    known_.clear();
  }

  /// While a file is indexed: the statement that begins in this block. `label`: the numbers before the colon of CASE.
  void note(ig::Block& b, Keyword k, std::string_view label);

  /// The level of the statement that began at the place; 0: it has no partner.
  int level(ig::Block& b, const ig_place& place);

  static std::string named(std::string_view role, int level) { return std::string(role) + '@' + std::to_string(level); }
  static std::string of_case(const ig_place& place, std::string_view value) {
    return "CASE@" + at_place(place) + '=' + std::string(value);
  }

 private:
  struct Open {
    Keyword keyword;
    ig_place place;
  };
  static std::string at_place(const ig_place& place) {
    return std::to_string(place.line) + ':' + std::to_string(place.column);
  }
  void put(ig::Block& b, std::string_view role, std::size_t level) const {
    if (level <= too_deep) flow_.label(b, named(role, static_cast<int>(level)));
  }
  void close(ig::Block& b, Keyword opening);
  void branch(ig::Block& b, std::string_view label);
  void note_level(ig::Block& b, std::size_t level) const;

  const ig::Flow& flow_;
  std::vector<Open> open_;
  std::map<std::array<std::uint64_t, 2>, int> known_;  // by frame and place
};

}  // namespace syntec
