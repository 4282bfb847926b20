#include "plot/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isogloss::cli::plotting {

namespace {

constexpr double seen_px = 0.25;  // what lies nearer to a line than this looks the same

double gap(const Spot& a, const Spot& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// From a point to the line between two others.
double off_line(const Spot& p, const Spot& a, const Spot& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double part = length > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0) : 0;
  return gap(p, {a.x + part * x, a.y + part * y});
}

}  // namespace

Coverage::Coverage(const Frame& frame)
    : frame_(frame),
      columns_(static_cast<std::size_t>((frame.width + 2 * margin_px_) / cell_px_) + 1),
      rows_(static_cast<std::size_t>((frame.height + 2 * margin_px_) / cell_px_) + 1),
      cells_(columns_ * rows_) {}

bool Coverage::touch(const Spot& at) {
  const double x = (at.x - frame_.x + margin_px_) / cell_px_, y = (at.y - frame_.y + margin_px_) / cell_px_;
  const auto column = static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(columns_ - 1)));
  const auto row = static_cast<std::size_t>(std::clamp(y, 0.0, static_cast<double>(rows_ - 1)));
  const std::size_t cell = row * columns_ + column;
  const bool is_new = !cells_[cell];
  cells_[cell] = true;
  return is_new;
}

bool Coverage::touch(const Spot& from, const Spot& to) {
  const int steps = static_cast<int>(gap(from, to) / cell_px_) + 1;
  bool is_new = false;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    is_new = touch({from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part}) || is_new;
  }
  return is_new;
}

Pen::Pen(const Projection& projection, const Thinning& thinning)
    : projection_(projection), thinning_(thinning), coverage_(projection.frame()), step_(thinning.is_on ? 0.1 : 0.01) {}

void Pen::draw(const ToolPath& path, std::size_t move) {
  constexpr std::size_t most_waiting = 4'000;
  const PathMove& m = path.moves[move];
  if (m.arc != PathMove::no_arc && draw_arc(path, m, move)) return;
  const Spot start = projection_.at(path.points[m.first]);
  const bool goes_on = !waiting_.empty() && gap(waiting_.back().at, start) < step_ / 10;
  if (!goes_on || waiting_.size() > most_waiting) flush();
  if (waiting_.empty()) waiting_.push_back({start, move});
  for (std::uint32_t i = 1; i <= m.segments; ++i) waiting_.push_back({projection_.at(path.points[m.first + i]), move});
}

/// False where the arc is no ellipse on the paper, or none that can be seen as one.
bool Pen::draw_arc(const ToolPath& path, const PathMove& m, std::size_t move) {
  const PathArc& arc = path.arcs[m.arc];
  const Ellipse ellipse = project(projection_, arc);
  const Spot rise = projection_.vector(arc.rise);
  if (ellipse.minor < seen_px || std::hypot(rise.x, rise.y) > seen_px) return false;
  flush();
  bool is_new = !thinning_.is_on;
  for (std::uint32_t i = 0; !is_new && i < m.segments; ++i)
    is_new = coverage_.touch(projection_.at(path.points[m.first + i]), projection_.at(path.points[m.first + i + 1]));
  if (!is_new) return true;
  (*thinning_.shown)[move] = true;
  constexpr double turn = 2 * std::numbers::pi;
  // All turns lie on each other; each piece is at most half of one.
  const double sweep = std::abs(arc.sweep) > turn ? std::copysign(turn, arc.sweep) : arc.sweep;
  const double last = std::abs(arc.sweep) > turn ? std::remainder(arc.sweep, turn) : 0;
  go_to(projection_.at(path.points[m.first]));
  const auto draw_piece = [&](double from, double by, const Spot* end) {
    const int pieces = static_cast<int>(std::ceil(std::abs(by) / (std::numbers::pi * 0.999)));
    for (int i = 1; i <= pieces; ++i) {
      const double angle = from + by * i / pieces;
      const Spot to = i == pieces && end != nullptr ? *end : projection_.at(arc.at(angle));
      data_ += 'a';
      write(ellipse.major);
      write(ellipse.minor);
      data_ += fmt::format(" {:.1f} 0 {} ", ellipse.tilt_deg, ellipse.is_clockwise == (by > 0) ? 1 : 0);
      write(to.x - written_.x, to.y - written_.y);
    }
  };
  const Spot end = projection_.at(path.points[m.first + m.segments]);
  draw_piece(0, sweep, last == 0 ? &end : nullptr);
  if (last != 0) draw_piece(0, last, &end);
  return true;
}

/// Marks the points that are needed, so that none is further off than can be seen (Douglas and Peucker).
void Pen::simplify(std::size_t first, std::size_t last, std::vector<bool>& keeps) const {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    double furthest = thinning_.is_on ? seen_px : step_ / 2;
    std::size_t at = 0;
    for (std::size_t i = begin + 1; i < end; ++i)
      if (const double d = off_line(waiting_[i].at, waiting_[begin].at, waiting_[end].at); d > furthest) {
        furthest = d;
        at = i;
      }
    if (at == 0) continue;
    keeps[at] = true;
    open.emplace_back(begin, at);
    open.emplace_back(at, end);
  }
}

void Pen::flush() {
  if (waiting_.size() > 1) {
    std::vector<bool> keeps(waiting_.size());
    keeps.front() = keeps.back() = true;
    simplify(0, waiting_.size() - 1, keeps);
    std::size_t before = 0;
    for (std::size_t i = 1; i < waiting_.size(); ++i) {
      if (!keeps[i]) continue;
      if (!thinning_.is_on || coverage_.touch(waiting_[before].at, waiting_[i].at)) {
        go_to(waiting_[before].at);
        line_to(waiting_[i].at);
        (*thinning_.shown)[waiting_[i].move] = true;
      }
      before = i;
    }
  }
  waiting_.clear();
}

void Pen::write(double value) {
  std::string text = fmt::format("{:.{}f}", value, step_ < 0.1 ? 2 : 1);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  if (text == "-0") text = "0";
  if (!data_.empty() && data_.back() != ' ' && (data_.back() <= '9') && text.front() != '-') data_ += ' ';
  data_ += text;
}

void Pen::write(double x, double y) {
  x = std::round(x / step_) * step_;
  y = std::round(y / step_) * step_;
  write(x);
  write(y);
  written_ = {written_.x + x, written_.y + y};
}

void Pen::go_to(const Spot& at) {
  if (is_down_ && gap(written_, at) < step_) return;
  data_ += is_down_ ? 'm' : 'M';
  is_down_ = true;
  write(at.x - written_.x, at.y - written_.y);
}

void Pen::line_to(const Spot& at) {
  data_ += 'l';
  write(at.x - written_.x, at.y - written_.y);
}

std::string Pen::data() {
  flush();
  return std::move(data_);
}

}  // namespace isogloss::cli::plotting
