#include "export/motion_reader.hpp"

#include <cmath>
#include <cstring>
#include <numbers>

namespace isogloss {

namespace {

/// Coordinates that are closer are the same place: an offset there and back leaves such differences.
constexpr double same_place_mm = 1e-7;
/// Ends of an arc that are closer make a full circle.
constexpr double closed_arc_mm = 1e-6;

constexpr const char* axis_names[] = {"X", "Y", "Z", "A", "B", "C"};

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

/// First and second axis of a plane; counter-clockwise turns the first towards the second.
struct PlaneAxes {
  int first, second;
};

/// Three values that are written together: a copy that follows at once reads them in larger pieces, and would have to
/// wait for stores of single ones.
struct Xyz {
  double x, y, z;
  void put(double (&out)[6]) const {
    out[0] = x;
    out[1] = y;
    out[2] = z;
  }
};

void copy_xyz(double (&to)[6], const double (&from)[6]) { std::memcpy(to, from, 3 * sizeof from[0]); }

void advance(AxisPoint& position, const AxisPoint& to) {
  if (to.known == AxisPoint::xyz) {
    copy_xyz(position.at, to.at);
    position.known |= AxisPoint::xyz;
    return;
  }
  for (unsigned i = 0; (to.known >> i) != 0; ++i)
    if (to.has(i)) position.at[i] = to.at[i];
  position.known |= to.known;
}

/// The unit vector about which the mapped plane turns from its first axis to its second. Computed from the two axes, so
/// that the sense stays right in a mirrored frame.
void map_normal(const Frame& frame, PlaneAxes plane, double (&out)[3]) {
  if (frame.kind != Frame::Kind::general) {
    for (int i = 0; i < 3; ++i) out[i] = i == 3 - plane.first - plane.second ? 1 : 0;
    return;
  }
  const double* a = frame.matrix + 4 * plane.first;
  const double* b = frame.matrix + 4 * plane.second;
  const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int i = 0; i < 3; ++i) out[i] = length > 0 ? n[i] / length : 0;
}

}  // namespace

