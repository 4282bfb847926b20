/// The blocks of a run as they come: the program runs on a thread of its own, and waits for its reader.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "request.hpp"

namespace isogloss::python {

class BlockStream : public Output {
 public:
  explicit BlockStream(std::shared_ptr<Request> request);
  /// Ends the run. The interpreter's lock is held, and is given away while it waits.
  ~BlockStream() override;
  BlockStream(const BlockStream&) = delete;
  BlockStream& operator=(const BlockStream&) = delete;

  /// The next piece of the JSON Lines; nothing at the end. Throws what a syntax in Python threw, and what a signal's
  /// handler throws.
  std::optional<std::string> next();
  void close();
  /// Of the run so far.
  std::vector<Diagnostic> diagnostics();
  bool is_started();

  bool write(std::string_view bytes) override;

 private:
  /// A sink for two threads.
  class Guarded : public DiagnosticSink {
   public:
    explicit Guarded(std::uint64_t most) : list_(most) {}
    void add(Diagnostic diagnostic) override {
      const std::lock_guard lock(mutex_);
      list_.add(std::move(diagnostic));
    }
    std::vector<Diagnostic> all() {
      const std::lock_guard lock(mutex_);
      return list_.all;
    }
    bool is_full() {
      const std::lock_guard lock(mutex_);
      return list_.is_full();
    }

   private:
    std::mutex mutex_;
    BoundedList list_;
  };

  void work();
  void run();

  std::shared_ptr<Request> request_;
  Guarded sink_;
  std::unique_ptr<PreparedRun> run_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> pieces_;
  std::size_t waiting_bytes_ = 0;
  std::string fault_;  // an exception of the engine
  bool is_over_ = false, is_started_ = false;
  std::atomic<bool> closed_ = false;
  std::thread thread_;
};

}  // namespace isogloss::python
