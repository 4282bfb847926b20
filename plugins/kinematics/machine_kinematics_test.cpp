#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>

#include "../../tests/support/fake_dependency.hpp"

using isogloss_test::FakeDependency;

namespace {

using Vector = Eigen::Vector3d;
using Rows = FakeDependency::Rows;

constexpr double rad = std::numbers::pi / 180;

struct Angles {
  double a = 0, b = 0, c = 0;
};

/// The service, as other syntaxes reach it.
class Machine {
 public:
  explicit Machine(const Rows& rows)
      : dependency_(*ig_plugin_v1(), "MachineKinematics", rows),
        service_(*dependency_.service<ig_machine_kinematics_1>("isogloss.machine-kinematics/1")) {}

  std::string axes() const {
    char names[2] = {};
    const std::uint32_t n = service_.axes(service_.self, names);
    return {names, n};
  }
  Vector tool(const Angles& at) const {
    const double angles[] = {at.a, at.b, at.c};
    double out[3] = {};
    REQUIRE(service_.tool_axis(service_.self, angles, out) == 1);
    return {out[0], out[1], out[2]};
  }
  /// Row vector times the matrix of the frame.
  Vector carried(const Angles& at, const Vector& p) const {
    const double angles[] = {at.a, at.b, at.c};
    double m[16] = {};
    REQUIRE(service_.pivot(service_.self, angles, m) == 1);
    CHECK((m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1));
    Vector out;
    for (int i = 0; i < 3; ++i) out[i] = p[0] * m[i] + p[1] * m[4 + i] + p[2] * m[8 + i] + m[12 + i];
    return out;
  }
  /// X Y Z of the machine for the tip at p, in machine coordinates of the rotary axes at zero.
  Vector gauge(const Angles& at, const Vector& p, double length) const { return carried(at, p + length * tool(at)); }
  Vector speeds(const Angles& at, const Angles& turning, const Vector& tip, double length, const Vector& feed) const {
    const double angles[] = {at.a, at.b, at.c}, rates[] = {turning.a, turning.b, turning.c};
    double out[3] = {};
    REQUIRE(service_.axis_speeds(service_.self, angles, rates, tip.data(), length, feed.data(), out) == 1);
    return {out[0], out[1], out[2]};
  }
  std::vector<ig_rotary_solution> solve(const Vector& t, const Angles& present = {}) const {
    const double now[] = {present.a, present.b, present.c}, direction[] = {t[0], t[1], t[2]};
    ig_rotary_solution out[2] = {};
    const std::uint32_t n = service_.solve(service_.self, direction, now, out);
    return {out, out + n};
  }
  const ig_machine_kinematics_1& service() const { return service_; }

 private:
  FakeDependency dependency_;
  const ig_machine_kinematics_1& service_;
};

const Rows ac_table{{"A", {{"Place", "table"}, {"Order", 1}}}, {"C", {{"Place", "table"}, {"Order", 2}}}};
const Rows bc_table{{"B", {{"Place", "table"}, {"Order", 1}}}, {"C", {{"Place", "table"}, {"Order", 2}}}};
const Rows ca_head{{"C", {{"Place", "head"}, {"Order", 1}}}, {"A", {{"Place", "head"}, {"Order", 2}}}};
const Rows cb_head{{"C", {{"Place", "head"}, {"Order", 1}}}, {"B", {{"Place", "head"}, {"Order", 2}}}};
const Rows b_head_c_table{{"B", {{"Place", "head"}, {"Order", 1}}}, {"C", {{"Place", "table"}, {"Order", 2}}}};
const Rows a_head_c_table{{"A", {{"Place", "head"}, {"Order", 1}}}, {"C", {{"Place", "table"}, {"Order", 2}}}};
const Rows b_head_a_table{{"B", {{"Place", "head"}, {"Order", 1}}}, {"A", {{"Place", "table"}, {"Order", 2}}}};

/// A head on a C table; its axis lies between Y and Z, at 45 deg to both.
const Rows nutating{{"B", {{"Place", "head"}, {"Order", 1}, {"Y", 1}, {"Z", 1}}},
                    {"C", {{"Place", "table"}, {"Order", 2}}}};

bool near(const Vector& a, const Vector& b, double tolerance = 1e-12) { return (a - b).norm() <= tolerance; }

/// The normal z' of the plane G68.2 I J K.
Vector normal_of(double i, double j) {
  return {std::sin(i * rad) * std::sin(j * rad), -std::cos(i * rad) * std::sin(j * rad), std::cos(j * rad)};
}

void check_pair(const Machine& machine, const Vector& t, double Angles::*tilt, std::array<double, 4> expected,
                double tolerance = 1e-9) {
  const std::vector<ig_rotary_solution> found = machine.solve(t);
  REQUIRE(found.size() == 2);
  const auto is = [&](const ig_rotary_solution& s, double first, double c) {
    const double angle = s.angles[tilt == &Angles::a ? 0 : 1];
    return std::fabs(angle - first) < tolerance && std::fabs(s.angles[2] - c) < tolerance && s.free == 0;
  };
  CAPTURE(t.transpose(), found[0].angles[0], found[0].angles[1], found[0].angles[2], found[1].angles[2]);
  CHECK(((is(found[0], expected[0], expected[1]) && is(found[1], expected[2], expected[3])) ||
         (is(found[1], expected[0], expected[1]) && is(found[0], expected[2], expected[3]))));
}

}  // namespace

