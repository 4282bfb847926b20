/// What may make one syntax act differently on the two sides: the rows that it asked, its options, its place.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diff/snapshot.hpp"
#include "isogloss/engine/linker.hpp"

namespace isogloss::cli::parting {

struct Evidence {
  enum class Kind : std::uint8_t { row, option };
  Kind kind = Kind::option;
  std::string name_a, name_b;    ///< of the row or option on each side; empty: that side has none
  std::string a, b;              ///< the values, with their unit
  std::string place_a, place_b;  ///< file:line where one is known
  bool is_sure = false;          ///< the same row or option with two values
  /// What a second run has shown in which it was the same on both sides.
  enum class Trial : std::uint8_t { none, cause, no_cause };
  Trial trial = Trial::none;
  std::string option, raw_a;  ///< of an option: its name, and its value without unit
  std::string title;          ///< of rows: what both of them mean; empty: not known, or not the same
  /// Of rows: what gives the row of side B the value of side A, as --set takes it; empty: nothing does.
  std::vector<std::pair<std::string, std::string>> as_a{};
  bool can_be_tried() const { return kind == Kind::option || !as_a.empty(); }
};

/// One of the two sides: what was linked, and what the user gave beside it.
struct SideOf {
  std::string name;
  const LinkedDialect* linked = nullptr;
  std::vector<DependencyElement> given;
  std::vector<std::pair<std::string, std::string>> assignments{};  ///< --set
};

class EvidenceFinder {
 public:
  EvidenceFinder(const SideOf& a, const SideOf& b);

  /// Of the syntax at these positions (+ 1; 0: that side has no such syntax), in these two blocks.
  std::vector<Evidence> find(std::uint16_t a, std::uint16_t b, const Snapshot& block_a, const Snapshot& block_b) const;
  /// The position + 1 of the same syntax in the other chain; 0: it has none.
  std::uint16_t counterpart(int side, std::uint16_t position) const;
  /// Rows that were asked when the syntaxes were created.
  void set_rows_at_start(int side, const std::vector<AskedRow>& rows);

 private:
  struct Row {
    std::size_t dependency;
    std::string row;
    std::shared_ptr<const RowText> text;
  };
  Evidence row_evidence(const Row* a, const Row* b) const;
  std::vector<std::pair<std::string, std::string>> cells_as_a(const Row& a, const Row& b) const;
  std::vector<Row> rows_of(int side, std::uint16_t position, const Snapshot& block) const;
  void add_rows(std::uint16_t a, std::uint16_t b, const Snapshot& block_a, const Snapshot& block_b,
                std::vector<Evidence>& out) const;
  void add_options(std::uint16_t a, std::uint16_t b, std::vector<Evidence>& out) const;
  const LinkedDependency& dependency(int side, std::size_t i) const { return sides_[side]->linked->dependencies[i]; }
  std::string place_of(int side, const Row& row) const;

  const SideOf* sides_[2];
  std::vector<AskedRow> at_start_[2];
};

/// "option retract of BoringCycleSyntax = rapid against feed", for a title.
std::string text_of(const Evidence& evidence);

}  // namespace isogloss::cli::parting
