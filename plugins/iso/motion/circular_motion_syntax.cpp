/// G02 and G03: an arc in the plane to the program point of the block, about a centre (I J K, from the start) or with a
/// radius (R). A move along the third axis makes it a helix. Fanuc manual, "Circular interpolation".
#include <numbers>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/units.hpp>

#include "motion/turning_feed.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class MissingCenter { linear, warning, error };
enum class InverseTime { length, radius };
enum class HelixFeed { path, arc, parameter };

struct CircularMotion {
  static constexpr auto spec =
      ig::syntax("CircularMotionSyntax", "G02/G03 arcs and helices.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "FeedrateSyntax", "CannedCycleResolveSyntax", "McXyzSyntax")
          .before("LinearMotionSyntax")
          .first_writer("Motion");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0320", "the arc has no centre: program I, J, K or R in its block"),
      ig::diagnostic(
          IG_ERROR, "ISO-0321",
          "the arc starts {0} mm from its centre but ends {1} mm from it: at most {2} mm difference is allowed"),
      ig::diagnostic(IG_ERROR, "ISO-0322",
                     "the radius of {0} mm is too small for this arc: a half circle of radius {1} mm is made"),
      ig::diagnostic(IG_WARNING, "ISO-0323",
                     "an arc with R ends where it starts, so no arc is made: program its centre instead"),
      ig::diagnostic(IG_ERROR, "ISO-0324", "the centre of the arc is its start: the tool goes straight to the end"),
      ig::diagnostic(IG_WARNING, "ISO-0325",
                     "the arc has both R and a centre (I, J, K): R is used, so remove the others"),
      ig::diagnostic(IG_ERROR, "ISO-0446",
                     "the rotary axes turn during this arc: the tool goes straight to the end instead"),
      ig::diagnostic(IG_WARNING, "ISO-0513", "the arc has neither R nor a centre: the tool goes straight to the end"),
      ig::diagnostic(IG_WARNING, "ISO-0605",
                     "the arc ends {0} mm from its start: a control with increments of {1} mm may make a full circle "
                     "of it"),
      ig::diagnostic(IG_NOTE, "ISO-0546",
                     "words of this arc have no decimal point and are read as least increments; if they are "
                     "millimetres or inches, {0}"),
  };

  ig::Codes arcs_{{"G02", "G03"}, ig::wake};
  ig::InWhile<ig::Symbol> clockwise_{"MotionState.Term", "G02"};
  ig::InWhile<ig::Symbol> counterclockwise_{"MotionState.Term", "G03"};
  ig::Word r_{"Parsing.R", ig::take};
  ig::Word i_{"Parsing.I", ig::take}, j_{"Parsing.J", ig::take}, k_{"Parsing.K", ig::take};
  ig::Xyz program_{"ProgramXyz", ig::read};
  ig::Signal turns_{"McAbc.~Turns", ig::read};
  MotionGroup group_;
  BlockMotion motion_;
  TurningFeed turning_;
  PlaneInForce plane_;
  LastProgramXyz last_;
  ScaleAndMirror scale_and_mirror_;
  ig::Config config_{"isogloss.motion/1", ig::Need::optional, "ArcRadiusTolerance_mm, HelixFeedAlongPath"};

  ig::Choice<MissingCenter> missing_center_{
      "missing-center", "linear|warning|error", "linear",
      "What an arc without I, J, K and R becomes: a straight line, a straight line with a warning, or an alarm."};
  ig::Choice<InverseTime> inverse_time_{"inverse-time", "length|radius", "length",
                                        "What F of G93 is multiplied by to give the feed: the path or the radius."};
  ig::Choice<HelixFeed> helix_feed_{"helix-feed", "path|arc|parameter", "path",
                                    "Along what F is the speed of a helix: its path, or its arc in the plane."};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  ig::Name g93_{"G93"};
  ig::Config number_format_{"isogloss.number-format/1", ig::Need::optional, "CalculatorDecimalPoint"};
  ig::TextOption whole_numbers_{"whole-numbers", "",
                                "How to set the control to read numbers without a point as units; reported with an "
                                "impossible arc of such numbers. Empty: no report."};
  ig::Signal without_point_{"Parsing.~WithoutPoint", ig::read};
  ig::NumberOption radius_tolerance_{"radius-tolerance",
                                     "0",
                                     {0, 1000},
                                     "mm",
                                     "How far the end may lie from the circle; 0: the value of isogloss.motion/1."};
  double tolerance_ = radius_tolerance_ > 0 ? double{radius_tolerance_}
                                            : config_.number("ArcRadiusTolerance_mm").value_or(0);
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
  double increment_mm_ = number_format_.number("LengthIncrement_mm").value_or(0);
  double inch_increment_mm_ = mm_per_inch * number_format_.number("LengthIncrement_inch").value_or(0);
  double half_increment_mm_ = std::fmax(increment_mm_, inch_increment_mm_) / 2;
  bool feeds_along_arc_ = helix_feed_ == HelixFeed::parameter ? config_.number("HelixFeedAlongPath").value_or(1) == 0
                                                              : helix_feed_ == HelixFeed::arc;

