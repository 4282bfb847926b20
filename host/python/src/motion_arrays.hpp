/// The motions of a run in memory, as numpy sees them: the records of the binary stream, one after the other.
#pragma once

#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/motion_stream.hpp"

namespace isogloss::python {

/// Grows without copying where the system can move pages.
class RecordArray {
 public:
  RecordArray() = default;
  ~RecordArray() { std::free(data_); }
  RecordArray(const RecordArray&) = delete;
  RecordArray& operator=(const RecordArray&) = delete;

  void append(const MotionRecord& record) {
    if (size_ == capacity_) grow();
    data_[size_++] = record;
  }
  std::size_t size() const { return size_; }
  /// The memory, which the caller frees with std::free.
  MotionRecord* release() { return std::exchange(data_, nullptr); }

 private:
  void grow() {
    const std::size_t capacity = capacity_ == 0 ? 1024 : capacity_ * 2;
    void* const data = std::realloc(data_, capacity * sizeof(MotionRecord));
    if (data == nullptr) throw std::bad_alloc();
    data_ = static_cast<MotionRecord*>(data);
    capacity_ = capacity;
  }

  MotionRecord* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
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
