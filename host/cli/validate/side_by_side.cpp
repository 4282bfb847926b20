#include "validate/side_by_side.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <list>
#include <nlohmann/json.hpp>

#include "crash_guard.hpp"

namespace isogloss::cli {

namespace {

using Json = nlohmann::ordered_json;

/// One line, so that its end says that it is whole.
std::string to_line(const Outcome& outcome) {
  Json findings = Json::array();
  for (const Finding& finding : outcome.findings) findings.push_back({finding.where, finding.what});
  const Json all{{"Skipped", outcome.skipped},
                 {"Findings", std::move(findings)},
                 {"More", outcome.more},
                 {"Remarks", outcome.remarks},
                 {"Seconds", outcome.seconds}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Outcome from_line(const Check& check, const std::string& line) {
  Outcome out{.check = &check};
  const Json all = Json::parse(line, nullptr, false);
  if (!line.ends_with('\n') || !all.is_object()) {
    out.findings.push_back({"", "the process that watched over the check has ended"});
    return out;
  }
  out.skipped = all["Skipped"];
  for (const Json& finding : all["Findings"]) out.findings.push_back({finding[0], finding[1]});
  out.more = all["More"];
  out.remarks = all["Remarks"].get<std::vector<std::string>>();
  out.seconds = all["Seconds"];
  return out;
}

void send(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// What one check is doing, for the progress of the command: the process that watches over it writes there.
class Board {
 public:
  Board() {
    void* const shared = mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory for a check");
    text_ = static_cast<char*>(shared);
  }
  ~Board() { munmap(text_, room); }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  void write(std::string_view text) {
    const std::size_t size = std::min(text.size(), room - 1);
    std::memcpy(text_, text.data(), size);
    text_[size] = '\0';
  }
  std::string read() const { return {text_, strnlen(text_, room)}; }

 private:
  static constexpr std::size_t room = 4096;
  char* text_;
};

struct AtWork {
  std::size_t place = 0;
  pid_t process = 0;
  int pipe = -1;
  std::string text;
  Board board;
};

class SideBySide {
 public:
  SideBySide(std::span<const Check* const> checks, unsigned most, const ValidateOptions& options,
             const std::string& file, const SideBySideListener& listener)
      : checks_(checks), most_(most), options_(options), file_(file), listener_(listener), outcomes_(checks.size()) {
    for (const bool is_alone : {false, true})
      for (std::size_t place = 0; place < checks.size(); ++place)
        if (checks[place]->is_alone == is_alone) waiting_.push_back(place);
  }

  std::vector<Outcome> run() {
    while (!waiting_.empty() || !at_work_.empty()) {
      while (may_start()) start();
      tell();
      hear();
    }
    return std::move(outcomes_);
  }

 private:
  bool may_start() const {
    if (waiting_.empty() || at_work_.size() >= most_) return false;
    return at_work_.empty() || !(checks_[waiting_.front()]->is_alone || checks_[at_work_.front().place]->is_alone);
  }

  void start() {
    AtWork& one = at_work_.emplace_back();
    one.place = waiting_.front();
    waiting_.pop_front();
    int pipes[2];
    if (pipe2(pipes, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a check");
    const pid_t parent = getpid();
    one.process = fork();
    if (one.process < 0) throw std::runtime_error("no process for a check");
    if (one.process == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) end_process(internal_fault);
      const auto watcher = [&](std::string_view at_work) { one.board.write(at_work); };
      send(pipes[1], to_line(run_in_child(*checks_[one.place], options_, file_, watcher)));
      end_process(success);
    }
    close(pipes[1]);
    one.pipe = pipes[0];
  }

  void tell() const {
    const AtWork& oldest = at_work_.front();
    listener_.at_work(*checks_[oldest.place], oldest.board.read());
  }

  void hear() {
    constexpr int tick_ms = 50;
    std::vector<pollfd> polled;
    for (const AtWork& one : at_work_) polled.push_back({one.pipe, POLLIN, 0});
    if (poll(polled.data(), polled.size(), tick_ms) <= 0) return;
    auto looked_at = polled.begin();
    for (auto one = at_work_.begin(); one != at_work_.end();) {
      const bool has_ended = (looked_at++)->revents != 0 && hear(*one);
      one = has_ended ? at_work_.erase(one) : std::next(one);
    }
  }

  /// True when the check has ended. A process that the plugin has started may hold the pipe open for longer.
  bool hear(AtWork& one) {
    char buffer[1u << 14];
    const ssize_t n = read(one.pipe, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) return false;
    if (n > 0) one.text.append(buffer, static_cast<std::size_t>(n));
    if (n > 0 && !one.text.ends_with('\n')) return false;
    close(one.pipe);
    while (waitpid(one.process, nullptr, 0) < 0 && errno == EINTR) {
    }
    outcomes_[one.place] = from_line(*checks_[one.place], one.text);
    listener_.ended();
    return true;
  }

  std::span<const Check* const> checks_;
  unsigned most_;
  const ValidateOptions& options_;
  const std::string& file_;
  const SideBySideListener& listener_;
  std::list<std::size_t> waiting_;
  std::list<AtWork> at_work_;
  std::vector<Outcome> outcomes_;
};

}  // namespace

std::vector<Outcome> run_side_by_side(std::span<const Check* const> checks, unsigned most,
                                      const ValidateOptions& options, const std::string& file,
                                      const SideBySideListener& listener) {
  return SideBySide(checks, most, options, file, listener).run();
}

}  // namespace isogloss::cli
