#include "run/scan_ahead.hpp"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

#include "run/calling.hpp"

namespace isogloss {

namespace {

/// Bytes of text between the run and the thread that goes on ahead of it. The run scans them by itself, and has the
/// first batch when it is through.
constexpr std::uint64_t lead = 4 * 1024;

ChainSettings settings_of(const RunOptions& options) {
  ChainSettings out = options.chain;
  out.mode = Mode::fast;
  out.host = &ahead_table();
  return out;
}

/// They are for the threads that know what is at work.
void block_signals() {
  sigset_t all;
  sigfillset(&all);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigdelset(&all, fault);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

ScanAhead::ScanAhead(const LinkedDialect& linked, const RunOptions& options, std::unique_ptr<Source> source,
                     std::string file)
    : linked_(linked),
      settings_(settings_of(options)),
      source_(std::move(source)),
      file_(std::move(file)),
      cursor_(*source_, options.maximum_line_bytes, linked.dialect.segmenter),
      shared_(std::make_unique<Batch[]>(batches)) {
  thread_ = std::thread([this] {
    work();
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    changed_.notify_one();
  });
}

ScanAhead::~ScanAhead() {
  {
    const std::lock_guard lock(mutex_);
    stops_ = true;
  }
  changed_.notify_one();
  std::unique_lock lock(mutex_);
  const bool has_ended = changed_.wait_for(lock, std::chrono::seconds(1), [this] { return has_ended_; });
  lock.unlock();
  // A scanner that does not return is at work in this thread, too: the watch over such calls looks at it.
  const std::uint16_t scanner = has_ended || chain_ == nullptr ? 0 : chain_->document().current;
  std::optional<Calling> at_work;
  if (scanner != 0) {
    const LinkedSyntax& s = linked_.chain[scanner - 1u];
    at_work.emplace(*s.plugin, s.element.alias.c_str(), "scan");
  }
  thread_.join();
}

// ---- the run

const ScannedLine* ScanAhead::find(const Line& line) {
  while (next_ != end_ || take_batch()) {
    const auto& found = *reinterpret_cast<const ScannedLine*>(next_);
    if (found.offset > line.offset) break;
    if (found.offset < line.offset) {
      next_ += found.bytes();
      continue;
    }
    take(found);
    return found.is_left || found.size != line.text.size() ? nullptr : &found;
  }
  run_at_.store(line.offset, std::memory_order_relaxed);
  const bool is_on_the_way = line.offset < from_ && line.offset + lead >= from_;
  if (!is_on_the_way && is_built_ && (++misses_ >= patience_ || hits_ >= enough_hits)) ask(line.offset);
  return nullptr;
}

/// The next one that answers the last question; false when none is ready.
bool ScanAhead::take_batch() {
  give_back();
  while (done_ != ready_.load(std::memory_order_acquire)) {
    const Batch& batch = shared_[done_ % batches];
    has_batch_ = true;
    if (batch.asked == questions_ && batch.size != 0) {
      next_ = batch.bytes;
      end_ = batch.bytes + batch.size;
      return true;
    }
    give_back();
  }
  return false;
}

/// The thread may write there again.
void ScanAhead::give_back() {
  next_ = end_ = nullptr;
  if (!std::exchange(has_batch_, false)) return;
  std::unique_lock lock(mutex_);
  ++done_;
  run_on_.store(sched_getcpu(), std::memory_order_relaxed);
  const bool is_half_empty = ready_ - done_ <= batches / 2;
  lock.unlock();
  if (is_half_empty) changed_.notify_one();
}

/// The run went on elsewhere, or faster than the thread. Where the last answer did not help, the next question comes
/// later.
void ScanAhead::ask(std::uint64_t place) {
  patience_ = hits_ < enough_hits ? std::min(2 * patience_, most_patience) : least_patience;
  from_ = place + lead;
  hits_ = misses_ = 0;
  give_back();
  run_on_.store(sched_getcpu(), std::memory_order_relaxed);
  {
    const std::lock_guard lock(mutex_);
    asked_ = ++questions_;
  }
  changed_.notify_one();
}

// ---- the thread

void ScanAhead::work() try {
  block_signals();
  apart_.emplace();
  chain_ = std::make_unique<Chain>(linked_, std::move(settings_), ignored_);
  chain_->flow = this;
  filling_ = &shared_[0];
  chain_->notes = &filling_->next();
  chain_->start(file_);
  is_built_ = true;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stops_ || asked_ != 0; });
    if (stops_) return;
  }
  apart_->from(run_on_.load(std::memory_order_relaxed));
  for (Line line; !is_useless();) {
    if (filling_->asked != asked_ && !answer()) return;
    const bool has_line = cursor_.next(line);
    if (cursor_.has_failed()) return;
    if (has_line) {
      scan(line);
      if (filling_->has_room()) continue;
      if (run_at_.load(std::memory_order_relaxed) > cursor_.offset() + lead) {  // it is far behind the run
        if (!answer()) return;
        continue;
      }
    }
    if (!hand_over()) return;
    std::unique_lock lock(mutex_);
    if (!has_line) changed_.wait(lock, [this] { return stops_ || filling_->asked != asked_; });
    if (stops_) return;
  }
} catch (...) {  // a syntax lives only once, or there is no memory: the run scans by itself
}

