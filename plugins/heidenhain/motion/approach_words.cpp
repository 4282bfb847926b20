#include "motion/approach_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr std::array<std::string_view, 8> shape_names{"LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"};

/// LEN belongs to LT and LN, R to CT and LCT, CCA to CT.
bool uses(ContourApproach::Shape shape, std::string_view measure) {
  using Shape = ContourApproach::Shape;
  const bool is_straight = shape == Shape::line || shape == Shape::normal;
  return measure == "LEN" ? is_straight : measure == "R" ? !is_straight : shape == Shape::arc;
}

}  // namespace

bool ApproachShape::is_complete() const {
  using Shape = ContourApproach::Shape;
  if (!shape) return false;
  if (*shape == Shape::line || *shape == Shape::normal) return length && *length >= 0;
  return radius && *radius != 0 && (*shape != Shape::arc || (angle && *angle > 0));
}

std::size_t ApproachWords::scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
                                PathFunction function, ApproachShape& found) const {
  const std::size_t end = letters_end(text, position);
  const std::string_view letters = piece(text, position, end);
  const auto is = [&](std::string_view name) { return equals_ignoring_case(letters, name); };
  for (std::size_t k = 0; k < shape_names.size(); ++k)
    if (is(shape_names[k])) {
      if (found.shape) report_repeated(b, text, position, end);
      found.shape = static_cast<ContourApproach::Shape>(k % 4);
      return end;
    }
  struct Measure {
    std::string_view name;
    std::optional<double>& value;
  };
  for (const Measure& measure :
       {Measure{"LEN", found.length}, Measure{"CCA", found.angle}, Measure{"R", found.radius}}) {
    const std::size_t number = before_value(text, position, measure.name);
    const bool is_side = measure.name == "R" && ContourSide::ends(text, position);
    if (number == position || is_side) continue;
    const Value v = values.read(b, text, number);
    if (v.ok && found.shape && !uses(*found.shape, measure.name)) {
      const std::string of =
          std::string(name_of(function)) + ' ' + std::string(shape_names[static_cast<std::size_t>(*found.shape)]);
      b.report(ig::diag("HEI-0103"), ig::Where::columns(position, v.end), trim(piece(text, position, v.end)),
               std::string_view(of));
      return v.end;
    }
    if (v.ok && measure.value) report_repeated(b, text, position, v.end);
    if (v.ok)
      measure.value = v.number;
    else
      b.report(ig::diag("HEI-0104"), ig::Where::columns(position, number), name_of(function), measure.name);
    return v.ok ? v.end : number;
  }
  return position;
}

void ApproachWords::set(ig::Block& b, const ContourSide& side, PathFunction function, const ApproachShape& found,
                        ig::Where where) const {
  const bool is_approach = function == PathFunction::APPR;
  if (is_approach ? approach(b, side, found) : depart(b, side, found)) return;
  b.report(ig::diag("HEI-0130"), where, name_of(function),
           std::string_view(is_approach ? "the tool goes straight to the first point of the contour"
                                        : "the tool goes straight to the point that is named, if one is"));
}

ContourApproach::Way ApproachWords::way_of(const ig::Block& b, const ApproachShape& found) const {
  const double unit = unit_.in_mm(b);
  return {
      *found.shape, found.length.value_or(0) * unit, found.radius.value_or(0) * unit, found.angle.value_or(0), false,
      std::nullopt};
}

bool ApproachWords::approach(ig::Block& b, const ContourSide& side, const ApproachShape& found) const {
  if (!found.is_complete() || !found.is_beside || side.is_in_force(b)) return false;
  ContourApproach::Way way = way_of(b, found);
  // Up to the start of the approach the tool moves as in the block before; LCT has one feed throughout.
  if (way.shape != ContourApproach::Shape::line_and_arc) {
    way.is_rapid = b.is(motion_in_force_, g00_);
    if (const auto feed = b.get(feed_in_force_); feed && b.is(feed_term_, g94_)) way.feed_mmds = *feed / 60;
  }
  approach_.set(b, way);
  return true;
}

bool ApproachWords::depart(ig::Block& b, const ContourSide& side, const ApproachShape& found) const {
  if (!found.is_complete()) return false;
  if (!side.is_in_force(b) && *found.shape != ContourApproach::Shape::line) return false;
  departure_.set(b, way_of(b, found));
  return true;
}

}  // namespace heidenhain
