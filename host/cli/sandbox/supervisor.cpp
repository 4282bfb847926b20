#include "sandbox/supervisor.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <memory>
#include <optional>

#include "isogloss/engine/printable.hpp"
#include "noted_signals.hpp"
#include "process_use.hpp"
#include "sandbox/confinement.hpp"
#include "stopped_time.hpp"

namespace isogloss::cli::sandbox {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int tick_ms = 100;                           // how exact the limits are
constexpr auto time_to_end = std::chrono::seconds(3);  // for whole lines, after a signal
constexpr unsigned most_threads = 64;

/// As long as it lives, a call of the system that waits is interrupted every 100 ms.
class Ticks {
 public:
  Ticks() {
    struct sigaction action {};
    action.sa_handler = [](int) {};
    ::sigaction(SIGALRM, &action, &before_);
    constexpr suseconds_t tick_us = tick_ms * 1000;
    const itimerval every{{0, tick_us}, {0, tick_us}};
    ::setitimer(ITIMER_REAL, &every, nullptr);
  }
  ~Ticks() {
    const itimerval none{};
    ::setitimer(ITIMER_REAL, &none, nullptr);
    ::sigaction(SIGALRM, &before_, nullptr);
  }
  Ticks(const Ticks&) = delete;
  Ticks& operator=(const Ticks&) = delete;

 private:
  struct sigaction before_ {};
};

/// One pipe of the process, and where its bytes go on.
class Relay {
 public:
  /// `waits` is called now and then while the target takes nothing; false: it shall get no more.
  Relay(int pipe, int target, std::function<bool()> waits)
      : pipe_(pipe),
        target_(target),
        is_terminal_(isatty(target) != 0),
        waits_(std::move(waits)),
        buffer_(new char[buffer_size]) {}
  ~Relay() { close(); }
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;

  int pipe() const { return pipe_; }
  std::uint64_t bytes() const { return bytes_; }
  /// Why the target took no more; empty where it did, and where its reader is gone.
  const std::string& fault() const { return fault_; }

  /// Hands on what is there; at its end, and where the target takes no more, the pipe is closed.
  void hand_on() {
    const ssize_t n = ::read(pipe_, buffer_.get(), buffer_size);
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (n <= 0) {
      if (is_terminal_ && !rest_.empty()) write(printable(rest_, "\n\t"));
      return close();
    }
    bytes_ += static_cast<std::uint64_t>(n);
    const std::string_view text(buffer_.get(), static_cast<std::size_t>(n));
    write(is_terminal_ ? for_terminal(text) : text);
  }

 private:
  static constexpr std::size_t buffer_size = std::size_t{256} << 10;

  /// Nothing but text: the process may have written bytes that would take hold of the terminal.
  std::string_view for_terminal(std::string_view text) {
    rest_ += text;
    // A character whose bytes have not all come yet waits for them.
    std::size_t whole = rest_.size(), back = 0;
    while (back < 3 && back < rest_.size() &&
           (static_cast<unsigned char>(rest_[rest_.size() - 1 - back]) & 0xc0) == 0x80)
      ++back;
    if (back < rest_.size() && static_cast<unsigned char>(rest_[rest_.size() - 1 - back]) >= 0xc0)
      whole = rest_.size() - 1 - back;
    shown_ = printable(std::string_view(rest_).substr(0, whole), "\n\t");
    rest_.erase(0, whole);
    return shown_;
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(target_, bytes.data(), bytes.size());
      if (n >= 0) {
        bytes.remove_prefix(static_cast<std::size_t>(n));
        if (!bytes.empty() && !waits_()) return close();
        continue;
      }
      if (errno != EAGAIN && errno != EINTR) {
        if (errno != EPIPE) fault_ = std::strerror(errno);
        return close();
      }
      if (errno == EAGAIN) {
        pollfd room{target_, POLLOUT, 0};
        ::poll(&room, 1, tick_ms);
      }
      if (!waits_()) return close();
    }
  }
  void close() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
  }

  int pipe_, target_;
  bool is_terminal_;
  std::function<bool()> waits_;
  std::unique_ptr<char[]> buffer_;
  std::string rest_, shown_, fault_;
  std::uint64_t bytes_ = 0;
};

