// How a drilling cycle is called: its levels, its feed and dwell, and the move of its own block to the hole.
#include "cycles/drilling_cycle.hpp"

namespace siemens {

using namespace ig::cnc;

DrillingCall::DrillingCall(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) cycles_.emplace_back(drilling_signature(name), ig::take | ig::wake);
}

std::optional<DrillingRun> DrillingCall::take(ig::Block& b) {
  DrillingRun run;
  for (const CycleFields& cycle : cycles_) {
    if (!cycle.take(b, run.values)) continue;
    run.cycle = &cycle;
    if (!resolve(b, run)) {
      pattern_.take(b, run.plane, last_(b));
      b.alarm();
      return std::nullopt;
    }
    run.pattern = pattern_.take(b, run.plane, last_(b));
    motion.begin(b, cycle.code().name(0));
    if (!run.pattern) approach(b, run);
    return run;
  }
  return std::nullopt;
}

void DrillingCall::stay(ig::Block& b, const DrillingRun& run) const {
  b.set(program_, run.hole);
  b.alarm();
}

ig::Where DrillingCall::where(const DrillingRun& run, std::string_view parameter) {
  const std::size_t i = parameter.empty() ? run.cycle->size() : run.cycle->index_of(parameter);
  return ig::Where::word(i < run.cycle->size() ? run.cycle->field(i).id() : run.cycle->code().code(0));
}

double DrillingCall::seconds(ig::Block& b, const DrillingRun& run, std::optional<double> number, DwellUnit unit) const {
  if (!number || *number == 0) return 0;
  if (unit == DwellUnit::seconds || (unit == DwellUnit::by_sign && *number > 0)) return std::fabs(*number);
  const double rpm = feed.rpm(b);
  if (rpm > 0) return std::fabs(*number) * 60 / rpm;
  b.report(ig::diag("SIE-0187"), where(run), run.cycle->name(), *number);
  return 0;
}

PlaneAxes DrillingCall::plane_of(const ig::Block& b, const DrillingRun& run) const {
  const double plane = run.mode("DMODE", 0);
  return plane == 1 ? xy_plane : plane == 2 ? zx_plane : plane == 3 ? yz_plane : plane_(b);
}

bool DrillingCall::resolve(ig::Block& b, DrillingRun& run) const {
  if (!levels(b, run)) return false;
  const std::string_view name = run.cycle->name();
  run.feed = feed.mmds(b);
  const bool has_own_feed = name == "CYCLE85" || name.starts_with("CYCLE84");
  if (run.feed <= 0 && !has_own_feed) b.report(ig::diag("SIE-0186"), where(run), name);
  if (const auto mode = run["GMODE"]; mode && *mode != 0 && name != "CYCLE86")
    b.report(ig::diag("SIE-0190"), where(run), name, *mode);
  if (const auto mode = run["VARI"]; name == "CYCLE82" && mode && *mode != 0)
    b.report(ig::diag("SIE-0191"), where(run), name, *mode);
  run.dwell = seconds(b, run, run["DTB"], run.dwell_unit(1));
  return true;
}

bool DrillingCall::levels(ig::Block& b, DrillingRun& run) const {
  const std::string_view name = run.cycle->name();
  for (const std::string_view needed : {"RTP", "RFP"})
    if (!run[needed]) {
      b.report(ig::diag("SIE-0185"), where(run), name, needed);
      return false;
    }
  run.plane = plane_of(b, run);
  run.hole = last_(b);
  run.retract = *run["RTP"];
  run.reference = *run["RFP"];
  const auto dp = run["DP"], dpr = run["DPR"];
  if (!dp && !dpr) {
    b.report(ig::diag("SIE-0185"), where(run), name, std::string_view("DP or DPR"));
    return false;
  }
  const double absolute = dp.value_or(0), relative = dpr.value_or(0), which = run.mode("AMODE", 0);
  const bool both = dp && dpr && relative != 0;
  const bool is_relative = both ? which != 2 : !dp;
  if (both && which != 1 && which != 2) b.report(ig::diag("SIE-0188"), where(run), name);
  const bool is_down = is_relative ? run.retract > run.reference : absolute <= run.reference;
  run.out = is_down ? 1 : -1;
  run.depth = is_relative ? run.reference - run.out * std::fabs(relative) : absolute;
  run.start = run.reference + run.out * std::fabs(run["SDIS"].value_or(0));
  if ((is_relative && run.retract == run.reference) || run.out * (run.retract - run.reference) < 0) {
    b.report(ig::diag("SIE-0189"), where(run), name, run.retract, run.reference);
    return false;
  }
  for (const double level : {run.depth, run.start})
    if (!(std::fabs(level) < 1e9)) {
      b.report(ig::diag("SIE-0105"), where(run), name);
      return false;
    }
  return true;
}

void DrillingCall::approach(ig::Block& b, DrillingRun& run) const {
  const ig::Vec3 from = last_(b);
  const ig::PartialVec3 named = b.take(words_);
  run.hole = named.or_else(from);
  const bool turns = b.has(angles_[0]) || b.has(angles_[1]) || b.has(angles_[2]);
  if (named.mask == 0 && !turns) return;
  const auto code = b.find(codes_);
  const ig::Symbol term = code ? codes_.name(*code) : b.get_or(state_, codes_.name(0));
  if (term == codes_.name(0)) {
    motion.rapid_to(b, run.hole);
    return;
  }
  if (term != codes_.name(1)) b.report(ig::diag("SIE-0192"), where(run), run.cycle->name());
  motion.feed_to(b, run.hole, feed.mmds(b));
}

}  // namespace siemens