  ig::Status build(ig::Block& b) {
    std::uint32_t found = 0;
    const auto named = group_.find(b, found);
    const std::size_t code = named ? *named : group_.in_force(b);
    if (code != MotionGroup::g02 && code != MotionGroup::g03) return ig::Status::unchanged;
    if (named) group_.take(b, code, found);
    const ig::Status so_far = named ? ig::Status::changed : ig::Status::unchanged;
    if (motion_.is_moving(b)) return so_far;

    const PlaneAxes plane = plane_(b);
    const ArcWords words = take_words(b, plane);
    if (!b.is_fresh(program_) && !words.r && !words.has_center() && !b.is_raised(turns_)) return so_far;
    if (!named) group_.put_in_force(b, code);
    move(b, plane, words, (code == MotionGroup::g03) != scale_and_mirror_.swaps_sense(b, plane));
    return ig::Status::changed;
  }

 private:
  static constexpr double half_turn = std::numbers::pi;

  struct ArcWords {
    std::optional<double> r, first, second;
    bool has_center() const { return first || second; }
  };
  /// The start and the end of the arc, in space and in the plane.
  struct Path {
    PlaneAxes plane;
    ig::Vec3 from, to;
    Point2 start() const { return {from[plane.first], from[plane.second]}; }
    Point2 end() const { return {to[plane.first], to[plane.second]}; }
    double rise() const { return to[plane.tool] - from[plane.tool]; }
    double length() const { return iso::length(to - from); }
  };

  /// Takes R and the centre words of the plane. The third centre word has no meaning and remains, so that it is
  /// reported.
  ArcWords take_words(ig::Block& b, const PlaneAxes& plane) const {
    const std::array<const ig::Word*, 3> centers{&i_, &j_, &k_};
    ArcWords words{b.take(r_), b.take(*centers[plane.first]), b.take(*centers[plane.second])};
    if (words.r && words.has_center()) b.report(ig::diag("ISO-0325"), ig::Where::word(r_.id()));
    return words;
  }

  void move(ig::Block& b, const PlaneAxes& plane, const ArcWords& words, bool is_ccw) const {
    const ig::Vec3 from = last_(b);
    const Path path{plane, from, b.get(program_).or_else(from)};
    if (motion_.turns(b) && (words.r || words.has_center()))
      while_turning(b, path);
    else if (words.r)
      by_radius(b, path, *words.r, is_ccw);
    else if (words.has_center())
      by_center(b, path, {words.first.value_or(0.0), words.second.value_or(0.0)}, is_ccw);
    else
      without_center(b, path);
  }

  void by_radius(ig::Block& b, const Path& path, double radius, bool is_ccw) const {
    if ((path.end() - path.start()).length() < same_point_mm) {
      b.report(ig::diag("ISO-0323"), ig::Where::word(r_.id()));
      straight(b, path);
      return;
    }
    // Programs round R and the end point: 0.001 mm is accepted even where no tolerance is set.
    if (radius_shortfall(path.start(), path.end(), radius) > std::fmax(tolerance_, 0.001)) {
      b.report(ig::diag("ISO-0322"), ig::Where::word(r_.id()), std::fabs(radius),
               (path.end() - path.start()).length() / 2);
      suspect_whole_numbers(b);
      b.alarm();
    }
    emit(b, path, center_by_radius(path.start(), path.end(), radius, is_ccw), is_ccw);
  }

