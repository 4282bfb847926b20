/// The line of progress of a run: how much of its program is read, and how many blocks are done.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "isogloss/engine/runner.hpp"
#include "session.hpp"

namespace isogloss::cli {

/// In bytes; 0 for what is no file.
std::uint64_t size_of_program(const std::string& path);

/// From now on a run with these options shows how far it is. Take the line away (Progress::hide) before data is
/// written. The session outlives the options.
void show_progress(RunOptions& options, const std::string& path, Session& session);

/// How far a run on another thread is; whoever has the session shows it.
class ProgressOfThread {
 public:
  void listen(RunOptions& options) {
    options.progress = [this](std::uint64_t, std::uint64_t bytes) { bytes_.store(bytes, std::memory_order_relaxed); };
  }
  std::uint64_t bytes() const { return bytes_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> bytes_{0};
};

/// Shows how much of a comparison is done, every few hundred steps.
class ComparisonProgress {
 public:
  ComparisonProgress(Session& session, const std::string& path, const ProgressOfThread& run)
      : session_(session), path_(path), size_(size_of_program(path)), run_(run) {}
  ~ComparisonProgress() { session_.progress().hide(); }
  ComparisonProgress(const ComparisonProgress&) = delete;
  ComparisonProgress& operator=(const ComparisonProgress&) = delete;

  void step();

 private:
  Session& session_;
  const std::string path_;
  const std::uint64_t size_;
  const ProgressOfThread& run_;
  std::uint64_t steps_ = 0;
};

}  // namespace isogloss::cli
