/// HOLES1, HOLES2, CYCLE801 and CYCLE802 under MCALL of a subprogram: a rapid to each hole, where
/// SiemensModalCallSyntax calls the subprogram. The block is executed once for each hole.
#include "cycles/hole_pattern.hpp"
#include "flow/flow_words.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensPatternCall {
  static constexpr auto spec =
      ig::syntax("SiemensPatternCallSyntax", "A pattern of holes under MCALL of a subprogram.")
          .after("SiemensCycleSyntax")
          .before("SiemensModalCallSyntax", "ProgramXyzSyntax", "McXyzSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0289",
                     "{0} holes of the pattern before this block are missing: end the subprogram with M17 or RET"),
  };

  HolePattern pattern_{ig::take | ig::wake};
  ig::Codes mcall_{{"MCALL"}, ig::read};
  ig::Signal subprogram_{"ModalCall.~InForce", ig::read, ig::Life::modal};
  ig::Signal open_{"ModalCall.~Pattern", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::CompoundMotion motion_;
  ig::Name rapid_{"G00"};
  PlaneInForce plane_;
  LastProgramXyz last_;
  Environment environment_;

  ig::Status build(ig::Block& b) {
    const ig_place here = environment_.flow.here(b);
    std::vector<PatternCall>& open = environment_.store().patterns;
    if (b.is_raised(open_)) look_back(b, here, open);
    if (!pattern_.stands_in(b) || !b.is_raised(subprogram_) || b.find(mcall_)) return ig::Status::changed;
    const auto holes = pattern_.take(b, plane_(b), last_(b));
    if (open.empty() || !open.back().is_at(here.frame, here.offset) || !open.back().is_open()) {
      if (!holes || holes->empty()) return ig::Status::changed;  // reported
      PatternCall& begun = open.emplace_back();
      begun.frame = here.frame;
      begun.offset = here.offset;
      begun.label = pattern_label(here.line);
      for (const ig::Vec3& p : *holes) begun.holes.push_back({p.x, p.y, p.z});
    }
    PatternCall& pattern = open.back();
    const auto& hole = pattern.holes[pattern.next++];
    ig::Vec3 to{hole[0], hole[1], hole[2]};
    to[plane_(b).tool] = last_(b)[plane_(b).tool];
    motion_.begin(b, rapid_);
    motion_.rapid_to(b, to);
    b.set(program_, to);
    b.raise(open_);
    return ig::Status::changed;
  }

 private:
  /// Reports a pattern when the program goes on after it although not all of its holes were made.
  void look_back(ig::Block& b, const ig_place& here, std::vector<PatternCall>& open) const {
    while (!open.empty() && is_left(open.back(), here)) {
      const PatternCall& pattern = open.back();
      if (pattern.is_open())
        b.report(ig::diag("SIE-0289"), ig::Where::block(), static_cast<double>(pattern.holes.size() - pattern.next));
      open.pop_back();
    }
    if (open.empty()) b.erase(open_);
  }
  static bool is_left(const PatternCall& pattern, const ig_place& here) {
    return pattern.frame > here.frame || (pattern.frame == here.frame && pattern.offset != here.offset);
  }
};

const ig::Register<SiemensPatternCall> siemens_pattern_call_syntax;

}  // namespace
}  // namespace siemens