TEST_CASE("a table turns the workpiece by minus its angle, as computed on paper") {
  // The centre of the table is at machine zero; the part has a hole at its +X, 50 mm from the centre.
  const Machine machine(Rows{{"C", {{"Place", "table"}}}});
  CHECK(machine.axes() == "C");
  CHECK(near(machine.carried({0, 0, 0}, {50, 0, 0}), {50, 0, 0}, 0));
  // C+90: the tool appears to go round the part by +90, so the part turns by -90 and the hole is at -Y.
  CHECK(near(machine.carried({0, 0, 90}, {50, 0, 0}), {0, -50, 0}, 0));
  CHECK(near(machine.carried({0, 0, 180}, {50, 0, 0}), {-50, 0, 0}, 0));
  CHECK(near(machine.carried({0, 0, -90}, {50, 0, 0}), {0, 50, 0}, 0));
  CHECK(near(machine.carried({0, 0, 30}, {50, 0, 0}), {50 * std::cos(30 * rad), -25, 0}));
  // The tool stays along Z.
  CHECK(near(machine.tool({0, 0, 90}), {0, 0, 1}, 0));
}

TEST_CASE("a head turns the tool by its angle, as computed on paper") {
  // The axis is 200 mm above the gauge point. The tool is 120 mm long, so the tip swings on a radius of 320 mm.
  const Machine machine(Rows{{"B", {{"Place", "head"}, {"PivotZ", 200}}}});
  CHECK(near(machine.tool({0, 90, 0}), {1, 0, 0}, 0));  // the holder is at +X of the tip
  // With the tool upright the gauge point is 120 above the tip. With the tool horizontal the axis is 320 to the right
  // of the tip; X Y Z show the gauge point as if the head were upright, 200 below the axis.
  CHECK(near(machine.gauge({0, 0, 0}, {0, 0, 0}, 120), {0, 0, 120}, 0));
  CHECK(near(machine.gauge({0, 90, 0}, {0, 0, 0}, 120), {320, 0, -200}));
}

TEST_CASE("the usual machines have the expected tool axis") {
  const double a = 25, b = 35, c = 40;
  const double sa = std::sin(a * rad), ca = std::cos(a * rad), sb = std::sin(b * rad), cb = std::cos(b * rad);
  const double sc = std::sin(c * rad), cc = std::cos(c * rad);
  const Angles at{a, b, c};
  const Vector by_a_and_c{sc * sa, -cc * sa, ca}, by_b_and_c{cc * sb, sc * sb, cb}, by_b_and_a{sb, -sa * cb, ca * cb};
  CHECK(near(Machine(ac_table).tool(at), by_a_and_c));
  CHECK(near(Machine(bc_table).tool(at), by_b_and_c));
  CHECK(near(Machine(ca_head).tool(at), by_a_and_c));
  CHECK(near(Machine(cb_head).tool(at), by_b_and_c));
  CHECK(near(Machine(b_head_c_table).tool(at), by_b_and_c));
  CHECK(near(Machine(a_head_c_table).tool(at), by_a_and_c));
  CHECK(near(Machine(b_head_a_table).tool(at), by_b_and_a));
}

