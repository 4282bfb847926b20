#include "validate/side_by_side.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <list>
#include <nlohmann/json.hpp>

#include "crash_guard.hpp"

namespace isogloss::cli {

using Json = nlohmann::ordered_json;

namespace {

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

struct AtWork {
  std::size_t place = 0;
  pid_t process = 0;
  int pipe = -1;
  std::string text;
  SharedText attempt;
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
      write_all(pipes[1], to_line(outcome_of(*checks_[one.place], one.attempt)));
      end_process(success);
    }
    close(pipes[1]);
    one.pipe = pipes[0];
  }

  /// In the process that watches over the check, which nothing leaves but the outcome.
  Outcome outcome_of(const Check& check, SharedText& attempt) const try {
    return run_in_child(check, options_, file_, [&](std::string_view at_work) { attempt.write(at_work); });
  } catch (const std::exception& e) {
    return {.check = &check, .findings = {{"", std::string("the check could not go on: ") + e.what()}}};
  }

  void tell() const {
    const AtWork& oldest = at_work_.front();
    listener_.at_work(*checks_[oldest.place], oldest.attempt.read());
  }

  void hear() {
    constexpr int tick_ms = 50;
    std::vector<pollfd> polled;
    for (const AtWork& one : at_work_) polled.push_back({one.pipe, POLLIN, 0});
    poll(polled.data(), polled.size(), tick_ms);
    auto looked_at = polled.begin();
    for (auto one = at_work_.begin(); one != at_work_.end();) {
      // Processes that the plugin has started may hold the pipe open for longer, so that it has no end.
      const bool has_ended = child_has_ended(one->process);
      const bool is_told = (looked_at++)->revents != 0 && read_more(*one);
      if (is_told || has_ended) end(*one);
      one = is_told || has_ended ? at_work_.erase(one) : std::next(one);
    }
  }

  /// True when the outcome is whole, or no more of it comes.
  static bool read_more(AtWork& one) {
    char buffer[1u << 14];
    const ssize_t n = read(one.pipe, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) return false;
    if (n > 0) one.text.append(buffer, static_cast<std::size_t>(n));
    return n <= 0 || one.text.ends_with('\n');
  }

  void end(AtWork& one) {
    fcntl(one.pipe, F_SETFL, O_NONBLOCK);
    while (!one.text.ends_with('\n') && !read_more(one)) {
    }
    close(one.pipe);
    while (waitpid(one.process, nullptr, 0) < 0 && errno == EINTR) {
    }
    outcomes_[one.place] = from_line(*checks_[one.place], one.text);
    listener_.ended();
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
