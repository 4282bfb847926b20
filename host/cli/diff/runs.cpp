#include "diff/runs.hpp"

#include <pthread.h>
#include <signal.h>

namespace isogloss::cli::parting {

TwoThreads::TwoThreads(const std::function<void(std::size_t side)>& run, std::function<void()> stop)
    : stop_(std::move(stop)) {
  for (std::size_t side = 0; side < 2; ++side)
    threads_[side] = std::thread([run, side] {
      // Signals that end the command belong to the main thread.
      sigset_t others;
      sigemptyset(&others);
      for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2}) sigaddset(&others, number);
      pthread_sigmask(SIG_BLOCK, &others, nullptr);
      run(side);
    });
}

/// The watch of calls looks at the thread that its signal reaches, and reports what it meets there twice.
void TwoThreads::report_stall(std::size_t side) {
  for (int i = 0; i < 2; ++i) {
    pthread_kill(threads_[side].native_handle(), SIGALRM);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

TwoThreads::~TwoThreads() {
  stop_();
  for (std::thread& thread : threads_) thread.join();
}

}  // namespace isogloss::cli::parting
