/// Between a MotionReader and the lines that it fills: bulk output is written on a thread of its own, while the next
/// blocks are executed. Lines come out in the same order and are the same bytes as without it.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <iterator>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "export/motion_reader.hpp"

namespace isogloss {

/// Takes the events of a reader and hands them to `Lines` in batches. A program that does not fill a batch, and a
/// machine with one processor, see no thread. Nothing that is kept points into the document.
template <class Lines>
class MotionQueue {
 public:
  explicit MotionQueue(Lines lines) : lines_(std::move(lines)) { fill(batches_[0]); }
  ~MotionQueue() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
    }
    changed_.notify_all();
    if (worker_.joinable()) worker_.join();
  }
  MotionQueue(const MotionQueue&) = delete;
  MotionQueue& operator=(const MotionQueue&) = delete;

  /// The lines themselves, where nothing waits to be written: before the first block, and after drain().
  Lines& lines() { return lines_; }

  void block(const BlockSource& source) {
    line_ = source.line;
    if (source.file.data() == file_.data() && source.file.size() == file_.size()) return;
    file_ = source.file;
    add_named(Kind::file, source.file);
  }
  /// A new run begins: its file's name may stand where the last one's stood.
  void forget_file() { file_ = {}; }

  void move(const Move& m) {
    Event& e = add(Kind::move);
    e.move = m.kind;
    e.is_manual = m.is_manual;
    e.is_led = m.is_led;
    e.has_number = m.has_feed;
    e.number = m.feed_mmds;
    e.program = static_cast<std::uint16_t>(m.program.known);
    e.machine = static_cast<std::uint16_t>(m.machine.known);
    std::memcpy(e.at, m.program.at, 3 * sizeof e.at[0]);
    std::memcpy(e.at + 3, m.machine.at, 6 * sizeof e.at[0]);
    if (m.kind != Move::Kind::arc) return;
    filling_->arcs.push_back(m.arc);
    std::string_view& plane = filling_->arcs.back().plane;
    const auto* const known = std::find(std::begin(planes), std::end(planes), plane);
    plane = known != std::end(planes) ? *known : std::string_view(filling_->texts[keep(plane)]);
  }
  void dwell(double seconds) { add(Kind::dwell).number = seconds; }
  void orient(double degrees) { add(Kind::orient).number = degrees; }
  void tool(std::int64_t id) { add(Kind::tool).id = id; }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    Event& e = add_named(Kind::spindle, direction);
    e.has_number = has_speed;
    e.number = rpm;
  }
  void coolant(std::string_view mode) { add_named(Kind::coolant, mode); }
  void stop(std::string_view term) { add_named(Kind::stop, term); }
  void end(std::string_view term) { add_named(Kind::end, term); }

  /// False once the output accepts no more.
  bool ok() const { return !closed_.load(std::memory_order_relaxed); }

  /// Writes everything that waits.
  bool drain() {
    if (!worker_.joinable()) {
      write(*filling_);
    } else {
      submit();
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return written_ == submitted_; });
      if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }
    if (!lines_.buffer().flush()) closed_ = true;
    return ok();
  }

 private:
  // To wake a thread on another core takes as long as to write some hundred lines; but what waits here is lost where a
  // plugin ends the process.
  static constexpr std::size_t batch_size = 2048;
  static constexpr std::size_t cache_line = 64;
  enum class Kind : std::uint8_t { file, move, dwell, orient, tool, spindle, coolant, stop, end };
  struct Event {
    Kind kind;
    Move::Kind move;
    bool is_manual, has_number;
    std::uint32_t line;
    std::uint16_t program, machine;  // AxisPoint::known
    bool is_led;
    union {
      double number;
      std::int64_t id;
    };
    double at[9];
    std::uint32_t text;  // of Batch::texts
  };
  struct alignas(cache_line) Batch {
    std::unique_ptr<Event[]> events;  // made when the batch is filled for the first time
    std::size_t count = 0;
    std::vector<Arc> arcs;          // of the arcs among the events, in their order
    std::deque<std::string> texts;  // names, which outlive the run that produced them
  };
  /// A batch is empty after it was written, also after it could not be.
  class Emptied {
   public:
    explicit Emptied(Batch& batch) : batch_(batch) {}
    ~Emptied() {
      batch_.count = 0;
      batch_.arcs.clear();
      batch_.texts.clear();
    }
    Emptied(const Emptied&) = delete;
    Emptied& operator=(const Emptied&) = delete;

   private:
    Batch& batch_;
  };
  static constexpr std::string_view planes[] = {"XY", "ZX", "YZ"};
  static constexpr std::size_t batch_count = 3;

  Event& add(Kind kind) {
    if (filling_->count == batch_size) hand_over();
    Event& e = filling_->events[filling_->count++];
    prefetch(filling_->count);
    e.kind = kind;
    e.line = line_;
    return e;
  }
  /// The writer read this memory last, on another core, from which each line of the cache has to come back.
  void prefetch(std::size_t next) const {
    constexpr std::size_t ahead = 8;
    const char* const at =
        reinterpret_cast<const char*>(filling_->events.get() + std::min(next + ahead, batch_size - 1));
    prefetch_to_write(at);
    prefetch_to_write(at + cache_line);
  }
  static void prefetch_to_write(const char* at) {
#ifdef __x86_64__
    // Without -mprfchw, which not every processor has, __builtin_prefetch() asks to read and leaves the line shared.
    asm volatile("prefetchw %0" : : "m"(*at));
#else
    __builtin_prefetch(at, 1);
#endif
  }
  /// The event first: a full batch takes its names with it.
  Event& add_named(Kind kind, std::string_view text) {
    Event& e = add(kind);
    e.text = keep(text);
    return e;
  }
  std::uint32_t keep(std::string_view text) {
    filling_->texts.emplace_back(text);
    return static_cast<std::uint32_t>(filling_->texts.size() - 1);
  }

  void fill(Batch& batch) {
    if (batch.events == nullptr) batch.events = std::make_unique_for_overwrite<Event[]>(batch_size);
    filling_ = &batch;
  }

  void hand_over() {
    if (!worker_.joinable()) start();
    if (worker_.joinable())
      submit();
    else
      write(*filling_);
  }

  /// Without a second processor, or where no thread can be started, this thread writes.
  void start() {
    if (tried_ || std::thread::hardware_concurrency() < 2) return;
    tried_ = true;
    try {
      worker_ = std::thread([this] { work(); });
    } catch (const std::system_error&) {
    }
  }

  /// The full batch goes to the worker; waits while all others are full, too.
  void submit() {
    std::unique_lock lock(mutex_);
    ++submitted_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return submitted_ - written_ < batch_count; });
    fill(batches_[submitted_ % batch_count]);
  }

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return stops_ || written_ < submitted_; });
      if (stops_) return;
      Batch& batch = batches_[written_ % batch_count];
      lock.unlock();
      try {
        write(batch);
      } catch (...) {  // an output of the embedding program's own: drain() hands it on
        failure_ = std::current_exception();
        closed_ = true;
      }
      lock.lock();
      ++written_;
      changed_.notify_all();
    }
  }

  void write(Batch& batch) {
    const Emptied emptied(batch);
    std::size_t arc = 0;
    BlockSource source{written_file_, 0, 0, {}};
    for (const Event& e : std::span(batch.events.get(), batch.count)) {
      if (closed_) break;
      source.line = e.line;
      if (e.kind == Kind::file) {
        written_file_ = batch.texts[e.text];
        source.file = written_file_;
        lines_.forget_file();
      }
      lines_.block(source);
      switch (e.kind) {
        case Kind::move: write_move(e, e.move == Move::Kind::arc ? &batch.arcs[arc++] : nullptr); break;
        case Kind::dwell: lines_.dwell(e.number); break;
        case Kind::orient: lines_.orient(e.number); break;
        case Kind::tool: lines_.tool(e.id); break;
        case Kind::spindle: lines_.spindle(batch.texts[e.text], e.has_number, e.number); break;
        case Kind::coolant: lines_.coolant(batch.texts[e.text]); break;
        case Kind::stop: lines_.stop(batch.texts[e.text]); break;
        case Kind::end: lines_.end(batch.texts[e.text]); break;
        case Kind::file: break;
      }
      if (!lines_.buffer().ok()) closed_ = true;
    }
  }

  void write_move(const Event& e, const Arc* arc) {
    Move& m = move_;
    m.kind = e.move;
    m.is_manual = e.is_manual;
    m.is_led = e.is_led;
    m.has_feed = e.has_number;
    m.feed_mmds = e.number;
    m.program.known = e.program;
    m.machine.known = e.machine;
    std::memcpy(m.program.at, e.at, 3 * sizeof e.at[0]);
    std::memcpy(m.machine.at, e.at + 3, 6 * sizeof e.at[0]);
    if (arc != nullptr) m.arc = *arc;
    lines_.move(m);
  }

  // The producer's. What each thread writes all the time has lines of the cache to itself.
  alignas(cache_line) Batch* filling_;
  std::string_view file_;  // compared by address: within a run one file is named by the same text
  std::uint32_t line_ = 0;
  bool tried_ = false;
  // The writer's, which is the producer itself while there is no thread.
  alignas(cache_line) Lines lines_;
  Move move_;
  std::string written_file_;
  // Both's: a batch belongs to the worker from submit() until it is counted as written.
  alignas(cache_line) Batch batches_[batch_count];
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t submitted_ = 0, written_ = 0;
  bool stops_ = false;
  std::exception_ptr failure_;
  std::thread worker_;
};

}  // namespace isogloss
