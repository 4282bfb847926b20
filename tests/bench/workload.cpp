// Writes part programs to measure interpreters with: exactly N blocks, the same bytes for the same seed.
//
//   workload surface|mixed|drilling|five-axis N [--seed S] [--cycles G81,G82...] [--repeat K|L] [-o FILE]
//
// Every program is valid for a Fanuc milling control and for LinuxCNC: no O number, arcs within LinuxCNC's radius
// tolerance, one group 01 code a block, G80 alone, repeats only in G91 blocks that stand by themselves. The letter of
// the repeats is the only word on which the two disagree. five-axis is for a Fanuc with a table A that carries a
// table C (five_axis.xml): LinuxCNC has no tool centre point control.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>

#include "part_program.hpp"

namespace {

using namespace bench;

void mount_tool(Program& p, Random& random, int tool, std::string_view what) {
  p.block("(" + std::string(what) + " T" + std::to_string(tool) + ")");
  p.block(code('T', tool), "M6");
  p.block(code('G', random.from(54, 59)));
  p.block(code('S', 50 * random.from(20, 240)), "M3");
}

void approach(Program& p, int tool, Point at) {
  p.block("G0", word('X', at.x, 4), word('Y', at.y, 4));
  p.block("G43", code('H', tool), "Z50.");
  p.block("M8");
}

// A ball end mill over a dome with ripples, to and fro. Points stand closer where the surface bends, and the feed
// changes with the slope, as a chordal tolerance gives it.
void surface(Program& p, Random& random) {
  p.start();
  mount_tool(p, random, 4, "FINISH R3 BALL");
  approach(p, 4, {0, 0});
  const double turn = random.between(0.2, 1.2);
  const double ripple = random.between(0.3, 0.6);
  const double length = 140;
  std::string old_x, old_y, old_z;
  int old_feed = 0;
  bool cutting = false;
  for (int row = 0; p.room(); ++row) {
    const double v = 0.22 * row - 40;
    double u = 0;
    while (u < length && p.room()) {
      const double along = row % 2 == 0 ? u : length - u;
      const double slope = std::sin(along * ripple) * std::cos(v * 0.13);
      const double z = 18 + along * (length - along) / 400 - v * v / 180 + 0.7 * slope;
      const std::string x = word('X', along * std::cos(turn) - v * std::sin(turn));
      const std::string y = word('Y', along * std::sin(turn) + v * std::cos(turn));
      const std::string height = word('Z', z);
      const int feed = 600 + 400 * static_cast<int>(4 * (1 - std::abs(slope)) + random.between(0, 0.4));
      const bool new_feed = feed != old_feed && (old_feed == 0 || random.chance(0.08));
      if (new_feed) old_feed = feed;
      p.block(cutting ? "" : "G1", x == old_x ? "" : x, y == old_y ? "" : y, height == old_z ? "" : height,
              new_feed ? code('F', feed) : "");
      cutting = true;
      old_x = x;
      old_y = y;
      old_z = height;
      u += 0.08 + 0.35 * (1 - std::abs(slope)) + random.between(0, 0.05);
    }
  }
  p.finish();
}

// The same kind of surface with the tool upright on it (a few degrees of tilt), under tool centre point control: X Y Z,
// A and C in nearly every block.
void five_axis(Program& p, Random& random) {
  p.start();
  mount_tool(p, random, 4, "FINISH R3 BALL, 5 AXES");
  p.block("G0", "A0.", "C0.");
  p.block("G43.4", "H4");
  p.block("G0", "X0.", "Y0.", "Z60.");
  p.block("M8");
  const double ripple = random.between(0.1, 0.2);
  const double length = 140;
  int old_feed = 0;
  bool cutting = false;
  for (int row = 0; p.room(); ++row) {
    const double v = 0.22 * row - 40;
    double u = 0;
    while (u < length && p.room()) {
      const double along = row % 2 == 0 ? u : length - u;
      const double slope = std::sin(along * ripple) * std::cos(v * 0.13);
      const double z = 18 + along * (length - along) / 400 - v * v / 180 + 0.7 * slope;
      const double dx = (length - 2 * along) / 400 + 0.7 * ripple * std::cos(along * ripple) * std::cos(v * 0.13);
      const double dy = -v / 90 - 0.7 * 0.13 * std::sin(along * ripple) * std::sin(v * 0.13);
      const double tilt = std::atan(std::hypot(dx, dy)) * 180 / pi;  // the normal is (-dx, -dy, 1)
      const double turn = std::atan2(-dx, dy) * 180 / pi;
      const int feed = 600 + 400 * static_cast<int>(4 * (1 - std::abs(slope)) + random.between(0, 0.4));
      const bool new_feed = feed != old_feed && (old_feed == 0 || random.chance(0.08));
      if (new_feed) old_feed = feed;
      p.block(cutting ? "" : "G1", word('X', along), word('Y', v), word('Z', z), word('A', tilt), word('C', turn),
              new_feed ? code('F', feed) : "");
      cutting = true;
      u += 0.08 + 0.35 * (1 - std::abs(slope)) + random.between(0, 0.05);
    }
  }
  p.block("G0", "Z80.");
  p.block("G49");
  p.finish();
}

// Tracks position and group 01, so that a cutting move writes only what changes.
class Cutter {
 public:
  Cutter(Program& p, Point at) : p_(p), at_(at) {}
  Point at() const { return at_; }