TEST_CASE("the axis with Order 1 is named first") {
  CHECK(Machine(ac_table).axes() == "AC");
  CHECK(Machine(ca_head).axes() == "CA");
  CHECK(Machine(b_head_a_table).axes() == "BA");
}

TEST_CASE("a tilted plane has two solutions") {
  struct Row {
    double i, j;
    std::array<double, 4> ac, bc;
  };
  const Row rows[] = {
      {0, 30, {30, 0, -30, 180}, {30, -90, -30, 90}},     {90, 30, {30, 90, -30, -90}, {30, 0, -30, 180}},
      {30, 45, {45, 30, -45, -150}, {45, -60, -45, 120}}, {200, 60, {60, -160, -60, 20}, {60, 110, -60, -70}},
      {0, 90, {90, 0, -90, 180}, {90, -90, -90, 90}},     {45, 90, {90, 45, -90, -135}, {90, -45, -90, 135}},
  };
  const Machine ac(ac_table), bc(bc_table), ca(ca_head), cb(cb_head), mixed(b_head_c_table);
  for (const Row& row : rows) {
    const Vector t = normal_of(row.i, row.j);
    for (const Machine* machine : {&ac, &ca}) check_pair(*machine, t, &Angles::a, row.ac);
    for (const Machine* machine : {&bc, &cb, &mixed}) check_pair(*machine, t, &Angles::b, row.bc);
  }
  // PLANE SPATIAL: z' as turns about the fixed axes X, Y, Z.
  const auto spatial = [](double a, double b, double c) -> Vector {
    return Eigen::AngleAxisd(c * rad, Vector::UnitZ()) * Eigen::AngleAxisd(b * rad, Vector::UnitY()) *
           Eigen::AngleAxisd(a * rad, Vector::UnitX()) * Vector::UnitZ();
  };
  check_pair(ac, spatial(0, 45, 0), &Angles::a, {45, 90, -45, -90});
  check_pair(ac, spatial(0, -30, 0), &Angles::a, {30, -90, -30, 90});
  check_pair(ac, spatial(20, 30, 0), &Angles::a, {35.5313, 53.9476, -35.5313, -126.0524}, 1e-4);
  check_pair(ac, spatial(20, 30, 40), &Angles::a, {35.5313, 93.9476, -35.5313, -86.0524}, 1e-4);
}

TEST_CASE("quarter turns are exact") {
  const auto found = Machine(ac_table).solve({0, -1, 0});
  REQUIRE(found.size() == 2);
  const ig_rotary_solution& positive = found[found[0].angles[0] > 0 ? 0 : 1];
  const ig_rotary_solution& negative = found[found[0].angles[0] > 0 ? 1 : 0];
  CHECK((positive.angles[0] == 90 && positive.angles[2] == 0));
  CHECK((negative.angles[0] == -90 && negative.angles[2] == 180));
  CHECK(near(Machine(ac_table).tool({90, 0, 180}), {0, 1, 0}, 0));
  CHECK(near(Machine(ac_table).tool({-270, 0, 3600000180.0}), {0, 1, 0}, 0));
}

TEST_CASE("a head and a table with A and B have the solutions of their formulas") {
  // B = asin tx, A = atan2(-ty, tz); second: B' = 180 - B, A' = A + 180.
  const Vector t = Vector(0.3, -0.4, 0.5).normalized();
  const double b = std::asin(t.x()) / rad, a = std::atan2(-t.y(), t.z()) / rad;
  const auto found = Machine(b_head_a_table).solve(t);
  REQUIRE(found.size() == 2);
  for (const ig_rotary_solution& s : found) {
    const bool first = std::fabs(s.angles[1]) < 90;
    CHECK(s.angles[1] == Approx(first ? b : 180 - b).margin(1e-9));
    CHECK(s.angles[0] == Approx(first ? a : a - 180).margin(1e-9));
  }
}

