#include "noted_signals.hpp"

namespace isogloss::cli {

namespace {

volatile std::sig_atomic_t last_signal = 0;
void note_signal(int number) { last_signal = number; }

}  // namespace

NotedSignals::NotedSignals() {
  last_signal = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    ::sigaction(numbers_[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) ::sigaction(numbers_[i], &action, nullptr);
  }
}

NotedSignals::~NotedSignals() {
  for (std::size_t i = 0; i < numbers_.size(); ++i) ::sigaction(numbers_[i], &before_[i], nullptr);
}

int NotedSignals::last() { return last_signal; }

}  // namespace isogloss::cli
