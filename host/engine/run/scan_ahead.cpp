#include "run/scan_ahead.hpp"

#include <pthread.h>

#include <chrono>
#include <csignal>
#include <cstring>

#include "run/calling.hpp"

namespace isogloss {

namespace {

constexpr std::uint64_t head_start = 32 * 1024;  // bytes of text that the run has before it when the thread begins

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

void ScanAhead::Batch::copy_from(const Batch& other) {
  epoch = other.epoch;
  size = other.size;
  std::memcpy(bytes, other.bytes, size);
}

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
  if (epoch_ == 0) [[unlikely]] {
    if (is_built_) read_on_from(line.offset);
    return nullptr;
  }
  while (at_ < taken_.size || take_batch()) {
    const auto& found = *reinterpret_cast<const ScannedLine*>(taken_.bytes + at_);
    if (found.offset > line.offset) break;
    at_ += found.bytes();
    if (found.offset < line.offset) continue;
    ++hits_;
    misses_ = 0;
    return found.is_left || found.size != line.text.size() ? nullptr : &found;
  }
  const bool is_on_the_way = line.offset < from_ && line.offset + head_start >= from_;
  if (!is_on_the_way && ++misses_ == patience_) read_on_from(line.offset);
  return nullptr;
}

/// The next one that was read on from the last place asked for; false when none is ready.
bool ScanAhead::take_batch() {
  while (done_ != ready_.load(std::memory_order_acquire)) {
    const Batch& batch = shared_[done_ % batches];
    const bool is_wanted = batch.epoch == epoch_;
    if (is_wanted) taken_.copy_from(batch);
    std::unique_lock lock(mutex_);
    ++done_;
    const bool is_half_empty = ready_ - done_ <= batches / 2;
    lock.unlock();
    if (is_half_empty) changed_.notify_one();
    at_ = 0;
    if (is_wanted) return true;
  }
  return false;
}

/// The run went on elsewhere, or faster than the thread. Where that did not help, the next time comes later.
void ScanAhead::read_on_from(std::uint64_t offset) {
  patience_ = hits_ < 4 * std::uint64_t{patience_} ? std::min(2 * patience_, 1u << 24) : least_patience;
  from_ = offset + head_start;
  hits_ = misses_ = 0;
  at_ = taken_.size = 0;
  {
    const std::lock_guard lock(mutex_);
    asked_offset_ = from_;
    asked_ = ++epoch_;
  }
  changed_.notify_one();
}

// ---- the thread

void ScanAhead::work() try {
  block_signals();
  chain_ = std::make_unique<Chain>(linked_, std::move(settings_), ignored_);
  chain_->flow = this;
  chain_->notes = &filling_.next();
  chain_->start(file_);
  is_built_ = true;
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stops_ || asked_ != 0; });
    if (stops_) return;
  }
  for (Line line; !is_useless();) {
    if (filling_.epoch != asked_) seek();
    const bool has_line = cursor_.next(line);
    if (cursor_.has_failed()) return;
    if (has_line) {
      scan(line);
      if (filling_.has_room()) continue;
    }
    if (!hand_over()) return;
    std::unique_lock lock(mutex_);
    if (!has_line) changed_.wait(lock, [this] { return stops_ || filling_.epoch != asked_; });
    if (stops_) return;
  }
} catch (...) {  // a syntax lives only once, or there is no memory: the run scans by itself
}

void ScanAhead::seek() {
  const std::lock_guard lock(mutex_);
  filling_.epoch = asked_;
  filling_.size = 0;
  cursor_.seek(asked_offset_, 1);
  Line rest;  // the place may lie within a line
  cursor_.next(rest);
}

/// Waits for room; false when the run has ended.
bool ScanAhead::hand_over() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stops_ || filling_.epoch != asked_ || ready_ - done_ < batches; });
    if (stops_) return false;
    if (filling_.epoch != asked_) return true;
  }
  shared_[ready_ % batches].copy_from(filling_);
  ready_.store(ready_ + 1, std::memory_order_release);
  filling_.size = 0;
  return true;
}

void ScanAhead::scan(const Line& line) {
  LineNotes& notes = filling_.next();
  notes.line = {line.offset, static_cast<std::uint32_t>(line.text.size())};
  chain_->notes = &notes;
  if (line.lines > 1 || line.truncated) {
    notes.leave();
  } else {
    chain_->begin_block({file_, line.number, 0, line.text, false});
    Document& d = chain_->document();
    d.wake_none();
    const bool is_whole = chain_->scan() == line.text.size() && !chain_->skip_rest && !chain_->ends_file;
    if (!is_whole || !ignored_.all.empty() || !d.leftovers.empty()) notes.leave();
    ignored_.all.clear();
  }
  notes.sum_up(chain_->document());
  if (notes.line.is_left) ++left_;
  ++scanned_;
  filling_.keep(notes);
}

}  // namespace isogloss
