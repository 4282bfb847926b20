/// The motions of a run in memory, as numpy sees them: the records of the binary stream, one after the other.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/motion_stream.hpp"

namespace isogloss::python {

/// Grows without copying: the system moves its pages. They are large ones where it has them: a million records are
/// 30,000 small pages, which the system gives more slowly than a run fills them. A thread asks for them ahead of the
/// run, since a system in a virtual machine may take as long for a page as the run for its records.
class RecordArray {
 public:
  RecordArray() = default;
  RecordArray(RecordArray&& other) noexcept {
    other.asker_ = {};
    data_ = std::exchange(other.data_, nullptr);
    capacity_ = std::exchange(other.capacity_, 0);
    size_ = other.size_.exchange(0);
  }
  RecordArray& operator=(RecordArray&&) = delete;
  ~RecordArray() {
    asker_ = {};
    if (data_ != nullptr) ::munmap(data_, capacity_ * sizeof(MotionRecord));
  }

  void append(const MotionRecord& record) {
    const std::size_t at = size_.load(std::memory_order_relaxed);
    if (at == capacity_) grow();
    data_[at] = record;
    size_.store(at + 1, std::memory_order_relaxed);
  }
  std::size_t size() const { return size_; }
  MotionRecord* data() { return data_; }

 private:
  /// Whole pages of whole records.
  static constexpr std::size_t first_bytes = 4096 * sizeof(MotionRecord);
  static constexpr std::size_t asked_at_once = std::size_t{2} << 20, asked_ahead = std::size_t{16} << 20;

  void grow() {
    asker_ = {};
    const std::size_t bytes = capacity_ * sizeof(MotionRecord), more = bytes == 0 ? first_bytes : 2 * bytes;
    void* const data = bytes == 0 ? ::mmap(nullptr, more, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                                  : ::mremap(data_, bytes, more, MREMAP_MAYMOVE);
    if (data == MAP_FAILED) throw std::bad_alloc();
    ::madvise(data, more, MADV_HUGEPAGE);  // a refusal costs time, and nothing else
    data_ = static_cast<MotionRecord*>(data);
    capacity_ = more / sizeof(MotionRecord);
    if (more - bytes >= asked_at_once) ask_ahead(bytes, more);
  }

  /// Without the thread, and where the system does not know the request, each page comes with its first record.
  void ask_ahead(std::size_t begin, std::size_t end) {
    try {
      asker_ = std::jthread([this, begin, end](const std::stop_token& stop) {
        char* const memory = reinterpret_cast<char*>(data_);
        for (std::size_t at = begin; at < end && !stop.stop_requested();) {
          if (at > size_.load(std::memory_order_relaxed) * sizeof(MotionRecord) + asked_ahead)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          else if (::madvise(memory + at, std::min(asked_at_once, end - at), MADV_POPULATE_WRITE) == 0)
            at += asked_at_once;
          else
            return;
        }
      });
    } catch (const std::system_error&) {
    }
  }
  MotionRecord* data_ = nullptr;
  std::size_t capacity_ = 0;
  std::atomic<std::size_t> size_ = 0;
  std::jthread asker_;  ///< rests before the memory moves or goes
};

/// Where an arc with a known centre lies. Laid out for numpy.
struct CircleRow {
  std::int64_t motion;  ///< the arc, by its place among the motions
  double center[3], machine_center[3], normal[3];
  double sweep;
};

/// What reads a stream into arrays.
class MotionArrays : public Output {
 public:
  MotionArrays(const std::string& name, DiagnosticSink& sink)
      : reader_(
            name,
            [this](const MotionRecord& event, const MotionRecord* circle) {
              if (circle != nullptr) add(*circle);
              motions.append(event);
              return true;
            },
            sink) {}

  bool write(std::string_view bytes) override { return reader_.take(bytes); }
  /// False, and reported, when the stream was incomplete.
  bool end() { return reader_.end(); }
  const std::vector<std::string>& texts() const { return reader_.texts(); }

  RecordArray motions;
  std::vector<CircleRow> circles;

 private:
  void add(const MotionRecord& c) {
    CircleRow row{static_cast<std::int64_t>(motions.size()), {}, {}, {}, c.value};
    std::copy_n(c.program, 3, row.center);
    std::copy_n(c.machine, 3, row.machine_center);
    std::copy_n(c.machine + 3, 3, row.normal);
    circles.push_back(row);
  }

  MotionStreamReader reader_;
};

}  // namespace isogloss::python
