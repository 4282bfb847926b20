/// Compares aligned blocks and finds for each value that differs the cause: the first syntax that makes something
/// different of what both sides gave it alike. Causes are followed from field to field and from block to block.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>

#include "diff/evidence.hpp"
#include "diff/field_map.hpp"
#include "diff/groups.hpp"
#include "diff/match.hpp"

namespace isogloss::cli::parting {

/// A difference of an earlier comparison: is it still there?
struct Probe {
  std::string file_a, field;
  std::uint32_t line_a = 0;  ///< 0: none
};

struct ComparisonOptions {
  bool are_two_programs = false;
  bool keeps_all = false;  ///< every block that differs is kept for the report
  Probe probe{};
};

class Comparison {
 public:
  Comparison(const FieldMap& map, const SideOf& a, const SideOf& b, const ComparisonOptions& options);

  using Pair = std::array<std::unique_ptr<Snapshot>, 2>;
  /// One of them may be null: only one side has the block. Gives back what is no longer needed.
  Pair add(Pair blocks);
  /// What was reported after the last block.
  void add_ends(const Snapshot& a, const Snapshot& b);
  /// In the order of their number of blocks.
  Report finish();
  /// Errors that both sides reported alike: what follows them may be wrong on both.
  std::uint64_t errors_of_both() const { return errors_of_both_; }

 private:
  struct Difference {
    std::uint32_t field = 0;
    const Cell *a = nullptr, *b = nullptr;
    std::uint16_t writer_a = 0, writer_b = 0;  ///< position + 1; 0: this side did not write it in this block
    bool needs_cause = true;
    int stroke = -1;
    std::uint32_t rank = 0;  ///< of the writer, for the order from cause to effect
  };
  static constexpr int none = -1;

  void index(std::size_t side, const Snapshot& block);
  const Cell* at(std::size_t side, std::uint32_t field) const {
    return stamps_[side][field] == stamp_[side] ? cells_[side][field] : nullptr;
  }
  void compare(const Snapshot& a, const Snapshot& b);
  void add_alone(std::size_t side, const Snapshot& block);
  void collect(const Snapshot& a, const Snapshot& b);
  void collect_strokes(const Snapshot& a, const Snapshot& b);
  void collect_stroke(const Match& pair, const StrokeList* a, const Snapshot& in_a, const StrokeList* b,
                      const Snapshot& in_b, std::uint32_t list);
  void add_difference(Difference difference, const Snapshot& a, const Snapshot& b);
  std::uint16_t last_writer(std::size_t side, std::uint32_t field, const Snapshot& block) const;

  void find_causes(const Snapshot& a, const Snapshot& b);
  int cause_of(const Difference& difference, const Snapshot& a, const Snapshot& b, bool& is_direct);
  struct Input {
    int cause = none;
    double weight = 0;
  };
  Input best_input(const Difference& difference) const;
  double weight_of_input(std::uint32_t field, const Difference& difference) const;
  struct Own {
    int group = none;
    double weight = 0;
  };
  Own own_cause(const Difference& difference, const Snapshot& a, const Snapshot& b);
  int initial_cause(const Difference& difference, const Snapshot& a, const Snapshot& b);
  int group_of(const std::string& key, Group group);
  std::string alias(std::size_t side, std::uint16_t writer) const;
  void find_acting(std::uint16_t& one, std::uint16_t& other) const;
  void note_codes(Group& group, const Difference& difference, const Snapshot& a, const Snapshot& b) const;

  void count(int group, const Difference* difference, bool is_direct, const Snapshot* a, const Snapshot* b);
  Parting parting_of(const Difference& difference, const Snapshot* a, const Snapshot* b) const;
  static PartedBlock block_of(const Snapshot* a, const Snapshot* b);
  void compare_reports(const Snapshot& a, const Snapshot& b);
  std::string report_of_one_side(const Snapshot& a, const Snapshot& b) const;
  void add_report(std::size_t side, const Diagnostic& diagnostic, const Diagnostic* other, const Snapshot& a,
                  const Snapshot& b);

  const FieldMap& map_;
  const std::array<const SideOf*, 2> sides_;
  const ComparisonOptions options_;
  EvidenceFinder evidence_;
  Report report_;
  std::map<std::string, int> groups_;
  std::uint64_t number_ = 0;  // of the block pair
  bool parts_ = false;        // this pair
  bool texts_differ_ = false;
  std::array<std::vector<const Cell*>, 2> cells_;
  std::array<std::vector<std::uint64_t>, 2> stamps_;
  std::array<std::uint64_t, 2> stamp_{};
  Pair last_;  // cells_ points into them
  std::vector<int> cause_, cause_before_;
  std::vector<std::uint32_t> open_, open_before_;  // fields that differ
  std::vector<std::uint32_t> ranks_;               // of the differences of this block that have a cause, by field
  std::vector<Difference> differences_;
  std::map<std::uint64_t, Own> own_of_block_;
  std::uint64_t errors_of_both_ = 0;
  std::uint64_t kept_ = 0;  // the number of the last block in Report::all
};

}  // namespace isogloss::cli::parting
