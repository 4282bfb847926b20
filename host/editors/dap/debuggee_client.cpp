// What the thread of the client asks of a run.
#include <utility>

#include "dap/debuggee.hpp"

namespace isogloss::dap {

void Debuggee::set_breakpoints(std::shared_ptr<const BreakpointTable> table) {
  const std::lock_guard lock(mutex_);
  next_table_ = std::move(table);
  attention_.store(true);
}

bool Debuggee::step(Step step) {
  const std::lock_guard lock(mutex_);
  if (!is_standing_) return false;
  is_standing_ = false;
  command_ = step;
  changed_.notify_all();
  return true;
}

void Debuggee::pause() {
  const std::lock_guard lock(mutex_);
  if (!is_standing_) pauses_.store(true);
}

void Debuggee::quit() {
  {
    const std::lock_guard lock(mutex_);
    leaves_.store(true);
    is_standing_ = false;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

bool Debuggee::look(const std::function<void(const Standing&, const ProgramVariables&)>& look) {
  const std::lock_guard lock(mutex_);
  if (!is_standing_) return false;
  variables_.enter(standing_.entry.call);
  look(standing_, variables_);
  return true;
}

std::optional<std::string> Debuggee::assign(const std::string& name, const std::string& value) {
  std::unique_lock lock(mutex_);
  if (!is_standing_) return "the program runs: pause it to set a variable";
  is_standing_ = false;
  assignment_ = {name, value};
  assigned_.reset();
  changed_.notify_all();
  changed_.wait(lock, [this] { return (assigned_ && is_standing_) || has_ended_ || leaves_.load(); });
  if (!assigned_ || !is_standing_) return "the program ended before the variable was set";
  return *std::exchange(assigned_, std::nullopt);
}

/// On the thread of the run, which stands.
std::optional<std::string> Debuggee::assign_here(const std::string& name, const std::string& value) {
  const Position& here = standing_.position;
  const std::uint64_t block = here.is_within ? here.block + 1 : here.block;
  while (!edits_.empty() && edits_.back().block > block) edits_.pop_back();
  if (standing_.run != nullptr) {
    for (const Diagnostic& d : standing_.run->execute(assignment_text(*standing_.chain, name, value)))
      if (d.severity == Severity::error) return d.message;
    edits_.push_back({block, name, value});
    next_edit_ = edits_.size();
    return std::nullopt;
  }
  if (here.is_within) return "a variable is set between two blocks: step out of this one first";
  edits_.push_back({block, name, value});
  Stop arrival = standing_.stop;
  arrival.is_silent = true;
  seek(here, std::move(arrival));
  return std::nullopt;
}

}  // namespace isogloss::dap
