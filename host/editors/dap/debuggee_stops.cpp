// Whether a run stands at a block, and where it goes from there. On the thread of the run.
#include <algorithm>
#include <utility>

#include "dap/debuggee.hpp"

namespace isogloss::dap {

bool Debuggee::has_breakpoint(const BlockEntry& entry) {
  if (table_->lines.empty()) return false;
  if (entry.file.data() != break_file_.data()) {
    break_file_ = entry.file;
    const auto found = table_->lines.find(canonical_path(std::string(entry.file)));
    break_lines_ = found == table_->lines.end() ? nullptr : &found->second;
    break_bits_.assign(break_lines_ == nullptr || break_lines_->empty() ? 0 : break_lines_->rbegin()->first + 1u,
                       false);
    if (break_lines_ != nullptr)
      for (const auto& [line, breakpoints] : *break_lines_) break_bits_[line] = true;
  }
  return entry.line < break_bits_.size() && break_bits_[entry.line];
}

bool Debuggee::is_curious(const BlockEntry& entry) const {
  if (plan_.aim == Aim::seek) return entry.number >= plan_.target.block;
  return plan_.aim != Aim::walk || pending_ || pauses_.load(std::memory_order_relaxed);
}

/// Stands before the block, or goes on with it; false ends the run.
bool Debuggee::consider(const BlockEntry& entry, StandingRun* run) {
  const bool has_break = has_breakpoint(entry);
  if (!has_break && !is_curious(entry)) return true;
  variables_.enter(entry.call);
  Stop stop = has_break ? hit_at(entry) : Stop{};
  if (is_quiet()) return arrive_quietly(entry, run, stop);
  const Position here{entry.number, false, 0};
  if (pending_) {
    stop = {"exception", std::string(to_string(pending_->severity)) + " " + pending_->code, pending_->message, {}};
    pending_.reset();
  } else if (stop.reason.empty() && pauses_.load()) {
    stop.reason = "pause";
  } else if (stop.reason.empty() && is_step_done(entry)) {
    stop = plan_.arrival;
    if (stop.reason.empty()) stop.reason = "step";
  }
  return stop.reason.empty() || stand(here, entry, run, std::move(stop));
}

/// A run that is repeated up to a position, or that looks for an earlier one on the way there.
bool Debuggee::arrive_quietly(const BlockEntry& entry, StandingRun* run, const Stop& hit) {
  const Position here{entry.number, false, 0};
  pending_.reset();
  if (here < plan_.target) {
    const bool is_step_back =
        plan_.aim == Aim::back && entry.depth <= plan_.depth && statements_.is_statement(entry.file, entry.line);
    const bool is_first = !candidate_ && plan_.aim != Aim::seek && statements_.is_statement(entry.file, entry.line);
    if (is_step_back || is_first) candidate_ = {here, {plan_.aim == Aim::back ? "step" : "entry", "", "", {}}};
    if (plan_.aim == Aim::reverse && !hit.reason.empty()) candidate_ = {here, hit};
    return true;
  }
  if (plan_.aim == Aim::seek) return stand(here, entry, run, plan_.arrival);
  const Candidate found = candidate_.value_or(Candidate{plan_.target, {"step", "", "", {}}});
  return seek(found.position, found.stop);
}

bool Debuggee::is_step_done(const BlockEntry& entry) {
  const bool is_near = plan_.aim == Aim::into || (plan_.aim == Aim::over && entry.depth <= plan_.depth) ||
                       (plan_.aim == Aim::out && entry.depth < plan_.depth);
  return is_near && statements_.is_statement(entry.file, entry.line);
}

Scene Debuggee::scene_of(const BlockEntry& entry, const Stroke* stroke) const {
  Scene out{document_, symbols_, stroke, entry.file, {}, entry.line, entry.depth, entry.pass, entry.number};
  if (entry.frames != nullptr && !entry.frames->empty()) out.program = entry.frames->back().program;
  return out;
}

/// A line may hold several blocks: its breakpoints are asked at the first of them.
Stop Debuggee::hit_at(const BlockEntry& entry) {
  Stop out;
  const bool is_same_line = last_.file.data() == entry.file.data() && last_.line == entry.line &&
                            last_.call == entry.call && last_.column < entry.column;
  if (is_same_line || break_lines_ == nullptr) return out;
  const Scene scene = scene_of(entry, nullptr);
  for (const Breakpoint& b : break_lines_->at(entry.line)) {
    if (b.condition && !b.condition->evaluate(scene, variables_).is_true()) continue;
    if (const std::uint64_t hits = ++hits_[b.id]; b.hits && !b.hits->holds(hits)) continue;
    if (b.log) {
      if (!is_quiet()) events_.logged(b.log->fill(scene, variables_), entry);
      continue;
    }
    out.reason = "breakpoint";
    out.breakpoints.push_back(b.id);
  }
  return out;
}

/// The conditions that became true with the block; `done` is the number of strokes up to the first one.
Stop Debuggee::hit_by_logic(const BlockEntry& entry, std::uint32_t& done) {
  Stop out;
  if (table_->logic.empty()) return out;
  strokes_.read(*document_, *symbols_, block_strokes_);
  const auto count = static_cast<std::uint32_t>(block_strokes_.size());
  for (const LogicBreakpoint& b : table_->logic) {
    bool& was_true = was_true_[b.id];
    for (std::uint32_t i = 0; i < std::max(count, 1u); ++i) {
      const Scene scene = scene_of(entry, i < count ? &block_strokes_[i] : nullptr);
      const bool is_true = b.expression.evaluate(scene, variables_).is_true();
      const bool begins = is_true && !was_true;
      was_true = is_true;
      if (!begins || (b.condition && !b.condition->evaluate(scene, variables_).is_true())) continue;
      if (const std::uint64_t hits = ++hits_[b.id]; b.hits && !b.hits->holds(hits)) continue;
      if (out.reason.empty() || i + 1 < done) done = std::min(i + 1, count);
      out.reason = "function breakpoint";
      out.description = b.expression.text() + " became true";
      out.breakpoints.push_back(b.id);
    }
  }
  return out;
}

/// The client's last table. A condition that holds already has not become true.
void Debuggee::adopt_table() {
  if (next_table_ == nullptr) return;
  table_ = std::exchange(next_table_, nullptr);
  break_file_ = {};
  break_lines_ = nullptr;
  if (document_ == nullptr) return;
  for (const LogicBreakpoint& b : table_->logic)
    if (!was_true_.contains(b.id) && finished_ > 0)
      was_true_[b.id] = b.expression.evaluate(scene_of(last_, nullptr), variables_).is_true();
}

void Debuggee::place(const Position& position, const BlockEntry& entry, StandingRun* run, Stop stop) {
  standing_.position = position;
  standing_.entry = entry;
  standing_.document = document_;
  standing_.symbols = symbols_;
  standing_.chain = chain_;
  standing_.run = run;
  strokes_.read(*document_, *symbols_, standing_.strokes);
  standing_.stop = std::move(stop);
  if (position.is_within && (!has_start_ || start_block_ != position.block)) standing_.start.reset();
  if (position.is_within) return;
  // The block that comes next begins where the tool stands now.
  const Layout& layout = document_->layout();
  Stroke here;
  for (unsigned i = 0; i < 6; ++i) {
    const std::string axis(1, "XYZABC"[i]);
    for (const bool is_machine : {false, true}) {
      const ig_field f = layout.id((is_machine ? "MachineCoordinate." : "ProgramXyz.") + axis);
      if (!document_->present(f)) continue;
      AxisValues& at = is_machine ? here.machine : here.program;
      at.at[i] = document_->number(f);
      at.known |= 1u << i;
    }
  }
  standing_.start = here;
  has_start_ = true;
  start_block_ = position.block;
}

bool Debuggee::stand(const Position& position, const BlockEntry& entry, StandingRun* run, Stop stop) {
  std::unique_lock lock(mutex_);
  place(position, entry, run, std::move(stop));
  pauses_.store(false);
  plan_ = {};
  while (true) {
    is_standing_ = true;
    const bool is_told = !standing_.stop.is_silent;
    changed_.notify_all();
    lock.unlock();
    if (is_told) events_.stopped(standing_.stop);
    lock.lock();
    changed_.wait(lock, [this] { return command_ || assignment_ || leaves_.load(); });
    is_standing_ = false;
    if (leaves_.load()) return false;
    if (assignment_) {
      const auto [name, value] = *std::exchange(assignment_, std::nullopt);
      assigned_ = assign_here(name, value);
      standing_.stop.is_silent = true;
      if (runs_again_) return false;
      continue;
    }
    const Step step = *std::exchange(command_, std::nullopt);
    adopt_table();
    if (standing_.position.is_within && step_within(step)) continue;
    lock.unlock();
    return obey(step);
  }
}

/// A step from stroke to stroke; false: it leaves the block.
bool Debuggee::step_within(Step step) {
  std::uint32_t& done = standing_.position.done;
  const auto count = static_cast<std::uint32_t>(standing_.strokes.size());
  if ((step == Step::into || step == Step::over) && done + 1 < count)
    ++done;
  else if (step == Step::back && done > 0)
    --done;
  else
    return false;
  standing_.stop = {"step", "", "", {}};
  return true;
}

bool Debuggee::obey(Step step) {
  const Position here = standing_.position;
  plan_ = {};
  plan_.from = here;
  plan_.depth = standing_.entry.depth;
  switch (step) {
    case Step::go_on: plan_.aim = Aim::walk; return true;
    case Step::into: plan_.aim = Aim::into; return true;
    case Step::over: plan_.aim = Aim::over; return true;
    // Out of the strokes of a cycle: to the next block.
    case Step::out: plan_.aim = here.is_within && standing_.strokes.size() > 1 ? Aim::into : Aim::out; return true;
    case Step::back:
      if (here.is_within) return seek({here.block, false, 0}, {"step", "", "", {}});
      return look_back(Aim::back);
    case Step::reverse: return look_back(Aim::reverse);
  }
  return true;
}

/// The run is repeated up to there; always false, which ends this one.
bool Debuggee::seek(const Position& target, Stop arrival) {
  plan_ = {};
  plan_.aim = Aim::seek;
  plan_.target = target;
  plan_.arrival = std::move(arrival);
  runs_again_ = true;
  return false;
}

/// The run is repeated up to the present position, and remembers the last earlier one that is wanted.
bool Debuggee::look_back(Aim aim) {
  plan_.aim = aim;
  plan_.target = standing_.position;
  runs_again_ = true;
  return false;
}

}  // namespace isogloss::dap
