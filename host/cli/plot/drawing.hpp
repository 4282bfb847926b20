/// The lines of one view, as SVG path data: by pen, a tool or the rapids. A long program is thinned to what can be
/// seen.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plot/projection.hpp"

namespace isogloss::cli::plotting {

/// The cells of the paper that a pen has touched.
class Coverage {
 public:
  explicit Coverage(const Frame& frame);
  /// False when every cell between them has been touched before.
  bool touch(const Spot& from, const Spot& to);

 private:
  bool touch(const Spot& at);
  static constexpr double cell_px_ = 1, margin_px_ = 4;
  Frame frame_;
  std::size_t columns_, rows_;
  std::vector<bool> cells_;
};

struct Thinning {
  bool is_on = false;
  std::vector<bool>* shown = nullptr;  ///< a bit for each move that stands on the paper
};

/// What one pen draws in one view.
class Pen {
 public:
  Pen(const Projection& projection, const Thinning& thinning);
  void draw(const ToolPath& path, std::size_t move);
  /// Everything so far; the pen may be asked once.
  std::string data();

 private:
  struct Vertex {
    Spot at;
    std::size_t move;
  };
  bool draw_arc(const ToolPath& path, const PathMove& m, std::size_t move);
  void flush();
  void simplify(std::size_t first, std::size_t last, std::vector<bool>& keeps) const;
  void go_to(const Spot& at);
  void line_to(const Spot& at);
  void write(double x, double y);
  void write(double value);

  const Projection& projection_;
  const Thinning thinning_;
  Coverage coverage_;
  const double step_;  // px, the last digit that is written
  std::vector<Vertex> waiting_;
  std::string data_;
  Spot written_;  // where the pen stands, as rounded
  bool is_down_ = false;
};

}  // namespace isogloss::cli::plotting
