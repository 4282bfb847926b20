#include "sandbox/supervisor.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>

#include "isogloss/engine/printable.hpp"
#include "noted_signals.hpp"
#include "sandbox/confinement.hpp"

namespace isogloss::cli::sandbox {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int tick_ms = 100;                           // how exact the limits are
constexpr auto time_to_end = std::chrono::seconds(3);  // for whole lines, after a signal
constexpr unsigned most_threads = 64;

/// One pipe of the process, and where its bytes go on.
class Relay {
 public:
  Relay(int pipe, int target)
      : pipe_(pipe), target_(target), is_terminal_(isatty(target) != 0), buffer_(new char[buffer_size]) {}
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
      } else if (errno == EAGAIN) {
        pollfd room{target_, POLLOUT, 0};
        ::poll(&room, 1, tick_ms);
      } else if (errno != EINTR) {
        if (errno != EPIPE) fault_ = std::strerror(errno);
        return close();
      } else if (NotedSignals::last() != 0 && ++interruptions_ > 1) {
        return close();  // nobody reads, and somebody waits for the end
      }
    }
  }
  void close() {
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
  }

  int pipe_, target_;
  bool is_terminal_;
  std::unique_ptr<char[]> buffer_;
  std::string rest_, shown_, fault_;
  std::uint64_t bytes_ = 0;
  int interruptions_ = 0;
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

std::uint64_t memory_of(pid_t process) {
  std::uint64_t size = 0, resident = 0;
  std::ifstream("/proc/" + std::to_string(process) + "/statm") >> size >> resident;
  return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) >> 20;
}

unsigned threads_of(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;)
    if (unsigned count = 0; word == "Threads:" && status >> count) return count;
  return 0;
}

class Watch {
 public:
  Watch(pid_t process, const Connections& connections, const Limits& limits)
      : process_(process),
        limits_(limits),
        places_(limits.readable, process),
        out_(connections.out, STDOUT_FILENO),
        errors_(connections.errors, STDERR_FILENO),
        has_one_pipe_(connections.errors < 0) {}
  End run(int socket);

 private:
  void end_by(End::How how, std::string why);
  void hold();
  void hear();
  bool has_ended();
  void tell_limit_of_processor(const struct rusage& used);

  pid_t process_;
  const Limits& limits_;
  ReadablePlaces places_;
  Relay out_, errors_;
  bool has_one_pipe_;  // for both
  int listener_ = -1;
  End end_;
  bool is_ended_ = false;
  Clock::time_point begin_ = Clock::now(), last_look_ = begin_, signalled_ = {};
  Clock::duration written_{0};  // the time that readers of its output took
};

void Watch::end_by(End::How how, std::string why) {
  if (end_.how != End::How::by_itself) return;
  end_.how = how;
  end_.why = std::move(why);
  ::kill(process_, SIGKILL);
}

void Watch::hold() {
  const Clock::time_point now = Clock::now();
  if (NotedSignals::last() != 0 && end_.signal == 0) {
    end_.signal = NotedSignals::last();
    signalled_ = now;
    ::kill(process_, end_.signal);
  }
  if (end_.signal != 0 && now - signalled_ > time_to_end) ::kill(process_, SIGKILL);
  if (now - last_look_ < std::chrono::milliseconds(tick_ms)) return;
  last_look_ = now;
  if (limits_.seconds != 0 && now - begin_ - written_ >= std::chrono::seconds(limits_.seconds))
    end_by(End::How::over_limit, "it was not done after " + std::to_string(limits_.seconds) + " s (--max-time)");
  if (limits_.memory_mib != 0 && memory_of(process_) > limits_.memory_mib + limits_.memory_mib / 4)
    end_by(End::How::over_limit, "it needed more than " + std::to_string(limits_.memory_mib) + " MiB of memory");
  if (threads_of(process_) > most_threads)
    end_by(End::How::over_limit, "it began more than " + std::to_string(most_threads) + " threads");
}

void Watch::hear() {
  std::array<pollfd, 3> waited{pollfd{out_.pipe(), POLLIN, 0}, pollfd{errors_.pipe(), POLLIN, 0},
                               pollfd{listener_, POLLIN, 0}};
  // After its pipes a process closes nothing more: it is about to end.
  const bool is_silent = out_.pipe() < 0 && errors_.pipe() < 0;
  if (::poll(waited.data(), waited.size(), is_silent ? 1 : tick_ms) <= 0) return;
  if ((waited[2].revents & POLLIN) != 0) {
    if (const std::string call = refused_call(listener_, process_, places_); !call.empty())
      end_by(End::How::refused, call);
  } else if (waited[2].revents != 0) {
    ::close(listener_);
    listener_ = -1;
  }
  const Clock::time_point before = Clock::now();
  if (waited[0].revents != 0) out_.hand_on();
  if (waited[1].revents != 0) errors_.hand_on();
  written_ += Clock::now() - before;
  if (limits_.printed_bytes != 0 && std::max(out_.bytes(), errors_.bytes()) > limits_.printed_bytes)
    end_by(End::How::over_limit, "it printed more than " + std::to_string(limits_.printed_bytes) + " bytes");
}

void Watch::tell_limit_of_processor(const struct rusage& used) {
  const auto seconds = static_cast<std::uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  const bool is_by_kernel = end_.number == SIGXCPU || (end_.number == SIGKILL && seconds >= limits_.seconds);
  if (limits_.seconds == 0 || !is_by_kernel) return;
  end_.how = End::How::over_limit;
  end_.why = "it used more than " + std::to_string(limits_.seconds) + " s of the processor (--max-time)";
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
  while (!has_ended() || out_.pipe() >= 0 || errors_.pipe() >= 0) {
    hear();
    if (!is_ended_) hold();
  }
  if (listener_ >= 0) ::close(listener_);
  end_.lost = out_.fault();
  end_.has_said = errors_.bytes() > 0 || (has_one_pipe_ && out_.bytes() > 0);
  return end_;
}

}  // namespace

End watch_over(pid_t process, Connections connections, const Limits& limits) {
  const NotedSignals signals;
  return Watch(process, connections, limits).run(connections.socket);
}

}  // namespace isogloss::cli::sandbox