TEST_CASE("a singular direction does not move the free axis") {
  const Machine machine(ac_table);
  for (const double z : {1.0, -1.0}) {
    const auto found = machine.solve({0, 0, z}, {12, 0, 745.5});
    REQUIRE(found.size() == 1);
    CHECK(found[0].angles[0] == (z > 0 ? 0 : 180));
    CHECK(found[0].angles[2] == 745.5);
    CHECK(found[0].free == 4);
  }
  CHECK(machine.solve({1e-16, -1e-17, 1}, {0, 0, 33}).at(0).angles[2] == 33);
  // Near the singular direction both solutions exist and are exact.
  for (const double tilt : {1e-3, 1e-6, 1e-9, 1e-11}) {
    const Vector t = Vector(tilt, tilt, 1).normalized();
    const auto found = machine.solve(t);
    REQUIRE(found.size() == 2);
    for (const ig_rotary_solution& s : found) CHECK(near(machine.tool({s.angles[0], 0, s.angles[2]}), t));
  }
  // A table below a head: tool along the axis of A.
  const auto found = Machine(b_head_a_table).solve({1, 0, 0}, {77, 0, 0});
  REQUIRE(found.size() == 1);
  CHECK((found[0].angles[0] == 77 && found[0].angles[1] == 90 && found[0].free == 1));
}

TEST_CASE("a machine with one rotary axis solves the directions that it can reach") {
  const Machine a(Rows{{"A", {{"Place", "table"}}}});
  CHECK(a.axes() == "A");
  const auto found = a.solve({0, -0.5, std::sqrt(0.75)});
  REQUIRE(found.size() == 1);
  CHECK(found[0].angles[0] == Approx(30).margin(1e-12));
  CHECK(a.solve({0.1, 0, 1}).empty());
  const Machine c(Rows{{"C", {{"Place", "table"}}}});
  CHECK(c.solve({0, 0, 2}, {0, 0, 55}).at(0).angles[2] == 55);
  CHECK(c.solve({0, 0, 2}).at(0).free == 4);
  CHECK(c.solve({0, 0, -1}).empty());
  CHECK(c.solve({0, 1, 0}).empty());
}

TEST_CASE("an axis along the tool does not tilt it") {
  // A head that turns the tool about itself, on a tilting table.
  const Machine machine(Rows{{"A", {{"Place", "table"}, {"Order", 1}}}, {"C", {{"Place", "head"}, {"Order", 2}}}});
  const auto found = machine.solve({0, -1, 0}, {0, 0, 20});
  REQUIRE(found.size() == 1);
  CHECK((found[0].angles[0] == 90 && found[0].angles[2] == 20 && found[0].free == 4));
  CHECK(machine.solve({1, 0, 0}).empty());
}

TEST_CASE("a nutating head reaches directions up to 90 degrees from Z") {
  const Machine machine(nutating);
  // Half a turn about the axis between Y and Z moves the tool from Z to Y; it cannot lean more than 90 deg from Z.
  CHECK(near(machine.tool({0, 180, 0}), {0, 1, 0}));
  CHECK(machine.solve({0, 0, -1}).empty());
  CHECK(machine.solve({0.5, 0, -0.001}).empty());
  for (const double tilt : {1.0, 30.0, 60.0, 89.0}) {
    const Vector t = normal_of(70, tilt);
    const auto found = machine.solve(t);
    REQUIRE(found.size() == 2);
    for (const ig_rotary_solution& s : found) {
      CHECK(near(machine.tool({0, s.angles[1], s.angles[2]}), t));
      // cos q = (tz - nz^2) / (1 - nz^2)
      CHECK(std::cos(s.angles[1] * rad) == Approx(2 * t.z() - 1).margin(1e-9));
    }
  }
  const auto end = machine.solve({0, 1, 0});
  REQUIRE(end.size() == 1);
  CHECK(end[0].angles[1] == Approx(180).margin(1e-5));
  CHECK(near(machine.tool({0, end[0].angles[1], end[0].angles[2]}), {0, 1, 0}));
}