  void rapid(Point to) {
    p_.block(group(0), word('X', to.x, 4), word('Y', to.y, 4));
    at_ = to;
  }
  void height(int motion, double z, const std::string& feed = "") { p_.block(group(motion), word('Z', z), feed); }
  void line(Point to, const std::string& feed = "") {
    const std::string x = to.x == at_.x ? "" : word('X', to.x, 4);
    const std::string y = to.y == at_.y ? "" : word('Y', to.y, 4);
    if (x.empty() && y.empty()) return;
    p_.block(group(1), x, y, feed);
    at_ = to;
  }
  void arc_by_centre(int motion, Point to, Point centre, const std::string& z = "") {
    p_.block(group(motion), word('X', to.x, 4), word('Y', to.y, 4), z, word('I', round4(centre.x - at_.x), 4),
             word('J', round4(centre.y - at_.y), 4));
    at_ = to;
  }
  void arc_by_radius(int motion, Point to, double radius) {
    p_.block(group(motion), word('X', to.x, 4), word('Y', to.y, 4), word('R', radius, 4));
    at_ = to;
  }
  void forget_group() { motion_ = -1; }

 private:
  std::string group(int motion) {
    if (motion == motion_) return "";
    motion_ = motion;
    return code('G', motion);
  }
  Program& p_;
  Point at_;
  int motion_ = -1;
};

struct Pocket {
  Point centre;
  double half_width;
  double half_height;
  double corner;
  double turn;

