/// Between a MotionReader and the lines that it fills: bulk output is written on a thread of its own, while the next
/// blocks are executed. Lines come out in the same order and are the same bytes as without it.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
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
#include "run/apart.hpp"

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
    add_named({.kind = Kind::file}, source.file);
  }
  /// A new run begins: its file's name may stand where the last one's stood.
  void forget_file() { file_ = {}; }

  void move(const Move& m) {
    make_room();
    add({.kind = Kind::move,
         .move = m.kind,
         .is_manual = m.is_manual,
         .is_led = m.is_led,
         .has_number = m.has_feed,
         .program = static_cast<std::uint8_t>(m.program.known),
         .machine = static_cast<std::uint8_t>(m.machine.known)},
        m.feed_mmds, m.program.at, m.machine.at);
    if (has_rotary(m)) filling_->rotary.push_back({m.machine.at[3], m.machine.at[4], m.machine.at[5]});
    if (m.kind != Move::Kind::arc) return;
    filling_->arcs.push_back(m.arc);
    std::string_view& plane = filling_->arcs.back().plane;
    const auto* const known = std::find(std::begin(planes), std::end(planes), plane);
    plane = known != std::end(planes) ? *known : std::string_view(filling_->texts[keep(plane)]);
  }
  void dwell(double seconds) { add(Kind::dwell, seconds); }
  void orient(double degrees) { add(Kind::orient, degrees); }
  void tool(std::int64_t id) { add(Kind::tool, std::bit_cast<double>(id)); }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    add_named({.kind = Kind::spindle, .has_number = has_speed}, direction, rpm);
  }
  void coolant(std::string_view mode) { add_named({.kind = Kind::coolant}, mode); }
  void stop(std::string_view term) { add_named({.kind = Kind::stop}, term); }
  void end(std::string_view term) { add_named({.kind = Kind::end}, term); }

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
  // plugin ends the process. Where the writer shares its processor it is away for milliseconds, in which the producer
  // fills some batches.
  static constexpr std::size_t batch_size = 2048;
  static constexpr std::size_t cache_line = 64;
  enum class Kind : std::uint8_t { file, move, dwell, orient, tool, spindle, coolant, stop, end };
  struct Head {
    Kind kind;
    Move::Kind move = {};
    bool is_manual = false, is_led = false, has_number = false;
    std::uint8_t program = 0, machine = 0;  // AxisPoint::known

    std::uint64_t packed(std::uint32_t line) const {
      const unsigned what = static_cast<unsigned>(kind) | static_cast<unsigned>(move) << 4 | unsigned{is_manual} << 8 |
                            unsigned{is_led} << 9 | unsigned{has_number} << 10;
      return line | std::uint64_t{what | unsigned{program} << 16 | unsigned{machine} << 24} << 32;
    }
    static Head of(std::uint64_t packed) {
      const auto what = static_cast<std::uint32_t>(packed >> 32);
      return {static_cast<Kind>(what & 15),
              static_cast<Move::Kind>(what >> 4 & 15),
              (what >> 8 & 1) != 0,
              (what >> 9 & 1) != 0,
              (what >> 10 & 1) != 0,
              static_cast<std::uint8_t>(what >> 16),
              static_cast<std::uint8_t>(what >> 24)};
    }
  };
  /// One line of the cache.
  struct alignas(cache_line) Event {
    std::uint64_t head;  // Head::packed() with the line of the program
    double number;       // the bits of an integer where it is a tool
    double at[6];        // X Y Z in program and in machine coordinates; or [0]: which of Batch::texts
  };
  static_assert(sizeof(Event) == cache_line);
  static bool has_rotary(const Move& m) { return m.machine.known > AxisPoint::xyz; }
  struct alignas(cache_line) Batch {
    std::unique_ptr<Event[]> events;  // made when the batch is filled for the first time
    std::size_t count = 0;
    std::vector<Arc> arcs;                      // of the arcs among the events, in their order
    std::vector<std::array<double, 3>> rotary;  // A B C of the moves that has_rotary() names
    std::deque<std::string> texts;              // names, which outlive the run that produced them
  };
  /// A batch is empty after it was written, also after it could not be.
  class Emptied {
   public:
    explicit Emptied(Batch& batch) : batch_(batch) {}
    ~Emptied() {
      batch_.count = 0;
      batch_.arcs.clear();
      batch_.rotary.clear();
      batch_.texts.clear();
    }
    Emptied(const Emptied&) = delete;
    Emptied& operator=(const Emptied&) = delete;

   private:
    Batch& batch_;
  };
  static constexpr std::string_view planes[] = {"XY", "ZX", "YZ"};
  static constexpr std::size_t batch_count = 8;

  void make_room() {
    if (filling_->count == batch_size) hand_over();
  }
  /// Written past the caches: the writer read this memory last, on another core, from which each line would have to
  /// come back first.
  [[gnu::always_inline]] void add(const Head& head, double number, const double (&program)[6],
                                  const double (&machine)[6]) {
    Event& e = filling_->events[filling_->count++];
    const std::uint64_t packed = head.packed(line_);
#ifdef __SSE2__
    double* const to = reinterpret_cast<double*>(&e);
    _mm_stream_pd(to, _mm_set_pd(number, std::bit_cast<double>(packed)));
    _mm_stream_pd(to + 2, _mm_set_pd(program[1], program[0]));
    _mm_stream_pd(to + 4, _mm_set_pd(machine[0], program[2]));
    _mm_stream_pd(to + 6, _mm_set_pd(machine[2], machine[1]));
#else
    e = {packed, number, {program[0], program[1], program[2], machine[0], machine[1], machine[2]}};
#endif
  }
  void add(Kind kind, double number) {
    make_room();
    constexpr double nowhere[6] = {};
    add({.kind = kind}, number, nowhere, nowhere);
  }
  void add_named(const Head& head, std::string_view text, double number = 0) {
    make_room();  // first: a full batch takes its names with it
    const double at[6] = {static_cast<double>(keep(text))};
    add(head, number, at, at);
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
#ifdef __SSE2__
    _mm_sfence();
#endif
    std::unique_lock lock(mutex_);
    ++submitted_;
    producer_on_ = sched_getcpu();
    changed_.notify_all();
    changed_.wait(lock, [&] { return submitted_ - written_ < batch_count; });
    fill(batches_[submitted_ % batch_count]);
  }

  void work() {
    Apart apart;
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [&] { return stops_ || written_ < submitted_; });
      if (stops_) return;
      Batch& batch = batches_[written_ % batch_count];
      const int producer_on = producer_on_;
      lock.unlock();
      apart.from(producer_on);
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
    const Arc* arc = batch.arcs.data();
    const std::array<double, 3>* rotary = batch.rotary.data();
    BlockSource source{written_file_, 0, 0, {}};
    for (const Event& e : std::span(batch.events.get(), batch.count)) {
      if (closed_) break;
      const Head head = Head::of(e.head);
      const auto text = [&]() -> const std::string& { return batch.texts[static_cast<std::size_t>(e.at[0])]; };
      source.line = static_cast<std::uint32_t>(e.head);
      if (head.kind == Kind::file) {
        written_file_ = text();
        source.file = written_file_;
        lines_.forget_file();
      }
      lines_.block(source);
      switch (head.kind) {
        case Kind::move:
          read_move(head, e);
          if (has_rotary(move_)) std::copy_n((rotary++)->data(), 3, move_.machine.at + 3);
          if (head.move == Move::Kind::arc) move_.arc = *arc++;
          lines_.move(move_);
          break;
        case Kind::dwell: lines_.dwell(e.number); break;
        case Kind::orient: lines_.orient(e.number); break;
        case Kind::tool: lines_.tool(std::bit_cast<std::int64_t>(e.number)); break;
        case Kind::spindle: lines_.spindle(text(), head.has_number, e.number); break;
        case Kind::coolant: lines_.coolant(text()); break;
        case Kind::stop: lines_.stop(text()); break;
        case Kind::end: lines_.end(text()); break;
        case Kind::file: break;
      }
      if (!lines_.buffer().ok()) closed_ = true;
    }
  }

  void read_move(const Head& head, const Event& e) {
    Move& m = move_;
    m.kind = head.move;
    m.is_manual = head.is_manual;
    m.is_led = head.is_led;
    m.has_feed = head.has_number;
    m.feed_mmds = e.number;
    m.program.known = head.program;
    m.machine.known = head.machine;
    std::memcpy(m.program.at, e.at, 3 * sizeof e.at[0]);
    std::memcpy(m.machine.at, e.at + 3, 3 * sizeof e.at[0]);
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
  int producer_on_ = -1;  // the processor
  bool stops_ = false;
  std::exception_ptr failure_;
  std::thread worker_;
};

}  // namespace isogloss
