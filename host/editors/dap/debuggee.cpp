// The thread of the run: what it is asked for, and how it goes from one block to the next.
#include "dap/debuggee.hpp"

#include <exception>
#include <utility>

namespace isogloss::dap {

Debuggee::Debuggee(DebuggedProgram program, DebugEvents& events)
    : program_(std::move(program)),
      events_(events),
      statements_(*program_.linked, program_.options, program_.path, program_.text),
      strokes_(program_.linked->layout) {}

Debuggee::~Debuggee() { quit(); }

void Debuggee::start() {
  plan_.aim = program_.stops_on_entry ? Aim::into : Aim::walk;
  plan_.arrival.reason = "entry";
  thread_ = std::thread([this] { work(); });
}

void Debuggee::work() {
  while (true) {
    begin_run();
    RunOptions options = program_.options;
    options.listener = this;
    options.prepare = [this](Chain& chain) { prepare(chain); };
    const std::unique_ptr<Source> source = memory_source(program_.text);
    try {
      run(*program_.linked, *source, program_.path, options, {this}, *this);
    } catch (const std::exception& fault) {
      has_errors_ = true;
      events_.failed(fault.what());
    }
    if (!runs_again_ || leaves_.load()) break;
  }
  if (!leaves_.load()) events_.ended(has_errors_);
  const std::lock_guard lock(mutex_);
  has_ended_ = true;
  changed_.notify_all();
}

/// Nothing of the run before stays but its edits and the plan.
void Debuggee::begin_run() {
  runs_again_ = has_errors_ = false;
  next_edit_ = 0;
  finished_ = 0;
  entries_.clear();
  last_ = {};
  frames_.reset();
  frames_call_ = 0;
  hits_.clear();
  was_true_.clear();
  pending_.reset();
  candidate_.reset();
  variables_.clear();
  break_file_ = {};
  break_lines_ = nullptr;
  document_ = nullptr;
}

void Debuggee::prepare(Chain& chain) {
  chain.listen_to_rows();
  chain.variable_used = [this](const Document&, bool is_write, std::string_view name, std::uint64_t scope,
                               const ig_argument* value) {
    VariableUse use{std::string(name), scope, value_of_argument(value), is_write};
    // What an edit writes before a block is seen with the block before it.
    if (entries_.size() > 1)
      entries_[entries_.size() - (is_editing_ ? 2 : 1)].uses.push_back(std::move(use));
    else
      variables_.note(use, entries_.empty() ? 1 : entries_.back().call);
  };
}

void Debuggee::begin(Document& initial, const SymbolTable& symbols) {
  document_ = &initial;
  symbols_ = &symbols;
  chain_ = initial.chain;
}

/// The programs under way are asked for only where they change.
void Debuggee::note_entry(const NextBlock& next, StandingRun& run) {
  if (frames_ == nullptr || next.call != frames_call_ || next.pass != frames_pass_) {
    frames_ = std::make_shared<const Frames>(run.frames());
    frames_call_ = next.call;
    frames_pass_ = next.pass;
  }
  if (next.waiting == 0)
    entries_.resize(1);
  else
    entries_.emplace_back();
  BlockEntry& entry = entries_.back();
  entry.number = next.number;
  entry.file = next.file;
  entry.line = next.line;
  entry.column = next.column;
  entry.lines = next.lines;
  entry.depth = next.depth;
  entry.pass = next.pass;
  entry.call = next.call;
  if (entry.frames != frames_) entry.frames = frames_;
  entry.uses.clear();
}

bool Debuggee::before(const NextBlock& next, StandingRun& run) {
  note_entry(next, run);
  if (attention_.load(std::memory_order_relaxed)) look_up();
  if (leaves_.load(std::memory_order_relaxed)) return false;
  if (next_edit_ < edits_.size() && edits_[next_edit_].block <= next.number) apply_edits(next.number, run);
  if (next.waiting != 0) return true;
  document_ = &run.chain().document();
  return consider(entries_.front(), &run);
}

/// What the client has changed in the meantime.
void Debuggee::look_up() {
  const std::lock_guard lock(mutex_);
  attention_.store(false);
  adopt_table();
}

void Debuggee::apply_edits(std::uint64_t number, StandingRun& run) {
  is_editing_ = true;
  for (; next_edit_ < edits_.size() && edits_[next_edit_].block <= number; ++next_edit_) {
    const Edit& edit = edits_[next_edit_];
    for (Diagnostic& d : run.execute(assignment_text(run.chain(), edit.name, edit.value)))
      if (d.severity == Severity::error) events_.told(d);
  }
  is_editing_ = false;
}

bool Debuggee::block(Document& document, const SymbolTable&) {
  ++finished_;
  document_ = &document;
  last_ = std::move(entries_.front());
  entries_.pop_front();
  for (const VariableUse& use : last_.uses) variables_.note(use, last_.call);
  last_.uses.clear();
  const bool is_plain = plan_.aim == Aim::walk && table_->logic.empty() && !pending_;
  if (is_plain && entries_.empty()) return true;
  if (!finish(last_)) return false;
  return entries_.empty() || consider(entries_.front(), nullptr);
}

/// The block has run: conditions and diagnostics may stop the run within it, and a step may lead into its strokes.
bool Debuggee::finish(const BlockEntry& entry) {
  variables_.enter(entry.call);
  std::uint32_t done = 0;
  Stop stop = hit_by_logic(entry, done);
  const bool is_fault = pending_.has_value();
  if (is_fault) {
    stop = {"exception", std::string(to_string(pending_->severity)) + " " + pending_->code, pending_->message, {}};
    done = static_cast<std::uint32_t>(strokes_.count(*document_));
    pending_.reset();
  }
  if (is_quiet()) {
    const Position here{entry.number, true, done};
    if (!stop.reason.empty() && plan_.aim == Aim::reverse && here < plan_.target) candidate_ = {here, stop};
    if (plan_.aim != Aim::seek || !plan_.target.is_within || plan_.target.block != entry.number) return true;
    return stand({entry.number, true, plan_.target.done}, entry, nullptr, plan_.arrival);
  }
  if (!stop.reason.empty()) return stand({entry.number, true, done}, entry, nullptr, std::move(stop));
  const bool enters = plan_.aim == Aim::into && plan_.from == Position{entry.number, false, 0};
  if (!enters || strokes_.count(*document_) < 2) return true;
  return stand({entry.number, true, 0}, entry, nullptr, {"step", "", "", {}});
}

bool Debuggee::end() {
  const bool is_over = leaves_.load() || runs_again_;
  const bool stops = pending_ || program_.stops_at_end;
  if (is_over || finished_ == 0) return true;
  if (plan_.aim == Aim::back || plan_.aim == Aim::reverse) {
    const Candidate found = candidate_.value_or(Candidate{{1, false, 0}, {"entry", "", "", {}}});
    seek(found.position, found.stop);
    return true;
  }
  if (is_quiet() || !stops) return true;
  Stop stop{"pause", "the program has ended", "", {}};
  if (pending_)
    stop = {"exception", std::string(to_string(pending_->severity)) + " " + pending_->code, pending_->message, {}};
  pending_.reset();
  const auto done = static_cast<std::uint32_t>(strokes_.count(*document_));
  stand({finished_, true, done}, last_, nullptr, std::move(stop));
  return true;
}

void Debuggee::add(Diagnostic diagnostic) {
  has_errors_ = has_errors_ || diagnostic.severity == Severity::error;
  const bool stops = diagnostic.severity == Severity::error     ? table_->stops_at_errors
                     : diagnostic.severity == Severity::warning ? table_->stops_at_warnings
                                                                : false;
  if (stops && !pending_) pending_ = diagnostic;
  if (!is_quiet()) events_.told(diagnostic);
}

}  // namespace isogloss::dap
