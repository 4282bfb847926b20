/// Between a MotionReader and the lines that it fills: bulk output is written on a thread of its own, while the next
/// blocks are executed. Lines come out in the same order and are the same bytes as without it.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "motion_reader.hpp"

namespace isogloss {

/// Takes the events of a reader and hands them to `Lines` in batches. A program that does not fill a batch, and a
/// machine with one processor, see no thread. Nothing that is kept points into the document.
template <class Lines>
class MotionQueue {
 public:
  explicit MotionQueue(Lines lines) : lines_(std::move(lines)) { filling_ = &batches_[0]; }
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
    add(Kind::file).text = keep(source.file);
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
    for (int i = 0; i < 3; ++i) e.at[i] = m.program.at[i];
    for (int i = 0; i < 6; ++i) e.at[3 + i] = m.machine.at[i];
    if (m.kind != Move::Kind::arc) return;
    filling_->arcs.push_back(m.arc);
    std::string_view& plane = filling_->arcs.back().plane;
    const auto* const known = std::find(std::begin(planes), std::end(planes), plane);
    plane = known != std::end(planes) ? *known : keep(plane);
  }
  void dwell(double seconds) { add(Kind::dwell).number = seconds; }
  void orient(double degrees) { add(Kind::orient).number = degrees; }
  void tool(std::int64_t id) { add(Kind::tool).id = id; }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    Event& e = add(Kind::spindle);
    e.text = keep(direction);
    e.has_number = has_speed;
    e.number = rpm;
  }
  void coolant(std::string_view mode) { add(Kind::coolant).text = keep(mode); }
  void stop(std::string_view term) { add(Kind::stop).text = keep(term); }
  void end(std::string_view term) { add(Kind::end).text = keep(term); }

  /// False once the output takes no more.
  bool ok() const { return !closed_.load(std::memory_order_relaxed); }

  /// Writes all that waits.
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
    std::string_view text;
  };
  struct Batch {
    std::vector<Event> events;
    std::vector<Arc> arcs;          // of the arcs among the events, in their order
    std::deque<std::string> texts;  // names, which outlive the run that told them
  };
  /// A batch is empty after it was written, also after it could not be.
  class Emptied {
   public:
    explicit Emptied(Batch& batch) : batch_(batch) {}
    ~Emptied() {
      batch_.events.clear();
      batch_.arcs.clear();
      batch_.texts.clear();
    }
    Emptied(const Emptied&) = delete;
    Emptied& operator=(const Emptied&) = delete;

   private:
    Batch& batch_;
  };
  static constexpr std::string_view planes[] = {"XY", "ZX", "YZ"};
  static constexpr std::size_t batch_size = 512;
  static constexpr std::size_t batch_count = 4;

  Event& add(Kind kind) {
    if (filling_->events.size() == batch_size) hand_over();
    Event& e = filling_->events.emplace_back();
    e.kind = kind;
    e.line = line_;
    return e;
  }
  std::string_view keep(std::string_view text) { return filling_->texts.emplace_back(text); }

  void hand_over() {
    if (!worker_.joinable()) start();
    if (worker_.joinable())
      submit();
    else
      write(*filling_);
  }

  /// Without a second processor, or without a thread to be had, this one writes.
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
    filling_ = &batches_[submitted_ % batch_count];
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
    for (const Event& e : batch.events) {
      if (closed_) break;
      source.line = e.line;
      if (e.kind == Kind::file) {
        written_file_ = e.text;
        source.file = written_file_;
        lines_.forget_file();
      }
      lines_.block(source);
      switch (e.kind) {
        case Kind::move: write_move(e, e.move == Move::Kind::arc ? &batch.arcs[arc++] : nullptr); break;
        case Kind::dwell: lines_.dwell(e.number); break;
        case Kind::orient: lines_.orient(e.number); break;
        case Kind::tool: lines_.tool(e.id); break;
        case Kind::spindle: lines_.spindle(e.text, e.has_number, e.number); break;
        case Kind::coolant: lines_.coolant(e.text); break;
        case Kind::stop: lines_.stop(e.text); break;
        case Kind::end: lines_.end(e.text); break;
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
    for (int i = 0; i < 3; ++i) m.program.at[i] = e.at[i];
    for (int i = 0; i < 6; ++i) m.machine.at[i] = e.at[3 + i];
    if (arc != nullptr) m.arc = *arc;
    lines_.move(m);
  }

  // The producer's.
  Batch* filling_;
  std::string_view file_;  // compared by address: within a run one file is named by the same text
  std::uint32_t line_ = 0;
  bool tried_ = false;
  // The writer's, which is the producer itself while there is no thread.
  Lines lines_;
  Move move_;
  std::string written_file_;
  // Both's: a batch belongs to the worker from submit() until it is counted as written.
  Batch batches_[batch_count];
  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t submitted_ = 0, written_ = 0;
  bool stops_ = false;
  std::exception_ptr failure_;
  std::thread worker_;
};

}  // namespace isogloss
