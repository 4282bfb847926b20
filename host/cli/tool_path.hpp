/// The path of the tool's tip as pictures show it: in the workpiece, with the time of each move.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/motion.hpp"

namespace isogloss::cli {

using Point = std::array<double, 3>;

/// A circular or helical path: center + r·cos φ + q·sin φ + rise·φ/sweep, φ from 0 to sweep (radians).
struct PathArc {
  Point center, r, q, rise;
  double sweep = 0;
  Point at(double angle) const;
  double radius() const;
};

struct PathMove {
  enum class Kind : std::uint8_t { rapid, feed, arc, dwell };
  static constexpr std::uint32_t no_arc = UINT32_MAX;
  Kind kind = Kind::rapid;
  bool is_time_assumed = false;
  bool differs = false;  ///< from the other dialect's, where two are compared
  std::uint16_t file = 0, tool = 0;
  std::uint32_t line = 0;
  std::uint32_t first = 0, segments = 0;  ///< its points are first … first + segments
  std::uint32_t arc = no_arc;             ///< in ToolPath::arcs
  float feed_mm_s = 0;                    ///< 0: none
  float seconds = 0;
};

struct PathTool {
  std::int64_t number = 0;
  std::string name;
  double radius_mm = 0, length_mm = 0;  ///< 0: not known
  std::uint64_t moves = 0;
};

struct Extent {
  Point minimum{}, maximum{};
  bool is_empty = true;
  void add(const Point& p);
  void add(const PathArc& arc);  ///< with its bulge
};

/// A table that turns the workpiece by the angle that the machine shows, right-handed about a line.
struct TurningTable {
  std::size_t axis = 0;  ///< 0: A, 1: B, 2: C
  Point direction{}, point{};
};

/// What the machine's rotary axes do to the workpiece: the tables from the base to the workpiece, `zero` between them.
/// Row vectors, as in the document.
struct PathKinematics {
  bool is_known = false;
  std::string axes;  ///< "AC": the one nearer the base first
  std::vector<TurningTable> tables;
  std::array<double, 16> zero{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

struct ToolPath {
  std::vector<PathMove> moves;
  std::vector<Point> points;
  std::vector<PathArc> arcs;
  /// By point, where the program turns rotary axes: the angles of A B C, and the tool's axis in the workpiece.
  std::vector<std::array<float, 6>> turns;
  /// By move: where the machine's axes end, to compare two dialects by.
  std::vector<std::array<float, 6>> ends;
  std::vector<PathTool> tools;  ///< in the order of their use
  std::deque<std::string> files;
  Extent extent;  ///< of all moves, arcs with their bulge
  double rapid_seconds = 0, feed_seconds = 0, dwell_seconds = 0;
  std::uint64_t assumed_rapids = 0, assumed_feeds = 0;  ///< moves whose rapid rate or feed rate is not known
  bool turns_axes = false;
  PathKinematics kinematics;
  bool is_cut = false;  ///< more moves than a picture holds
};

struct ToolPathOptions {
  std::uint64_t most_moves = 20'000'000;  ///< the run ends behind them
  bool keeps_ends = false;
  double chord_mm = 0.01;  ///< how far the lines between the points of an arc may be from it
};

/// What is assumed where neither machine nor program says it; mm/s.
inline constexpr double assumed_rapid_mm_s = 10'000 / 60.0, assumed_rapid_deg_s = 60, assumed_feed_mm_s = 1'000 / 60.0;

/// An exporter that fills `path`, which must live as long as it does. It belongs to one run.
std::unique_ptr<Exporter> make_path_recorder(ToolPath& path, const RapidRates& rates,
                                             const ToolPathOptions& options = {});

/// Marks the moves of both that differ by more than a micrometre, a thousandth of a degree or in the feed. Returns the
/// places at which they do, in program order, at most `most`.
struct PathDifference {
  std::string file;
  std::uint32_t line = 0;
  std::string what;
};
std::vector<PathDifference> mark_differences(ToolPath& a, ToolPath& b, std::size_t most);

}  // namespace isogloss::cli