/// Degrees from start to end about the center, signed; ±360 where they coincide, or lie in one direction from it.
double sweep_deg(const Move& move) {
  const Arc& arc = move.arc;
  if (arc.sweep) return *arc.sweep;
  const double sign = arc.is_ccw ? 1 : -1;
  const double turns = sign * 360 * static_cast<double>(arc.additional_circles);
  const int i = arc.first_axis, j = arc.second_axis;
  const double* const end = move.program.at;
  if (std::abs(end[i] - arc.start[i]) < closed_arc_mm && std::abs(end[j] - arc.start[j]) < closed_arc_mm)
    return sign * 360 + turns;
  const double u[2] = {arc.start[i] - arc.center[i], arc.start[j] - arc.center[j]};
  const double v[2] = {end[i] - arc.center[i], end[j] - arc.center[j]};
  double angle = degrees(sign * std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
  if (angle < 0) angle += 360;
  // Rounding must not decide between nothing and a circle.
  if (angle * std::sqrt(v[0] * v[0] + v[1] * v[1]) < degrees(closed_arc_mm)) angle = 360;
  return sign * angle + turns;
}

void MotionReader::AxisFields::find_run() {
  unsigned count = 0;
  while (count < 6 && ids[count] != IG_NO_FIELD) ++count;
  for (unsigned i = 0; i < 6; ++i)
    if (i < count ? ids[i] != ids[0] + i : ids[i] != IG_NO_FIELD) return;
  if (count >= 3 && (ids[0] & 63) + count <= 64) run = (1u << count) - 1;
}

void MotionReader::begin(const Document& initial, const SymbolTable& symbols) {
  const Layout& layout = initial.layout();
  const std::string items = "CompoundMotion.Items";
  const auto fields = [&](auto id) {
    Fields f{};
    for (int i = 0; i < 3; ++i) {
      f.program.ids[i] = id(std::string("ProgramXyz.") + axis_names[i]);
      f.center[i] = id(std::string("MotionEvent.ArcCenter.") + axis_names[i]);
    }
    for (int i = 0; i < 6; ++i) f.machine.ids[i] = id(std::string("MachineCoordinate.") + axis_names[i]);
    f.program.find_run();
    f.machine.find_run();
    f.form = id("MotionEvent.Form");
    f.is_rapid = id("MotionEvent.IsRapid");
    f.is_manual = id("MotionEvent.IsManual");
    f.feed = id("MotionEvent.Feedrate_mmds");
    f.is_ccw = id("MotionEvent.IsCcw");
    f.circles = id("MotionEvent.AdditionalCircleNum");
    return f;
  };
  root_ = fields([&](const std::string& path) { return layout.id(path); });
  program_before_ = {};
  for (int i = 0; i < 3; ++i) {
    led_start_.ids[i] = layout.id(std::string("PivotTransform.Start.") + axis_names[i]);
    for (ig_field f = 0; f < layout.fields.size(); ++f)
      if (layout.fields[f].previous_of != IG_NO_FIELD && layout.fields[f].previous_of == root_.program.ids[i])
        program_before_.ids[i] = f;
  }
  list_ = layout.lists.size();
  for (std::size_t i = 0; i < layout.lists.size(); ++i)
    if (layout.lists[i].path == items) list_ = i;
  const auto in_item = [&](const std::string& path) {
    const ig_field f = layout.record(items, path);
    return f == IG_NO_FIELD ? f : static_cast<ig_field>(index_in_record(f));
  };
  item_ = fields(in_item);
  item_dwell_ = in_item("Dwell.Time");
  item_direction_ = in_item("SpindleControl.Direction");
  item_orient_ = in_item("SpindleOrientation.Angle_deg");

  is_change_ = layout.id("ToolChange.IsChange");
  tool_ = layout.id("ToolChange.ToolId");
  spindle_tool_ = layout.id("ToolChange.SpindleToolId");
  direction_ = layout.id("SpindleSpeed.Direction");
  speed_ = layout.id("SpindleSpeed.SpindleSpeed_rpm");
  coolant_ = layout.id("Coolant.Mode");
  dwell_ = layout.id("Dwell.Time");
  orient_ = layout.id("SpindleOrientation.Angle_deg");
  plane_ = layout.id("PlaneSelect.Plane");
  program_stop_ = layout.id("ProgramStop.Term");
  program_end_ = layout.id("ProgramEnd.Term");
  others_.clear();
  for (const ig_field f : {is_change_, direction_, speed_, coolant_, dwell_, orient_, program_stop_, program_end_}) {
    if (f == IG_NO_FIELD) continue;
    if (others_.empty() || others_.back().word != f >> 6) others_.push_back({f >> 6, 0});
    others_.back().bits |= std::uint64_t{1} << (f & 63);
  }
  step_events_ = 0;
  for (const ig_field f : {item_dwell_, item_orient_, item_direction_})
    if (f < 64) step_events_ |= std::uint64_t{1} << f;
  for (KnownName* name : {&linear_, &led_, &arc_, &stop_, &off_, &xy_, &zx_, &yz_}) name->forget();

  position_ = {};
  program_position_ = {};
  is_in_frame_ = false;
  for (unsigned i = 0; i < 6; ++i) {
    if (!initial.present(root_.machine.ids[i])) continue;
    position_.at[i] = initial.number(root_.machine.ids[i]);
    position_.known |= 1u << i;
  }
  spindle_direction_ = symbol(initial, direction_);
  spindle_turns_ = spindle_direction_ != 0 && !stop_.is(spindle_direction_, symbols);
  spindle_speed_ = initial.present(speed_) ? initial.number(speed_) : 0;
  coolant_mode_ = symbol(initial, coolant_);
  if (off_.is(coolant_mode_, symbols)) coolant_mode_ = 0;
}

bool MotionReader::changes_spindle(ig_symbol direction, const Document& d, const SymbolTable& symbols) {
  const bool turns = !stop_.is(direction, symbols);
  const double speed = d.present(speed_) ? d.number(speed_) : 0;
  const bool same =
      turns ? spindle_turns_ && direction == spindle_direction_ && speed == spindle_speed_ : !spindle_turns_;
  spindle_turns_ = turns;
  spindle_direction_ = direction;
  spindle_speed_ = speed;
  return !same;
}

const Move* MotionReader::root_move(Document& d, const SymbolTable& symbols) {
  return make_move(Root{d}, root_, d, symbols);
}

const Move* MotionReader::item_move(const Record& item, Document& d, const SymbolTable& symbols) {
  return make_move(item, item_, d, symbols);
}

template <class Values>
void MotionReader::read_point(const Values& values, const AxisFields& fields, AxisPoint& point) {
  if (fields.run != 0) {
    point.known = static_cast<std::uint32_t>(values.bits_from(fields.ids[0])) & fields.run;
    if (point.known == AxisPoint::xyz) {
      for (unsigned i = 0; i < 3; ++i) point.at[i] = values.number(fields.ids[0] + i);
      return;
    }
    for (unsigned i = 0; (fields.run >> i) != 0; ++i) point.at[i] = values.number(fields.ids[0] + i);
    return;
  }
  point.known = 0;
  for (unsigned i = 0; i < 6; ++i) {
    if (!values.present(fields.ids[i])) continue;
    point.at[i] = values.number(fields.ids[i]);
    point.known |= 1u << i;
  }
}

template <class Values>
bool MotionReader::is_plain(const Values& values, const Fields& fields) const {
  return position_.known == AxisPoint::xyz && fields.machine.run != 0 && fields.program.run != 0 &&
         (values.bits_from(fields.machine.ids[0]) & fields.machine.run) == AxisPoint::xyz &&
         (values.bits_from(fields.program.ids[0]) & fields.program.run) == AxisPoint::xyz;
}

template <class Values>
void MotionReader::read_speed(const Values& values, const Fields& fields, bool is_arc) {
  const auto is_true = [&](ig_field f) { return values.present(f) && values.value(f).integer != 0; };
  Move& m = move_;
  m.kind = is_arc ? Move::Kind::arc : is_true(fields.is_rapid) ? Move::Kind::rapid : Move::Kind::feed;
  m.is_manual = is_true(fields.is_manual);
  m.has_feed = m.kind != Move::Kind::rapid && values.present(fields.feed);
  m.feed_mmds = m.has_feed ? values.number(fields.feed) : 0;
}

template <class Values>
const Move* MotionReader::make_plain_move(const Values& values, const Fields& fields) {
  const ig_field machine = fields.machine.ids[0], program = fields.program.ids[0];
  const Xyz to{values.number(machine), values.number(machine + 1), values.number(machine + 2)};
  const Xyz named{values.number(program), values.number(program + 1), values.number(program + 2)};
  const Xyz from{position_.at[0], position_.at[1], position_.at[2]};
  // The axes that move change from move to move: no branch for each.
  const int staying = int{std::abs(to.x - from.x) <= same_place_mm} + int{std::abs(to.y - from.y) <= same_place_mm} +
                      int{std::abs(to.z - from.z) <= same_place_mm};
  if (staying == 3 && !keep_zero_moves_) return nullptr;
  Move& m = move_;
  to.put(m.machine.at);
  to.put(position_.at);
  named.put(m.program.at);
  named.put(program_position_.at);
  from.put(m.from.at);
  m.from.known = m.machine.known = m.program.known = AxisPoint::xyz;
  program_position_.known |= AxisPoint::xyz;
  is_in_frame_ = true;
  m.is_led = false;
  read_speed(values, fields, false);
  return &m;
}

template <class Values>
const Move* MotionReader::make_move(const Values& values, const Fields& fields, Document& d,
                                    const SymbolTable& symbols) {
  const auto form = static_cast<ig_symbol>(values.value(fields.form).symbol);
  if (linear_.is(form, symbols) && is_plain(values, fields)) return make_plain_move(values, fields);
  const bool is_led = !linear_.is(form, symbols) && led_.is(form, symbols);
  const bool is_arc = !is_led && !linear_.is(form, symbols) && arc_.is(form, symbols);
  Move& m = move_;
  read_point(values, fields.program, m.program);
  read_point(values, fields.machine, m.machine);
  // A step names the axes that it moves; the others stay where they are.
  const std::uint32_t staying = position_.known & ~m.machine.known;
  if (&fields == &item_ && m.machine.known != 0 && staying != 0) {
    for (unsigned i = 0; i < 6; ++i)
      if ((staying >> i & 1u) != 0) m.machine.at[i] = position_.at[i];
    m.machine.known |= staying;
  }
  if (!is_arc && !keep_zero_moves_ && goes_nowhere()) return nullptr;

  m.is_led = is_led;
  read_speed(values, fields, is_arc);
  m.from = position_;
  if (is_led) {
    read_point(Root{d}, led_start_, m.start);
    if (!m.start.has_xyz()) read_point(Root{d}, program_before_, m.start);
    if (!m.start.has_xyz()) m.start = program_position_;
  }
  if (is_arc) make_arc(values, fields, d, symbols);
  advance(position_, m.machine);
  advance(program_position_, m.program);
  is_in_frame_ = m.program.has_xyz();
  return &m;
}

bool MotionReader::goes_nowhere() const {
  const AxisPoint& to = move_.machine;
  const auto is_there = [&](unsigned i) { return std::abs(to.at[i] - position_.at[i]) <= same_place_mm; };
  if (to.known == AxisPoint::xyz && position_.has_xyz()) return is_there(0) && is_there(1) && is_there(2);
  if (to.known == 0 || (to.known & ~position_.known) != 0) return false;
  for (unsigned i = 0; (to.known >> i) != 0; ++i)
    if (to.has(i) && !is_there(i)) return false;
  return true;
}

template <class Values>
void MotionReader::make_arc(const Values& values, const Fields& fields, Document& d, const SymbolTable& symbols) {
  Arc& arc = move_.arc;
  const ig_symbol plane = symbol(d, plane_);
  PlaneAxes axes{0, 1};
  arc.plane = "XY";
  if (plane != 0 && !xy_.is(plane, symbols)) {
    arc.plane = symbols.text(plane);
    if (zx_.is(plane, symbols)) axes = {2, 0};
    if (yz_.is(plane, symbols)) axes = {1, 2};
  }
  arc.is_ccw = values.present(fields.is_ccw) && values.value(fields.is_ccw).integer != 0;
  arc.additional_circles = values.present(fields.circles) ? values.value(fields.circles).integer : 0;
  arc.has_center = true;
  for (int i = 0; i < 3; ++i) {
    if (values.present(fields.center[i]))
      arc.center[i] = values.number(fields.center[i]);
    else
      arc.has_center = false;
  }
  // The start in this block's frame: the last point that was programmed may stand in another.
  for (int i = 0; i < 3; ++i) arc.start[i] = program_position_.at[i];
  if (!is_in_frame_ && position_.has_xyz())
    d.map_to_program({position_.at[0], position_.at[1], position_.at[2]}, arc.start);
  if (!arc.has_center) return;
  arc.first_axis = static_cast<std::uint8_t>(axes.first);
  arc.second_axis = static_cast<std::uint8_t>(axes.second);
  const Frame& frame = d.composed();
  frame.map(arc.center, arc.machine_center);
  map_normal(frame, axes, arc.normal);
}

}  // namespace isogloss