TEST_CASE("a table with A and C has the worked positions") {
  // W = (0,0,-50), p = (10,20,0), tool 120 mm.
  const Vector p{10, 20, -50};
  Rows rows = ac_table;
  rows["A"].insert({"PivotZ", -100});
  rows["C"].insert({"PivotZ", -100});
  CHECK(near(Machine(rows).gauge({30, 0, 45}, p, 120), {21.2132, 31.1237, 59.7657}, 1e-4));
  CHECK(near(Machine(rows).gauge({}, p, 120), {10, 20, 70}, 0));
  rows["C"] = {{"Place", "table"}, {"Order", 2}, {"PivotY", 5}, {"PivotZ", -80}};
  CHECK(near(Machine(rows).gauge({30, 0, 45}, p, 120), {17.6777, 32.3920, 59.0335}, 1e-4));
}

TEST_CASE("heads have the worked positions") {
  Rows head = cb_head;
  head["C"].insert({"PivotZ", 200});
  head["B"].insert({"PivotZ", 200});
  const Machine machine(head);
  CHECK(near(machine.gauge({0, 45, 30}, {10, 20, 0}, 120), {205.9592, 133.1371, 26.2742}, 1e-4));
  CHECK(near(machine.gauge({}, {10, 20, 0}, 120), {10, 20, 120}, 0));
  // e, from the C axis to the B axis: M = W + p + (L+H) t - H e_z - Rz(C) e + e.
  head["C"].insert({"PivotX", -15});
  const Vector e{15, 0, 0}, turned{15 * std::cos(30 * rad), 7.5, 0};
  CHECK(near(Machine(head).gauge({0, 45, 30}, {10, 20, 0}, 120),
             machine.gauge({0, 45, 30}, {10, 20, 0}, 120) - turned + e));
  Rows mixed = b_head_c_table;
  mixed["B"].insert({"PivotZ", 200});
  mixed["C"].insert({"PivotZ", -100});
  CHECK(near(Machine(mixed).gauge({0, 45, 30}, {10, 20, -50}, 120), {244.9344, 12.3205, -23.7258}, 1e-4));
}

TEST_CASE("sign and zero of an axis change its angles, not the directions") {
  Rows rows = ac_table;
  rows["A"].insert({"Sign", -1});
  rows["C"].insert({"Zero", 90});
  const Machine usual(ac_table), other(rows);
  CHECK(near(other.tool({-30, 0, 120}), usual.tool({30, 0, 30})));
  CHECK(near(other.carried({-30, 0, 120}, {1, 2, 3}), usual.carried({30, 0, 30}, {1, 2, 3})));
  check_pair(other, usual.tool({30, 0, 170}), &Angles::a, {-30, -100, 30, 80});
}

