/// The Q parameters that a program writes, its counters of repeats, and its pattern of points. The dependency
/// QParameters owns them; the syntaxes of this plugin reach them through its service.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <isogloss/provenance.hpp>

namespace heidenhain {

inline constexpr const char* q_store_service = "heidenhain.q-parameters/1";

/// Part of a frame's tag: what called the text.
enum CallTag : std::uint64_t { called_label = 1, called_program = 2, called_by_cycle = 3 };

/// Q, QL (local to one program) and QR (kept when the power is off).
enum class QKind : std::uint8_t { q, local, retained };

struct QNumber {
  QKind kind = QKind::q;
  std::uint32_t number = 0;
};

/// A position of PATTERN DEF or of a point table in the plane across the tool, and its height above the surface; mm, as
/// programmed.
struct PatternPoint {
  double first, second, surface;
  double clearance =
      std::numeric_limits<double>::quiet_NaN();  ///< where the tool comes to the point; NaN: nowhere else
};

class QStore {
 public:
  static constexpr std::uint32_t q_count = 2000, other_count = 500;
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

  static bool exists(const QNumber& q) { return q.number < (q.kind == QKind::q ? q_count : other_count); }

  /// The value; NaN where there is none. The parameter must exist. `program` is the frame whose local ones are used.
  double get(const QNumber& q, std::uint64_t program) const {
    if (q.kind == QKind::q) return q_[q.number];
    if (q.kind == QKind::retained) return retained_[q.number];
    for (const Locals& l : locals_)
      if (l.program == program) return l.values[q.number];
    return undefined;
  }
  void set(const QNumber& q, std::uint64_t program, double value) {
    if (q.kind == QKind::q) {
      q_[q.number] = value;
      rows_.overwrite(q.number);
    } else if (q.kind == QKind::retained) {
      retained_[q.number] = value;
    } else {
      locals(program).values[q.number] = value;
    }
  }
  /// The value of Q at the start, from a row of the table.
  void give(std::uint32_t number, double value, std::string_view row) {
    q_[number] = value;
    rows_.give(number, row);
  }
  /// The row whose value the parameter has; nullptr where the program has set it.
  const std::string* row_of(const QNumber& q) const { return q.kind == QKind::q ? rows_.of(q.number) : nullptr; }

  /// A text of QS0 to QS1999; nothing where it has none.
  std::optional<std::string_view> text(std::uint32_t number) const {
    const auto found = texts_.find(number);
    return found != texts_.end() ? std::optional<std::string_view>(found->second) : std::nullopt;
  }
  void set_text(std::uint32_t number, std::string text) { texts_[number] = std::move(text); }
  static constexpr std::size_t longest_text = 255;

  static constexpr std::uint32_t radius_of_tool = 108, length_of_tool = 114;
  /// What a tool call leaves in a parameter. `undefined` ends the value of the tool before, but not a value that a
  /// table of parameters has given.
  void set_of_tool(std::uint32_t number, double value) {
    const auto written = std::find(of_tool_.begin(), of_tool_.end(), number);
    if (std::isnan(value) && written == of_tool_.end()) return;
    if (written == of_tool_.end()) of_tool_.push_back(number);
    q_[number] = value;
    rows_.overwrite(number);
  }

  /// CALL LBL … REP: counts one repeat of the part down from `total`. False: none is left.
  bool repeat(std::uint64_t frame, std::uint64_t offset, double total) {
    const auto same = [&](const Repeat& r) { return r.frame == frame && r.offset == offset; };
    const auto it = std::find_if(repeats_.begin(), repeats_.end(), same);
    if (it == repeats_.end()) {
      if (!(total >= 1)) return false;
      // A part that a jump has left leaves its counter behind.
      if (repeats_.size() >= most_repeats) repeats_.erase(repeats_.begin());
      repeats_.push_back({frame, offset, std::floor(total) - 1});
      return true;
    }
    if (it->left < 1) {
      repeats_.erase(it);
      return false;
    }
    --it->left;
    return true;
  }

  /// "a repeat follows, and then 2 more": for an explanation, after repeat() has counted.
  std::string repeats_left(std::uint64_t frame, std::uint64_t offset) const {
    for (const Repeat& r : repeats_)
      if (r.frame == frame && r.offset == offset && r.left >= 1)
        return "a repeat follows, and then " + std::to_string(static_cast<std::int64_t>(r.left)) + " more";
    return "the last repeat follows";
  }

  /// True when the text is reported for the first time at this place of a program, where a loop may come again and
  /// again. For a cause that occurs in many places, the number of its diagnostic stands for the place.
  bool is_first_time(std::uint64_t offset, std::string_view text) {
    const std::uint64_t place = offset ^ (std::hash<std::string_view>{}(text) << 1);
    if (std::find(said_.begin(), said_.end(), place) != said_.end()) return false;
    if (said_.size() < most_places) said_.push_back(place);
    return true;
  }

  /// The points of the last PATTERN DEF or SEL PATTERN, for CYCL CALL PAT.
  std::vector<PatternPoint> pattern;

 private:
  struct Locals {
    std::uint64_t program;
    std::vector<double> values;
  };
  struct Repeat {
    std::uint64_t frame, offset;
    double left;
  };
  static constexpr std::size_t most_repeats = 1000, most_programs = 64, most_places = 1000;

  Locals& locals(std::uint64_t program) {
    for (Locals& l : locals_)
      if (l.program == program) return l;
    if (locals_.size() >= most_programs) locals_.erase(locals_.begin());
    locals_.push_back({program, std::vector<double>(other_count, undefined)});
    return locals_.back();
  }

  ig::RowOrigins<std::uint32_t> rows_;
  std::vector<double> q_ = std::vector<double>(q_count, undefined);
  std::map<std::uint32_t, std::string> texts_;
  std::vector<double> retained_ = std::vector<double>(other_count, undefined);
  std::vector<Locals> locals_;
  std::vector<Repeat> repeats_;
  std::vector<std::uint32_t> of_tool_;
  std::vector<std::uint64_t> said_;
};

}  // namespace heidenhain
