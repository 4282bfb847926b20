/// Rows of ToolOffsetTable from tool data, $TC_DP and $TC_TP2. Manual Tools, "Tool offset data".
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "archive/archive_lengths.hpp"
#include "archive/data_line.hpp"

namespace siemens {

inline constexpr std::int64_t most_edges = 99;

class ToolRows {
 public:
  /// An assignment whose name begins with $TC_.
  void assign(ig::Import& file, const Assignment& a);
  /// Gives the rows to the file; `edge_step` is 0 where edges are indices.
  void give(ig::Import& file, ArchiveLengths& lengths, std::int64_t edge_step) const;

 private:
  struct Placed {
    double value;
    std::size_t begin, end;
  };
  struct Edge {
    std::optional<double> length, adapter, length_wear, radius, radius_wear;
    std::optional<Placed> corner, corner_wear;
    double type = 0;
    bool has_type = false;
    std::string name;
    std::size_t begin = 0, end = 0;

    bool is_turning_tool() const { return type >= 500 && type < 600; }
    /// Of slotting saws the control keeps the diameter.
    double radius_of_entry() const { return type >= 700 && type < 710 ? 0.5 : 1; }
  };
  static void give_corner(ig::Import& file, const Edge& e, ArchiveLengths& lengths);
  void assign_edge_data(ig::Import& file, const Assignment& a, std::int64_t number);
  Edge* edge(ig::Import& file, const Assignment& a, std::int64_t tool, std::int64_t number);

  std::map<std::pair<std::int64_t, std::int64_t>, Edge> edges_;
};

}  // namespace siemens
