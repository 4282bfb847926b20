#include "diff/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isogloss::cli::parting {

bool are_same(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return true;
  constexpr double rounding = 1e-9;
  return std::abs(a - b) <= rounding * std::max({1.0, std::abs(a), std::abs(b)});
}

bool are_same(const Cell* a, const Snapshot& in_a, const Cell* b, const Snapshot& in_b) {
  if (a == nullptr || b == nullptr) return a == b;
  if (a->kind != b->kind) return false;
  switch (a->kind) {
    case Cell::Kind::number: return are_same(a->number, b->number);
    case Cell::Kind::text: return a->text == b->text;
    case Cell::Kind::matrix: {
      const auto &one = in_a.matrices[static_cast<std::size_t>(a->number)],
                 &other = in_b.matrices[static_cast<std::size_t>(b->number)];
      for (std::size_t i = 0; i < one.size(); ++i)
        if (!are_same(one[i], other[i])) return false;
      return true;
    }
    default: return true;
  }
}

std::string number_text(double value, int decimals) {
  if (std::abs(value) >= 1e12 || !std::isfinite(value)) return fmt::format("{:g}", value);
  std::string out = fmt::format("{:.{}f}", value, decimals);
  if (out.find('.') != std::string::npos) {
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

std::string value_text(const Cell* cell, const Snapshot& in, bool is_boolean) {
  if (cell == nullptr) return {};
  switch (cell->kind) {
    case Cell::Kind::number: return is_boolean ? (cell->number != 0 ? "true" : "false") : number_text(cell->number);
    case Cell::Kind::text: return cell->text.empty() ? std::string("''") : std::string(cell->text);
    case Cell::Kind::code: return "read";
    case Cell::Kind::matrix: {
      const std::array<double, 16>& m = in.matrices[static_cast<std::size_t>(cell->number)];
      const auto row = [&m](std::size_t i) {
        return fmt::format("{} {} {}", number_text(m[i]), number_text(m[i + 1]), number_text(m[i + 2]));
      };
      const bool turns = m[0] != 1 || m[5] != 1 || m[10] != 1;
      return turns ? fmt::format("turned ({}) ({}) ({}), by {}", row(0), row(4), row(8), row(12))
                   : fmt::format("by {}", row(12));
    }
    default: return {};
  }
}

namespace {

bool are_same_strokes(const Stroke& a, const Snapshot& in_a, const Stroke& b, const Snapshot& in_b) {
  if (a.end - a.begin != b.end - b.begin) return false;
  for (std::uint32_t i = 0; i < a.end - a.begin; ++i) {
    const Cell &one = in_a.stroke_cells[a.begin + i], &other = in_b.stroke_cells[b.begin + i];
    if (one.field != other.field || !are_same(&one, in_a, &other, in_b)) return false;
  }
  return true;
}

/// The same kind of stroke, wherever it goes: its fields, and the values that are no numbers.
bool are_alike(const Stroke& a, const Snapshot& in_a, const Stroke& b, const Snapshot& in_b) {
  if (a.end - a.begin != b.end - b.begin) return false;
  for (std::uint32_t i = 0; i < a.end - a.begin; ++i) {
    const Cell &one = in_a.stroke_cells[a.begin + i], &other = in_b.stroke_cells[b.begin + i];
    if (one.field != other.field || one.kind != other.kind || one.text != other.text) return false;
  }
  return true;
}

}  // namespace

std::vector<Match> match_strokes(const StrokeList& a, const Snapshot& in_a, const StrokeList& b, const Snapshot& in_b) {
  // Equal strokes weigh more than strokes that are only of one kind.
  return match_in_order(static_cast<int>(a.strokes.size()), static_cast<int>(b.strokes.size()), [&](int i, int j) {
    const Stroke &one = a.strokes[static_cast<std::size_t>(i)], &other = b.strokes[static_cast<std::size_t>(j)];
    if (are_same_strokes(one, in_a, other, in_b)) return 3;
    return are_alike(one, in_a, other, in_b) ? 2 : 0;
  });
}

}  // namespace isogloss::cli::parting