  Point at(double u, double v) const {
    return {round4(centre.x + u * std::cos(turn) - v * std::sin(turn)),
            round4(centre.y + u * std::sin(turn) + v * std::cos(turn))};
  }
};

// One round along a rectangle with rounded corners, inset from the wall; climb milling runs counter-clockwise.
void round_of(Cutter& cutter, const Pocket& pocket, double inset, bool by_radius, const std::string& feed) {
  const double w = pocket.half_width - inset;
  const double h = pocket.half_height - inset;
  const double r = round4(std::min(pocket.corner, 0.8 * std::min(w, h)));
  cutter.line(pocket.at(-w + r, -h), feed);
  struct Corner {
    double side_u, side_v, end_u, end_v, centre_u, centre_v;
  };
  const std::array<Corner, 4> corners{{{w - r, -h, w, -h + r, w - r, -h + r},
                                       {w, h - r, w - r, h, w - r, h - r},
                                       {-w + r, h, -w, h - r, -w + r, h - r},
                                       {-w, -h + r, -w + r, -h, -w + r, -h + r}}};
  for (const Corner& c : corners) {
    cutter.line(pocket.at(c.side_u, c.side_v));
    const Point end = pocket.at(c.end_u, c.end_v);
    if (by_radius) {
      cutter.arc_by_radius(3, end, r);
    } else {
      cutter.arc_by_centre(3, end, pocket.at(c.centre_u, c.centre_v));
    }
  }
}

void cut_pocket(Program& p, Random& random, Cutter& cutter) {
  Pocket pocket{};
  pocket.centre = {round4(random.between(-90, 90)), round4(random.between(-70, 70))};
  pocket.half_width = random.between(10, 28);
  pocket.half_height = random.between(8, 20);
  pocket.corner = random.between(3, 6);
  pocket.turn = random.chance(0.4) ? 0 : random.between(0, pi);
  const double step = random.between(1.5, 4);
  cutter.rapid(pocket.at(2, 0));
  cutter.height(0, 2);
  double z = 0;
  const int levels = random.from(2, 5);
  for (int level = 0; level < levels && p.room(); ++level) {
    // Down on a helix of two half turns about the pocket's middle, then outwards.
    cutter.line(pocket.at(2, 0));
    cutter.height(1, z, code('F', 20 * random.from(5, 20)));
    z -= random.of(std::array{0.5, 1.0, 1.5});
    cutter.arc_by_centre(3, pocket.at(-2, 0), pocket.centre, word('Z', z + 0.25));
    cutter.arc_by_centre(3, pocket.at(2, 0), pocket.centre, word('Z', z));
    const bool by_radius = random.chance(0.4);
    for (double inset = 0.7 * std::min(pocket.half_width, pocket.half_height); inset > 0 && p.room(); inset -= step)
      round_of(cutter, pocket, inset, by_radius, random.chance(0.3) ? code('F', 50 * random.from(8, 40)) : "");
    if (random.chance(0.3)) p.block(code('S', 50 * random.from(40, 200)));
  }
  if (random.chance(0.5)) {  // an island or boss beside it, by a full circle
    const Point start = cutter.at();
    cutter.arc_by_centre(2, start, {round4(start.x + random.between(3, 9)), round4(start.y - random.between(0, 4))});
  }
  cutter.height(0, random.of(std::array{5.0, 10.0, 25.0}));
}

void mixed(Program& p, Random& random) {
  p.start();
  for (int set = 1; set <= 6; ++set)
    p.block("G10", "L2", code('P', set), word('X', 120.0 * set - 7.25), word('Y', 40 - 12.5 * set),
            word('Z', -150 + 3.75 * set));
  for (int operation = 1; p.room(); ++operation) {
    const int tool = random.from(1, 20);
    mount_tool(p, random, tool, "OP" + std::to_string(operation) + " POCKETS");
    const Point at{round4(random.between(-50, 50)), round4(random.between(-50, 50))};
    approach(p, tool, at);
    Cutter cutter(p, at);
    const int pockets = random.from(2, 5);
    for (int i = 1; i <= pockets && p.room(); ++i) {
      cut_pocket(p, random, cutter);
      if (random.chance(0.3)) p.block("(POCKET " + std::to_string(i) + " OF " + std::to_string(pockets) + " DONE)");
    }
    p.block("M9");
    p.block("M5");
    if (random.chance(0.6)) {
      p.block("G91", "G28", "Z0.");
      p.block("G90");
    } else {
      p.block("G53", "G0", "Z0.");
    }
    if (random.chance(0.3)) p.block("/M1");
    if (random.chance(0.15))
      p.block("G10", "L2", code('P', random.from(1, 6)), word('Z', -150 + random.between(-2, 2)));
  }
  p.finish();
}

struct Cycle {
  std::string code;
  std::string words;  // P or Q
};

// Which cycles, and which letter repeats them.
struct Drilling {
  std::string_view cycles = "G81,G81,G82,G83,G83,G73,G85";
  char repeat = 'K';
};

Cycle any_cycle(Random& random, std::string_view cycles) {
  const int count = 1 + static_cast<int>(std::count(cycles.begin(), cycles.end(), ','));
  for (int skip = random.from(1, count) - 1; skip > 0; --skip) cycles.remove_prefix(cycles.find(',') + 1);
  const std::string code(cycles.substr(0, cycles.find(',')));
  if (code == "G82") return {code, bench::code('P', 50 * random.from(1, 12))};
  if (code == "G83") return {code, word('Q', random.of(std::array{1.5, 2.0, 3.0, 4.0}))};
  if (code == "G73") return {code, word('Q', random.of(std::array{1.0, 1.5, 2.5}))};
  return {code, ""};
}

// Holes one after another, a block each, with only the words that change.
class HolePattern {
 public:
  HolePattern(Program& p, Random& random, std::string_view cycles)
      : p_(p),
        cycle_(any_cycle(random, cycles)),
        level_(random.chance(0.5) ? "G98" : "G99"),
        depth_(-random.of(std::array{3.0, 6.0, 8.5, 12.0, 20.0})),
        r_(random.of(std::array{1.0, 2.0, 3.0, 5.0})),
        feed_(5 * random.from(12, 80)) {}

  void hole(Point at) {
    const std::string x = word('X', at.x);
    const std::string y = word('Y', at.y);
    if (old_x_.empty()) {
      p_.block(level_, cycle_.code, x, y, word('Z', depth_), word('R', r_), cycle_.words, code('F', feed_));
    } else if (x != old_x_ || y != old_y_) {
      p_.block(x == old_x_ ? "" : x, y == old_y_ ? "" : y);
    }
    old_x_ = x;
    old_y_ = y;
  }
  // A straight row in one incremental block, from `start` on.
  void row(Point start, Point step, int repeats, char repeat, double initial_level) {
    p_.block("G0", word('X', start.x), word('Y', start.y));
    p_.block("G91", level_, cycle_.code, word('X', step.x), word('Y', step.y), word('Z', depth_ - r_),
             word('R', r_ - initial_level), cycle_.words, code(repeat, repeats), code('F', feed_));
    end();
    p_.block("G90");
  }
  void end() { p_.block("G80"); }