/// The descriptor that the process sends once it is confined. Otherwise a text why it is not.
int receive_listener(int socket, std::string& fault) {
  char text[512];
  iovec part{text, sizeof text};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  ssize_t size = 0;
  while ((size = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  const cmsghdr* const header = size > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    int listener = -1;
    std::memcpy(&listener, CMSG_DATA(header), sizeof listener);
    return listener;
  }
  fault = size > 0 ? std::string(text, static_cast<std::size_t>(size)) : "it ended before it was confined";
  return -1;
}

class Watch {
 public:
  Watch(pid_t process, const Connections& connections, const Limits& limits)
      : process_(process), limits_(limits), places_(limits.readable, process), has_one_pipe_(connections.errors < 0) {
    add(connections.out, STDOUT_FILENO);
    add(connections.errors, STDERR_FILENO);
    for (const Connections::Output& output : connections.outputs) add(output.pipe, output.target);
    struct rlimit processor {};
    if (::getrlimit(RLIMIT_CPU, &processor) == 0) callers_seconds_ = processor.rlim_cur;
  }
  End run(int socket);

 private:
  static constexpr std::size_t out = 0, errors = 1, first_output = 2;

  void add(int pipe, int target) {
    relays_.push_back(std::make_unique<Relay>(pipe, target, [this] { return wait_for_reader(); }));
  }
  bool are_open() const {
    return std::any_of(relays_.begin(), relays_.end(), [](const auto& relay) { return relay->pipe() >= 0; });
  }
  bool wait_for_reader();
  void note_signal();
  void end_by(End::How how, std::string why);
  void hold();
  void hear();
  bool has_ended();
  void tell_limit_of_processor(const struct rusage& used);

  pid_t process_;
  const Limits& limits_;
  ReadablePlaces places_;
  std::vector<std::unique_ptr<Relay>> relays_;
  bool has_one_pipe_;  // for both
  int listener_ = -1;
  End end_;
  bool is_ended_ = false;
  std::uint64_t callers_seconds_ = RLIM_INFINITY;  // of the processor
  Clock::time_point begin_ = Clock::now(), last_look_ = begin_, signalled_ = {};
  std::optional<Clock::time_point> writes_since_;
  Clock::duration written_{0};  // the time that readers of its output took
};

void Watch::end_by(End::How how, std::string why) {
  if (end_.how != End::How::by_itself) return;
  end_.how = how;
  end_.why = std::move(why);
  if (!is_ended_) ::kill(process_, SIGKILL);
}

/// One that ends the command: the process gets it as well, and a while to end.
void Watch::note_signal() {
  if (NotedSignals::last() == 0 || end_.signal != 0) return;
  end_.signal = NotedSignals::last();
  signalled_ = Clock::now();
  if (!is_ended_) ::kill(process_, end_.signal);
}

void Watch::hold() {
  const Clock::time_point now = Clock::now();
  note_signal();
  if (end_.signal != 0 && now - signalled_ > time_to_end) ::kill(process_, SIGKILL);
  if (now - last_look_ < std::chrono::milliseconds(tick_ms)) return;
  begin_ += time_stopped(last_look_, std::chrono::milliseconds(tick_ms));
  last_look_ = now;
  const Clock::duration of_readers = written_ + (writes_since_ ? now - *writes_since_ : Clock::duration(0));
  if (limits_.seconds != 0 && now - begin_ - of_readers >= std::chrono::seconds(limits_.seconds))
    end_by(End::How::over_limit, "it was not done after " + std::to_string(limits_.seconds) + " s (--max-time)");
  const ProcessUse use = use_of(process_);
  if (limits_.memory_mib != 0 && use.resident_mib > limits_.memory_mib + limits_.memory_mib / 4)
    end_by(End::How::over_limit, "it needed more than " + std::to_string(limits_.memory_mib) + " MiB of memory");
  if (use.threads > most_threads)
    end_by(End::How::over_limit, "it began more than " + std::to_string(most_threads) + " threads");
}

/// A process is held to its limits meanwhile as well.
bool Watch::wait_for_reader() {
  if (has_ended())
    note_signal();
  else
    hold();
  if (end_.signal == 0) return true;
  if (Clock::now() - signalled_ <= time_to_end) return true;
  end_by(End::How::by_signal, {});
  return false;
}

void Watch::hear() {
  std::vector<pollfd> waited{{listener_, POLLIN, 0}};
  for (const auto& relay : relays_) waited.push_back({relay->pipe(), POLLIN, 0});
  // After its pipes a process closes nothing more: it is about to end.
  if (::poll(waited.data(), waited.size(), are_open() ? tick_ms : 1) <= 0) return;
  if ((waited[0].revents & POLLIN) != 0) {
    if (const std::string call = refused_call(listener_, process_, places_); !call.empty())
      end_by(End::How::refused, call);
  } else if (waited[0].revents != 0) {
    ::close(listener_);
    listener_ = -1;
  }
  std::uint64_t most = 0;
  writes_since_ = Clock::now();
  for (std::size_t i = 0; i < relays_.size(); ++i) {
    if (waited[i + 1].revents != 0) relays_[i]->hand_on();
    most = std::max(most, relays_[i]->bytes());
  }
  written_ += Clock::now() - *writes_since_;
  writes_since_.reset();
  if (limits_.printed_bytes != 0 && most > limits_.printed_bytes)
    end_by(End::How::over_limit, "it printed more than " + std::to_string(limits_.printed_bytes) + " bytes");
}

void Watch::tell_limit_of_processor(const struct rusage& used) {
  const std::uint64_t own = limits_.seconds != 0 ? limits_.seconds : RLIM_INFINITY;
  const std::uint64_t most = std::min(own, callers_seconds_);
  const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  const bool is_by_kernel = end_.number == SIGXCPU || (end_.number == SIGKILL && seconds >= most);
  if (most == RLIM_INFINITY || !is_by_kernel) return;
  end_.how = End::How::over_limit;
  end_.why = "it used more than " + std::to_string(most) + " s of the processor (" +
             (own <= callers_seconds_ ? "--max-time)" : "a limit of whoever has called)");
}

bool Watch::has_ended() {
  int status = 0;
  struct rusage used {};
  if (is_ended_ || ::wait4(process_, &status, WNOHANG, &used) != process_) return is_ended_;
  is_ended_ = true;
  end_.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  if (end_.how != End::How::by_itself || !WIFSIGNALED(status)) return true;
  end_.how = End::How::by_signal;
  tell_limit_of_processor(used);
  return true;
}

End Watch::run(int socket) {
  std::string fault;
  listener_ = receive_listener(socket, fault);
  ::close(socket);
  if (listener_ < 0) end_by(End::How::not_begun, fault);
  // What it has printed before its end is handed on whole.
  while (!has_ended() || are_open()) {
    hear();
    if (!is_ended_) hold();
  }
  if (listener_ >= 0) ::close(listener_);
  end_.lost = relays_[out]->fault();
  for (std::size_t i = first_output; i < relays_.size(); ++i) end_.lost_outputs.push_back(relays_[i]->fault());
  end_.has_said = relays_[errors]->bytes() > 0 || (has_one_pipe_ && relays_[out]->bytes() > 0);
  return end_;
}

}  // namespace

End watch_over(pid_t process, Connections connections, const Limits& limits) {
  const NotedSignals signals;
  const Ticks ticks;
  return Watch(process, connections, limits).run(connections.socket);
}

}  // namespace isogloss::cli::sandbox
