/// G51 and G50: positions are scaled about a centre, by one factor or by one factor for each axis. The words of the
/// block are rewritten in place, so that no later syntax has to know of G51. What the control does not scale (tool
/// offsets, the Q of a peck, the shift of a boring bar) is not changed. Fanuc manual, "Scaling".
#include <algorithm>
#include <cmath>
#include <string>

#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>

#include "reading/geometry_words.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

constexpr double most_counts = 999999;  // of a factor, as on the control

enum class WithPoint { alarm, factor, counts };

struct Scaling {
  static constexpr auto spec =
      ig::syntax("ScalingSyntax", "G51/G50 scaling.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax", "ToolHeightOffsetSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "PolarCoordinateSyntax")
          .before("ProgrammableMirrorSyntax", "CannedCycleResolveSyntax", "IncrementalResolveSyntax",
                  "ProgramXyzSyntax", "CircularMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0386", "G51 {0}{1} is not a valid scaling factor, so the scaling does not change"),
      ig::diagnostic(IG_WARNING, "ISO-0387", "G51 without P, I, J or K: a factor of 1 is assumed"),
      ig::diagnostic(IG_ERROR, "ISO-0620",
                     "G51 {0}{1} has a decimal point, so the scaling does not change: write a factor of {1} as {0}{2}"),
  };

  ig::Call g51_{{"G51"}, "X Y Z I[] J[] K[] P[]"};
  ig::Codes g50_{"G50"};
  ig::InWhile<ig::Symbol> term_{"Scaling.Term", "G51", ig::write};
  ig::Xyz center_{"Scaling.Center", ig::read | ig::write};
  ig::Xyz factor_{"Scaling.Factor", ig::read | ig::write};
  GeometryWords words_;
  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;
  ig::Config config_{"isogloss.motion/1", ig::Need::optional, "ScalingUnit, ScalingFactor"};
  ig::NumberOption factor_unit_{
      "factor-unit", "0", {0, 1}, "", "What P1 and I1 mean; 0: the value of isogloss.motion/1, or else 0.001."};
  ig::Choice<WithPoint> with_point_{"factor-with-point", "alarm|factor|counts", "alarm",
                                    "A factor with a decimal point, where it counts thousandths: an error, the factor "
                                    "itself, or counts all the same."};
  double least_ = factor_unit_ < 1 ? 1 : 0.001;  // in counts; whole factors have decimals
  double unit_ = factor_unit_ > 0 ? double{factor_unit_} : config_.number("ScalingUnit").value_or(0.001);
  std::optional<double> fixed_factor_ = config_.number("ScalingFactor");

  ig::Status build(ig::Block& b) {
    bool changed = false;
    if (b.take(g50_)) {
      end(b);
      changed = true;
    }
    const std::string pointed = b.has(g51_.code(0)) ? pointed_factors(b) : std::string();
    if (const auto words = b.take(g51_)) {
      begin(b, *words, pointed);
      changed = true;
    }
    if (b.has(term_)) changed |= scale(b);
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void end(ig::Block& b) const {
    b.erase(term_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b.erase(center_.id(axis));
      b.erase(factor_.id(axis));
    }
  }

  void begin(ig::Block& b, const ig::Words& words, std::string_view pointed) const {
    ig::Vec3 center = last_(b), factor{1, 1, 1};
    const bool has_own = words['I'] || words['J'] || words['K'];
    if (!has_own && !words['P']) {
      if (!fixed_factor_) b.report(ig::diag("ISO-0387"), ig::Where::word(g51_.code(0)));
      factor = fixed_factor_.value_or(1) * factor;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      center[axis] = words["XYZ"[axis]].value_or(center[axis]);
      const char letter = words["IJK"[axis]] ? "IJK"[axis] : 'P';
      const auto counts = has_own && letter == 'P' ? std::nullopt : words[letter];
      if (!counts) continue;
      const ig::Where where = ig::Where::word(g51_.word(0, letter));
      const bool is_pointed =
          unit_ < 1 && with_point_ != WithPoint::counts && pointed.find(letter) != std::string_view::npos;
      if (is_pointed && with_point_ == WithPoint::alarm) {
        b.report(ig::diag("ISO-0620"), where, std::string_view(&letter, 1), *counts, std::round(*counts / unit_));
        return;
      }
      const double least = is_pointed ? 0.001 : least_;
      if (!(std::fabs(*counts) >= least && std::fabs(*counts) <= most_counts) || (letter == 'P' && *counts < 0)) {
        b.report(ig::diag("ISO-0386"), where, std::string_view(&letter, 1), *counts);
        return;
      }
      factor[axis] = is_pointed ? *counts : *counts * unit_;
    }
    b.set(term_, words.code);
    b.set(center_, center);
    b.set(factor_, factor);
  }

  /// The letters of the factors that are written with a decimal point; to be asked before the words are taken.
  std::string pointed_factors(const ig::Block& b) const {
    std::string out;
    for (const char letter : {'P', 'I', 'J', 'K'})
      if (b.has(g51_.word(0, letter)) && has_point(b, g51_.word(0, letter))) out += letter;
    return out;
  }

  /// The value of a variable or expression has none, however it is written.
  static bool has_point(const ig::Block& b, ig_field field) {
    ig_word word{};
    b.word(field, word);  // its mark is needed; it may have no place
    if ((word.flags & IG_WORD_WITHOUT_POINT) != 0) return false;
    const std::string_view source = b.source();
    if (source.empty()) return true;  // a block without a text, such as that of a case
    if (word.begin >= word.end || word.end > source.size()) return false;
    const std::string_view text = source.substr(word.begin, std::size_t{word.end} - word.begin);
    return text.find('.') != std::string_view::npos && text.find_first_of("#[(=") == std::string_view::npos;
  }

  bool scale(ig::Block& b) const {
    words_.report_untouched(b, g51_.name(0));
    const auto here = words_.find(b);
    if (!here) return false;
    const ig::Vec3 factor = b.get(factor_).or_else({1, 1, 1}), center = b.get(center_).or_else({});
    const PlaneAxes plane = plane_(b);
    const bool incremental = distance_.is_incremental(b);
    bool any = false;
    const auto position = [&](ig_field word, std::size_t axis) {
      const auto value = GeometryWords::get(b, word);
      if (!value) return;
      // In a cycle the drilling axis is scaled but not mirrored.
      const double by = here->is_cycle && axis == plane.tool ? std::fabs(factor[axis]) : factor[axis];
      const double to = incremental ? by * *value : AxisMap{}.scaled(by, center[axis]).position(*value);
      GeometryWords::rewrite(b, word, rounded(to));
      any = true;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) position(here->axes[axis], axis);
    if (here->is_cycle) {
      position(here->r, plane.tool);
      return any;
    }
    const auto distance = [&](ig_field word, double by) {
      if (const auto value = GeometryWords::get(b, word)) {
        GeometryWords::rewrite(b, word, rounded(by * *value));
        any = true;
      }
    };
    for (std::size_t axis = 0; axis < 3; ++axis) distance(words_.centers()[axis], factor[axis]);
    distance(here->r, std::max(std::fabs(factor[plane.first]), std::fabs(factor[plane.second])));
    return any;
  }
};

const ig::Register<Scaling> scaling_syntax;

}  // namespace
}  // namespace iso
