/// G33: a thread with a pitch of its own. G331 and G332: tapping in and out, coupled to the spindle. G63: one block by
/// feed, with a tap in a floating holder.
#include <cmath>

#include <isogloss/cnc/cycle_spindle.hpp>

#include <isogloss/cnc/program_xyz.hpp>

#include "cycles/cycle_feed.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensThread {
  static constexpr auto spec =
      ig::syntax("SiemensThreadSyntax", "G33 thread, G331/G332 rigid tapping, G63 tapping by feed.")
          .after("SiemensPositionSyntax", "G53p1RotaryPositionSyntax", "ToolCenterPointSyntax", "FeedrateSyntax",
                 "SpindleSpeedSyntax", "SiemensSpindlePositionSyntax")
          .before("SiemensCycleSyntax", "ProgramXyzSyntax", "McXyzSyntax", "CircularMotionSyntax",
                  "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0284", "{0} with a pitch of {1} cuts no thread: program the pitch with I, J or K"),
      ig::diagnostic(IG_ERROR, "SIE-0285",
                     "{0}: the spindle speed is not known, so the feed is not known either: program S before it"),
      ig::diagnostic(IG_ERROR, "SIE-0291",
                     "{0}: the change of the pitch (F) is not executed, so the pitch stays constant"),
  };

  ig::Call codes_{{"G331", "G332", "G63", "G33"}, "I J K"};
  ig::Call varying_{{"G34", "G35"}, "I J K F[]"};
  ig::Codes others_{{"G00", "G01", "G02", "G03", "CIP"}, ig::read};
  ig::Field<ig::Symbol> term_{"ThreadCutting.Term",
                              ig::read | ig::write | ig::wake_while,
                              {ig::Life::modal, "", "G33, G331 or G332, as long as no other motion code comes."}};
  ig::Field<double> pitch_{"ThreadCutting.Pitch",
                           ig::read | ig::write,
                           {ig::Life::modal, "mm", "Way of one turn, negative for a left-hand thread."}};
  ig::Xyz words_{"Parsing", ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::CompoundMotion motion_;
  CycleSpindle spindle_;
  CycleFeed feed_;
  LastProgramXyz last_;
  ig::Field<double> axis_{"ThreadCutting.Axis",
                          ig::read | ig::write,
                          {ig::Life::modal, "", "The axis along which the pitch counts: 0 X, 1 Y, 2 Z."}};
  ig::Signal speed_said_{"ThreadCutting.~SpeedSaid", ig::read | ig::write, ig::Life::modal};
  ig::Name g63_{"G63"}, g332_{"G332"}, g331_{"G331"};

  ig::Status build(ig::Block& b) {
    auto call = b.take(codes_);
    if (call && call->code == g63_) {
      by_feed(b, *call);
      return ig::Status::changed;
    }
    auto where = call ? ig::Where::word(codes_.code(call->row)) : ig::Where::block();
    if (!call && (call = b.take(varying_))) {
      where = ig::Where::word(varying_.code(call->row));
      b.report(ig::diag("SIE-0291"), where, b.text(call->code));
    }
    if (!call && b.find(others_)) {
      if (!b.has(term_)) return ig::Status::unchanged;
      b.erase(term_);
      b.erase(pitch_);
      b.erase(axis_);
      return ig::Status::changed;
    }
    if (call) begin(b, *call, where);
    if (b.has(term_)) cut(b);
    return ig::Status::changed;
  }

 private:
  std::optional<ig::Vec3> target(ig::Block& b) const {
    const ig::PartialVec3 named = b.take(words_);
    return named.mask == 0 ? std::nullopt : std::optional(named.or_else(last_(b)));
  }

  void by_feed(ig::Block& b, const ig::Words& call) const {
    const auto to = target(b);
    if (!to) return;
    const double mmds = feed_.mmds(b);
    if (mmds <= 0) b.report(ig::diag("SIE-0186"), ig::Where::word(codes_.code(call.row)), b.text(call.code));
    motion_.begin(b, call.code);
    motion_.feed_to(b, *to, mmds);
    b.set(program_, *to);
  }

  void begin(ig::Block& b, const ig::Words& call, const ig::Where& where) {
    double pitch = 0;
    const bool is_tapping = call.code == g331_ || call.code == g332_;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto word = call["IJK"[axis]]) {
        pitch = *word;
        if (!is_tapping) b.set(axis_, static_cast<double>(axis));
      }
    b.set(term_, call.code);
    if (pitch != 0 && std::fabs(pitch) < 1e6)
      b.set(pitch_, pitch);
    else if (call.mask != 0 || !b.has(pitch_))
      b.report(ig::diag("SIE-0284"), where, b.text(call.code), pitch);
  }

  void cut(ig::Block& b) const {
    const auto to = target(b);
    const double pitch = b.get_or(pitch_, 0.0), rpm = feed_.rpm(b);
    if (!to || pitch == 0) return;
    const ig::Symbol code = b.get_or(term_, ig::Symbol{});
    if (rpm <= 0 && !b.is_raised(speed_said_)) b.report(ig::diag("SIE-0285"), ig::Where::block(), b.text(code));
    if (rpm <= 0) b.raise(speed_said_);
    if (code != g331_ && code != g332_) {
      // On a taper the pitch is measured along its axis: the tool covers the longer way in the same turns.
      const ig::Vec3 way = *to - last_(b);
      const double along = std::fabs(way[static_cast<std::size_t>(b.get_or(axis_, 2.0))]);
      const double stretch = along > 0 ? std::hypot(way.x, way.y, way.z) / along : 1;
      motion_.begin(b, code);
      motion_.feed_to(b, *to, std::fabs(pitch) * rpm / 60 * stretch);
      b.set(program_, *to);
      return;
    }
    const bool turns_right = (pitch > 0) != (code == g332_);
    motion_.begin(b, code);
    spindle_.begin(b, motion_, ig::Spindle::stop);
    motion_.spindle(b, turns_right ? ig::Spindle::cw : ig::Spindle::ccw);
    motion_.feed_to(b, *to, std::fabs(pitch) * rpm / 60);
    motion_.spindle(b, ig::Spindle::stop);
    b.set(program_, *to);
  }
};

const ig::Register<SiemensThread> siemens_thread_syntax;

}  // namespace
}  // namespace siemens