  void by_center(ig::Block& b, const Path& path, const Point2& from_start, bool is_ccw) const {
    const Point2 start = path.start(), end = path.end();
    const Point2 center{start.u + from_start.u, start.v + from_start.v};
    const double at_start = (start - center).length(), at_end = (end - center).length();
    if (at_start < same_point_mm) {
      b.report(ig::diag("ISO-0324"), ig::Where::block());
      straight(b, path);
      return;
    }
    if (tolerance_ > 0 && std::fabs(at_end - at_start) > tolerance_) {
      b.report(ig::diag("ISO-0321"), ig::Where::block(), at_start, at_end, tolerance_);
      suspect_whole_numbers(b);
      b.alarm();
    }
    const Point2 gap = end - start;
    if (std::fabs(gap.u) < half_increment_mm_ && std::fabs(gap.v) < half_increment_mm_)
      suspect_full_circle(b, gap.length(), sweep(start, end, center, is_ccw));
    emit(b, path, center, is_ccw);
  }

  /// On the control, positions are whole increments: this arc has no length there, or goes all the way round.
  void suspect_full_circle(ig::Block& b, double apart, double turn) const {
    const double increment = b.is(system_, inch_) ? inch_increment_mm_ : increment_mm_;
    if (apart >= same_point_mm && apart < increment / 2 && std::fabs(turn) < half_turn)
      b.report(ig::diag("ISO-0605"), ig::Where::block(), apart, increment);
  }

  void suspect_whole_numbers(ig::Block& b) const {
    if (whole_numbers_.text().empty() || !b.is_raised(without_point_)) return;
    if (number_format_.number("CalculatorDecimalPoint").value_or(0) != 0) return;
    b.report(ig::diag("ISO-0546"), ig::Where::block(), whole_numbers_.text());
  }

  void without_center(ig::Block& b, const Path& path) const {
    if (missing_center_ == MissingCenter::error) {
      b.report(ig::diag("ISO-0320"), ig::Where::block());
      b.alarm();
    } else if (missing_center_ == MissingCenter::warning && path.length() >= same_point_mm) {
      b.report(ig::diag("ISO-0513"), ig::Where::block());
    }
    feed(b, path);
  }

  /// In place of the arc, where the third axis or a rotary axis moves.
  void straight(ig::Block& b, const Path& path) const {
    if (path.length() >= same_point_mm || b.is_raised(turns_)) feed(b, path);
  }

  void while_turning(ig::Block& b, const Path& path) const {
    b.report(ig::diag("ISO-0446"), ig::Where::block());
    b.alarm();
    feed(b, path);
  }

  void feed(ig::Block& b, const Path& path) const {
    if (turning_.turns(b))
      turning_.feed(b, motion_, path.length(), FeedCounts::linear_axes);
    else
      motion_.feed(b, [&] { return path.length(); });
  }

  void emit(ig::Block& b, const Path& path, const Point2& center, bool is_ccw) const {
    ig::Vec3 point = path.from;  // at the level of the start
    point[path.plane.first] = rounded(center.u);
    point[path.plane.second] = rounded(center.v);
    const auto length = [&](double rise) { return arc_length(path.start(), path.end(), center, is_ccw, rise); };
    const bool by_radius = inverse_time_ == InverseTime::radius;
    motion_.arc(b, point, is_ccw, [&] { return by_radius ? (path.start() - center).length() : length(path.rise()); });
    if (path.rise() != 0) [[unlikely]]
      feed_helix(b, path, length(0));
  }

  /// F may be the speed along the arc alone, and the path is longer.
  [[gnu::noinline]] void feed_helix(ig::Block& b, const Path& path, double arc) const {
    if (!feeds_along_arc_ || (b.is(feed_mode_, g93_) && inverse_time_ == InverseTime::length)) return;
    if (const auto feed = b.get(feedrate_)) b.set(feedrate_, *feed * std::hypot(1, path.rise() / arc));
  }
};

const ig::Register<CircularMotion> circular_motion_syntax;

}  // namespace
}  // namespace iso