/// The run has come to a place for which nothing was ready. Either the thread is well ahead of it, and has not yet
/// handed over what it has, or it goes there. False when the run has ended.
bool ScanAhead::answer() {
  filling_->asked = asked_;
  const std::uint64_t place = run_at_.load(std::memory_order_relaxed);
  const auto* const first = reinterpret_cast<const ScannedLine*>(filling_->bytes);
  const bool has_next = filling_->size != 0 && first->offset <= place + lead && cursor_.offset() > place;
  if (has_next && !hand_over()) return false;
  if (has_next && cursor_.offset() >= place + lead / 2) return true;
  filling_->size = 0;
  cursor_.seek(place + lead, 1);
  Line rest;  // the place may lie within a line
  cursor_.next(rest);
  return true;
}

/// Goes on with the next batch as soon as there is room; false when the run has ended.
bool ScanAhead::hand_over() {
  const std::uint32_t asked = filling_->asked;
  ready_.store(ready_ + 1, std::memory_order_release);
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return stops_ || ready_ - done_ < batches; });
  if (stops_) return false;
  lock.unlock();
  apart_->from(run_on_.load(std::memory_order_relaxed));
  filling_ = &shared_[ready_ % batches];
  filling_->asked = asked;
  filling_->size = 0;
  return true;
}

void ScanAhead::begin(const Line& line, Document::Summary& out) {
  Document& d = chain_->document();
  if (is_plain_ && d.begin_scan_again(line.number, line.text, out)) return;
  chain_->begin_block({file_, line.number, 0, line.text, false});
  d.begin_scan(out);
}

void ScanAhead::scan(const Line& line) {
  LineNotes& notes = filling_->next();
  notes.line = {line.offset, static_cast<std::uint32_t>(line.text.size())};
  chain_->notes = &notes;
  if (line.lines > 1 || line.truncated) {
    notes.leave();
  } else {
    begin(line, notes.summary);
    Document& d = chain_->document();
    const bool is_whole = chain_->scan() == line.text.size() && !chain_->skip_rest && !chain_->ends_file;
    if (!is_whole || !ignored_.all.empty() || !d.leftovers.empty()) notes.leave();
    ignored_.all.clear();
    notes.complete(d);
  }
  is_plain_ = !notes.line.is_left && chain_->split_at == 0;
  if (notes.line.is_left) ++left_;
  ++scanned_;
  filling_->keep(notes);
}

}  // namespace isogloss
