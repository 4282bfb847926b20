#include "block_stream.hpp"

#include <chrono>
#include <stdexcept>
#include <utility>

namespace isogloss::python {

namespace {

/// A reader that is slower than the run shall not fill the memory.
constexpr std::size_t most_waiting_bytes = std::size_t{4} << 20;

}  // namespace

BlockStream::BlockStream(std::shared_ptr<Request> request)
    : request_(std::move(request)), sink_(request_->maximum_diagnostics), thread_([this] { work(); }) {}

BlockStream::~BlockStream() { close(); }

bool BlockStream::write(std::string_view bytes) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return closed_ || waiting_bytes_ < most_waiting_bytes; });
  if (closed_) return false;
  waiting_bytes_ += bytes.size();
  pieces_.emplace_back(bytes);
  changed_.notify_all();
  return true;
}

void BlockStream::work() {
  try {
    run();
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex_);
    fault_ = error.what();
  }
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  changed_.notify_all();
}

void BlockStream::run() {
  run_ = std::make_unique<PreparedRun>(*request_, sink_);
  if (!run_->ready()) return;
  {
    const std::lock_guard lock(mutex_);
    is_started_ = true;
  }
  Ends ends(run_->failure(), closed_);
  const std::unique_ptr<Exporter> blocks = make_block_exporter(*this, Format::jsonl);
  run_->options().goes_on = [this] { return !closed_ && !sink_.is_full(); };
  isogloss::run(run_->linked(), run_->source(), request_->path, run_->options(), {blocks.get(), &ends}, sink_);
}

std::optional<std::string> BlockStream::next() {
  constexpr std::chrono::milliseconds between_signals(50);
  while (true) {
    bool is_over = false;
    {
      const py::gil_scoped_release unlocked;
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, between_signals, [&] { return is_over_ || !pieces_.empty(); });
      if (!pieces_.empty()) {
        std::string piece = std::move(pieces_.front());
        pieces_.pop_front();
        waiting_bytes_ -= piece.size();
        changed_.notify_all();
        return piece;
      }
      is_over = is_over_;
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!is_over) continue;
    if (run_ != nullptr) run_->failure().rethrow();
    if (!fault_.empty() && is_started_ && sink_.all().empty()) throw std::runtime_error(fault_);
    return std::nullopt;
  }
}

void BlockStream::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }
  const py::gil_scoped_release unlocked;
  if (thread_.joinable()) thread_.join();
}

std::vector<Diagnostic> BlockStream::diagnostics() { return sink_.all(); }

bool BlockStream::is_started() {
  const std::lock_guard lock(mutex_);
  return is_started_ && fault_.empty();
}

}  // namespace isogloss::python