 private:
  Program& p_;
  Cycle cycle_;
  std::string level_;
  double depth_;
  double r_;
  int feed_;
  std::string old_x_, old_y_;
};

void drill_pattern(Program& p, Random& random, const Drilling& how) {
  const double initial_level = random.of(std::array{10.0, 25.0, 50.0});
  const Point origin{random.between(-100, 100), random.between(-100, 100)};
  const double pitch_x = random.between(4, 15);
  const double pitch_y = random.between(4, 15);
  HolePattern holes(p, random, how.cycles);
  p.block("G0", word('Z', initial_level));
  switch (random.from(0, 3)) {
    case 0: {  // plate, to and fro, every other row staggered
      const int columns = random.from(4, 16);
      const int rows = random.from(2, 9);
      const double stagger = random.chance(0.5) ? pitch_x / 2 : 0;
      for (int row = 0; row < rows; ++row)
        for (int i = 0; i < columns; ++i) {
          const int column = row % 2 == 0 ? i : columns - 1 - i;
          holes.hole({origin.x + pitch_x * column + (row % 2) * stagger, origin.y + pitch_y * row});
        }
      break;
    }
    case 1: {  // bolt circles, one within the other
      const int count = random.of(std::array{6, 8, 12, 24});
      for (int ring = random.from(1, 3); ring > 0; --ring)
        for (int i = 0; i < count; ++i) {
          const double angle = 2 * pi * i / count;
          holes.hole({origin.x + 14.0 * ring * std::cos(angle), origin.y + 14.0 * ring * std::sin(angle)});
        }
      break;
    }
    case 2:  // holes of a fixture plate, from a list
      for (int i = random.from(8, 50); i > 0; --i) holes.hole({random.between(-150, 150), random.between(-150, 150)});
      break;
    default:
      holes.row(origin, {pitch_x, random.chance(0.5) ? 0 : pitch_y}, random.from(3, 12), how.repeat, initial_level);
      return;
  }
  holes.end();
}

void drilling(Program& p, Random& random, const Drilling& how) {
  p.start();
  while (p.room()) {
    const int tool = random.from(1, 20);
    mount_tool(p, random, tool, "HOLES");
    approach(p, tool, {0, 0});
    for (int pattern = random.from(2, 6); pattern > 0 && p.room(); --pattern) drill_pattern(p, random, how);
    p.block("G0", "Z50.");
    p.block("M9");
    p.block("M5");
    p.block("G91", "G28", "Z0.");
    p.block("G90");
  }
  p.finish();
}

template <class T>
bool read_number(std::string_view text, T& value) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

int usage() {
  std::fputs(
      "usage: workload surface|mixed|drilling|five-axis BLOCKS [--seed S] [--cycles G81,G82...] [--repeat K|L] [-o "
      "FILE]\n",
      stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) return usage();
  const std::string_view kind = argv[1];
  long blocks = 0;
  std::uint64_t seed = 1;
  Drilling how;
  const char* path = nullptr;
  if (!read_number(argv[2], blocks) || blocks < Program::closing) return usage();
  for (int i = 3; i < argc; i += 2) {
    const std::string_view option = argv[i];
    const std::string_view value = argv[i + 1];
    if (option == "--seed" && read_number(value, seed)) continue;
    if (option == "--repeat" && (value == "K" || value == "L")) {
      how.repeat = value.front();
    } else if (option == "--cycles") {
      how.cycles = value;
    } else if (option == "-o") {
      path = argv[i + 1];
    } else {
      return usage();
    }
  }
  std::FILE* out = path == nullptr ? stdout : std::fopen(path, "wb");
  if (out == nullptr) {
    std::perror(path);
    return 1;
  }
  Random random(seed);
  Program program(out, blocks);
  if (kind == "surface") {
    surface(program, random);
  } else if (kind == "mixed") {
    mixed(program, random);
  } else if (kind == "drilling") {
    drilling(program, random, how);
  } else if (kind == "five-axis") {
    five_axis(program, random);
  } else {
    return usage();
  }
  return std::fclose(out) == 0 ? 0 : 1;
}