TEST_CASE("an impossible machine is refused with the reason") {
  const auto reason = [](const Rows& rows) -> std::string {
    try {
      const Machine machine(rows);
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "";
  };
  using Catch::Contains;
  CHECK_THAT(reason({{"A", {{"Order", 1}}}}), Contains("axis A: Place is table or head, not ''"));
  CHECK_THAT(reason({{"U", {{"Place", "table"}}}}), Contains("axis U: its name is A, B or C"));
  CHECK_THAT(reason({{"AC", {{"Place", "table"}}}}), Contains("axis AC: its name is A, B or C"));
  CHECK_THAT(reason({{"B", {{"Place", "arm"}}}}), Contains("axis B: Place is table or head, not 'arm'"));
  CHECK_THAT(reason({{"A", {{"Place", "head"}, {"X", 0}}}}), Contains("axis A: its direction X Y Z is zero"));
  CHECK_THAT(reason({{"A", {{"Place", "head"}, {"Sign", 0.5}}}}), Contains("axis A: Sign is 1 or -1"));
  CHECK_THAT(reason({{"A", {{"Place", "table"}}}, {"C", {{"Place", "table"}}}}), Contains("Order=\"1\""));
  CHECK_THAT(reason({{"A", {{"Place", "table"}, {"Order", 2}}}, {"C", {{"Place", "table"}, {"Order", 2}}}}),
             Contains("A, C"));
  CHECK_THAT(reason({{"A", {{"Place", "table"}, {"Order", 1}}}, {"B", {{"Place", "table"}, {"Order", 2}, {"X", -1}}}}),
             Contains("A, B are parallel"));
  CHECK_THAT(reason({{"A", {{"Place", "table"}}}, {"B", {{"Place", "table"}}}, {"C", {{"Place", "table"}}}}),
             Contains("at most two"));
}

TEST_CASE("the feed of the tip gives the axis speeds computed on paper") {
  // C table, its axis through machine zero; the tip is 100 mm out on X. At 90 deg/s the table passes the tip at 157
  // mm/s. To stay on its point of the workpiece the slides must follow, towards -Y, because C+ turns the workpiece
  // clockwise.
  const Machine table(ac_table);
  const double around = 100 * std::numbers::pi / 2;
  CHECK(near(table.speeds({}, {0, 0, 90}, {100, 0, 0}, 50, {0, 0, 0}), {0, -around, 0}));
  // An additional feed of 10 mm/s outwards is in X of the machine at C0, and in -Y at C90.
  CHECK(near(table.speeds({}, {0, 0, 90}, {100, 0, 0}, 50, {10, 0, 0}), {10, -around, 0}));
  CHECK(near(table.speeds({0, 0, 90}, {0, 0, 90}, {100, 0, 0}, 50, {10, 0, 0}), {-around, -10, 0}));
  // Without rotation the axis speeds are the feed.
  CHECK(near(table.speeds({}, {}, {100, 0, 0}, 50, {1, 2, 3}), {1, 2, 3}));
  // B head with its axis 180 above the gauge point, a tool of 120: the tip rests while the slides carry the head's axis
  // round it at a radius of 300.
  const Machine head({{"B", {{"Place", "head"}, {"PivotZ", 180}}}});
  CHECK(near(head.speeds({}, {0, 90, 0}, {0, 0, 0}, 120, {0, 0, 0}), {300 * std::numbers::pi / 2, 0, 0}));
}

TEST_CASE("without rows there is no service") {
  const FakeDependency none(*ig_plugin_v1(), "MachineKinematics");
  CHECK(none.service<ig_machine_kinematics_1>("isogloss.machine-kinematics/1") == nullptr);
  const FakeDependency one(*ig_plugin_v1(), "MachineKinematics", {{"A", {{"Place", "head"}}}});
  CHECK(one.service<ig_machine_kinematics_1>("isogloss.machine-axis/1") == nullptr);
}

TEST_CASE("an angle that is not finite has no answer") {
  const Machine machine(ac_table);
  const ig_machine_kinematics_1& s = machine.service();
  const double nan = std::nan(""), huge = 1e300;
  double out[16] = {};
  for (const double bad : {nan, HUGE_VAL, -HUGE_VAL}) {
    const double angles[] = {0, 0, bad};
    CHECK(s.tool_axis(s.self, angles, out) == 0);
    CHECK(s.pivot(s.self, angles, out) == 0);
    CHECK(machine.solve({bad, 0, 1}).empty());
    const double still[3] = {}, at_zero[3] = {}, bad_point[] = {bad, 0, 0};
    CHECK(s.axis_speeds(s.self, angles, still, still, 0, still, out) == 0);
    CHECK(s.axis_speeds(s.self, at_zero, angles, still, 0, still, out) == 0);
    CHECK(s.axis_speeds(s.self, at_zero, still, bad_point, 0, bad_point, out) == 0);
    CHECK(s.axis_speeds(s.self, at_zero, still, still, bad, bad_point, out) == 0);
    CHECK(machine.solve({0, 0, 1}, {0, 0, bad}).empty());
  }
  CHECK(machine.solve({0, 0, 0}).empty());
  // B is not an axis of this machine; directions of any length; angles of any number of turns.
  CHECK(near(machine.tool({0, nan, 0}), {0, 0, 1}, 0));
  CHECK(machine.solve({0, -huge, 0}).size() == 2);
  CHECK(machine.solve({0, -1e-300, 0}).size() == 2);
  CHECK(machine.tool({huge, 0, huge}).norm() == Approx(1));
}

// Any axes in any places: the answers agree with each other, and with a chain of transforms computed here.
TEST_CASE("on random machines the answers agree for random directions") {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> unit(-1, 1), angle(-180, 180), mm(-500, 500);
  for (int m = 0; m < 400; ++m) {
    Rows rows;
    std::string names = "ABC";
    std::shuffle(names.begin(), names.end(), random);
    const std::size_t count = m % 8 == 0 ? 1 : 2;
    struct Axis {
      std::size_t letter;
      bool is_table;
      Vector direction, point;
      double sign, zero;
    };
    std::vector<Axis> axes;
    for (std::size_t i = 0; i < count; ++i) {
      Axis axis{names[i] - std::size_t{'A'},
                random() % 2 == 0,
                {unit(random), unit(random), unit(random)},
                {mm(random), mm(random), mm(random)},
                random() % 2 == 0 ? 1.0 : -1.0,
                random() % 2 == 0 ? 0 : angle(random)};
      if (random() % 2 == 0) axis.direction = Vector::Unit(static_cast<int>((random() % 3)));
      if (i == 1 && axis.direction.normalized().cross(axes[0].direction.normalized()).norm() < 0.01)
        axis.direction = Vector(axes[0].direction.y(), axes[0].direction.z(), axes[0].direction.x() + 0.5);
      rows[names.substr(i, 1)] = {{"Place", axis.is_table ? "table" : "head"},
                                  {"Order", static_cast<double>(i + 1)},
                                  {"X", axis.direction.x()},
                                  {"Y", axis.direction.y()},
                                  {"Z", axis.direction.z()},
                                  {"PivotX", axis.point.x()},
                                  {"PivotY", axis.point.y()},
                                  {"PivotZ", axis.point.z()},
                                  {"Sign", axis.sign},
                                  {"Zero", axis.zero}};
      axes.push_back(axis);
    }
    const Machine machine(rows);
    for (int k = 0; k < 50; ++k) {
      double values[3] = {angle(random), angle(random), angle(random)};
      if (k % 5 == 0) values[k % 3] = 90 * static_cast<int>(random() % 4) - 90;
      const Angles at{values[0], values[1], values[2]};
      // The machine as nested frames: base, tables, work; base, slides, heads, tool.
      Eigen::Isometry3d work = Eigen::Isometry3d::Identity(), head = Eigen::Isometry3d::Identity();
      for (const Axis& axis : axes) {
        const double q = axis.sign * (values[axis.letter] - axis.zero) * rad * (axis.is_table ? -1 : 1);
        const Eigen::Isometry3d turn = Eigen::Translation3d(axis.point) *
                                       Eigen::AngleAxisd(q, axis.direction.normalized()) *
                                       Eigen::Translation3d(-axis.point);
        (axis.is_table ? work : head) = (axis.is_table ? work : head) * turn;
      }
      const Vector t = work.linear().transpose() * head.linear() * Vector::UnitZ();
      CHECK(near(machine.tool(at), t));
      // With the slides at x y z the tip of the tool is at x y z + head * (0, 0, -length).
      const Vector tip{mm(random), mm(random), mm(random)};
      const double length = 100 + mm(random) / 10;
      const Vector slides = work * tip - head * Vector(0, 0, -length);
      CHECK(near(machine.gauge(at, tip, length), slides, 1e-9));

      // The axis speeds, compared with the travel of the slides in a short time, forward and backward.
      const Angles turning{angle(random), angle(random), angle(random)};
      const Vector feed{mm(random), mm(random), mm(random)};
      constexpr double dt = 1e-5;
      const auto after = [&](double time) {
        const Angles then{at.a + time * turning.a, at.b + time * turning.b, at.c + time * turning.c};
        return machine.gauge(then, tip + time * feed, length);
      };
      const Vector speeds = machine.speeds(at, turning, tip, length, feed);
      CHECK(near(speeds, (after(dt) - after(-dt)) / (2 * dt), 1e-4));

      const auto found = machine.solve(3 * t, at);
      REQUIRE(!found.empty());
      double nearest = 360;
      for (const ig_rotary_solution& s : found) {
        CHECK(near(machine.tool({s.angles[0], s.angles[1], s.angles[2]}), t));
        double off = 0;
        for (const Axis& axis : axes) {
          if ((s.free >> axis.letter & 1) == 0) CHECK((s.angles[axis.letter] > -180 && s.angles[axis.letter] <= 180));
          off = std::max(off, std::fabs(std::remainder(s.angles[axis.letter] - values[axis.letter], 360)));
        }
        nearest = std::min(nearest, off);
      }
      // Where the two solutions meet, the angle is the square root of a rounding error.
      CHECK(nearest < 1e-4);
    }
  }
}
