#include "sandbox/untrusted.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <utility>

#include "crash_guard.hpp"
#include "sandbox/confinement.hpp"
#include "sandbox/shared_state.hpp"
#include "sandbox/supervisor.hpp"

namespace isogloss::cli {

namespace sandbox {

namespace {

namespace fs = std::filesystem;

SharedState* told = nullptr;  // in the process that works

/// Reports what the supervisor has to tell. A session of its own, since that of the work belongs to the other process;
/// only when there is something, since a form of diagnostics may have a frame.
class Reports {
 public:
  explicit Reports(CommonOptions common) : common_(std::move(common)) {
    common_.diagnostics_output.clear();
    common_.loads_plugins = false;
  }
  void add(std::string_view code, Location where, std::initializer_list<std::string> arguments, std::string hint = {}) {
    if (session_ == nullptr) session_ = std::make_unique<Session>(common_);
    session_->report(code, std::move(where), arguments, std::move(hint));
  }

 private:
  CommonOptions common_;
  std::unique_ptr<Session> session_;
};

/// The files that the work writes, opened before it begins.
class Outputs {
 public:
  explicit Outputs(const std::vector<std::string>& paths, SharedState& state) : state_(state) {
    for (const std::string& path : paths) {
      if (path.empty() || path == "-" || prepared_.size() == most_outputs) continue;
      std::string error;
      files_.push_back(OutputFile::open(path, error));
      int descriptor = files_.back() != nullptr ? files_.back()->descriptor() : -1;
      if (struct stat info{}; descriptor >= 0 && ::fstat(descriptor, &info) == 0 && !S_ISREG(info.st_mode))
        descriptor = hand_on(path, descriptor, error);
      prepared_.push_back({path, descriptor, error, &state.is_complete[prepared_.size()]});
    }
  }
  ~Outputs() { close_writing_ends(); }
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  const std::vector<OutputFile::Prepared>& prepared() const { return prepared_; }
  std::vector<int> descriptors() const {
    std::vector<int> out;
    for (const auto& one : prepared_)
      if (one.descriptor >= 0) out.push_back(one.descriptor);
    return out;
  }
  /// Those that are no files, for the process that watches.
  std::vector<Connections::Output> handed_on() const {
    std::vector<Connections::Output> out;
    for (const HandedOn& one : handed_on_) out.push_back(one.ends);
    return out;
  }
  /// In the process that watches: the other one alone writes to them, and its end is theirs.
  void close_writing_ends() {
    for (HandedOn& one : handed_on_)
      if (one.writing_end >= 0) ::close(std::exchange(one.writing_end, -1));
  }
  /// Renames those that are complete. The others go. `lost`: why one that was handed on took no more.
  bool commit(const std::vector<std::string>& lost, Reports& reports) {
    bool is_written = true;
    for (std::size_t i = 0; i < lost.size(); ++i) {
      if (lost[i].empty()) continue;
      reports.add("IG-0511", {handed_on_[i].path}, {lost[i]});
      is_written = false;
    }
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i] == nullptr || !state_.is_complete[i] || files_[i]->commit()) continue;
      reports.add("IG-0511", {prepared_[i].path}, {files_[i]->error()});
      is_written = false;
    }
    return is_written;
  }
  void forget() {
    for (HandedOn& one : handed_on_) one.writing_end = -1;
    for (auto& file : files_) [[maybe_unused]] const OutputFile* const left_to_the_other_process = file.release();
  }

 private:
  struct HandedOn {
    std::string path;
    Connections::Output ends;
    int writing_end = -1;
  };

  /// A pipe in its place.
  int hand_on(const std::string& path, int target, std::string& error) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return error = std::strerror(errno), -1;
    handed_on_.push_back({path, {ends[0], target}, ends[1]});
    return ends[1];
  }

  SharedState& state_;
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<OutputFile::Prepared> prepared_;
  std::vector<HandedOn> handed_on_;
};

/// What comes from a pipe or a terminal, as an unlinked file that can be read again: the work can make no such file.
int copy_of_stdin(std::string& fault) {
  constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;
  const char* const folder = std::getenv("TMPDIR");
  std::string name = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/isogloss-XXXXXX";
  int file = -1, copy = -1;
  {
    const WholeLines none_is_left;
    file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) return fault = name + ": " + std::strerror(errno), -1;
    copy = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);  // can only read
    ::unlink(name.c_str());
  }
  const std::unique_ptr<char[]> buffer(new char[1u << 16]);
  std::uint64_t size = 0;
  while (fault.empty()) {
    const ssize_t n = ::read(STDIN_FILENO, buffer.get(), 1u << 16);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fault = std::strerror(errno);
    if (n <= 0) break;
    size += static_cast<std::uint64_t>(n);
    if (size > most_bytes) fault = "it is larger than 16 GiB";
    for (ssize_t at = 0; at < n && fault.empty();) {
      const ssize_t written = ::write(file, buffer.get() + at, static_cast<std::size_t>(n - at));
      if (written < 0 && errno != EINTR) fault = std::string("its copy: ") + std::strerror(errno);
      at += std::max<ssize_t>(written, 0);
    }
  }
  ::close(file);
  return copy;
}

/// Standard input for the work: a file that can only be read, or nothing.
int stdin_for_work(bool is_read, std::string& fault) {
  struct stat info {};
  int out = -1;
  if (!is_read || ::fstat(STDIN_FILENO, &info) != 0) {
    out = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  } else if (!S_ISREG(info.st_mode)) {
    out = copy_of_stdin(fault);
  } else {
    out = ::open("/proc/self/fd/0", O_RDONLY | O_CLOEXEC);
    // Some of it may have been read already.
    if (out >= 0) ::lseek(out, ::lseek(STDIN_FILENO, 0, SEEK_CUR), SEEK_SET);
  }
  if (out < 0 && fault.empty()) fault = std::strerror(errno);
  return out;
}

/// The first bytes of a regular file that are no blanks.
std::string begin_of(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};  // a pipe would wait for its writer
  std::ifstream in(file, std::ios::binary);
  std::string out(256, '\0');
  in.read(out.data(), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (out.starts_with("\xef\xbb\xbf")) out.erase(0, 3);
  return out.erase(0, std::min(out.find_first_not_of(" \t\r\n"), out.size()));
}

/// A link in a folder of plugins, dialects or machines leads where its maker likes. What it leads to is readable only
/// where the work would take it for one of these.
bool is_followed(const fs::path& link) {
  std::error_code error;
  if (fs::is_directory(link, error)) return begin_of(link / "machine.xml").starts_with('<');
  const std::string begin = begin_of(link);
  const bool is_library = link.filename().string().find(".so") != std::string::npos;
  return is_library ? begin.starts_with("\177ELF") : link.extension() == ".xml" && begin.starts_with('<');
}

/// Nobody has named the folder `machines` of a folder of dialects: as a link it may lead anywhere.
bool leads_elsewhere(const Place& place) {
  std::error_code error;
  const fs::path folder = place.folder.parent_path(), real = fs::canonical(folder, error);
  const fs::path target = fs::canonical(place.folder, error);
  return !error && place.named_by == machines_beside_dialects && target != real / place.folder.filename();
}

std::vector<std::string> readable_by(const UntrustedWork& work) {
  std::vector<std::string> out;
  std::error_code error;
  DiagnosticList unheard;
  const Workspace workspace({work.common.plugins, work.common.dialects, work.common.machines}, folder_of_executable(),
                            unheard);
  for (const auto* const places :
       {&workspace.plugin_places(), &workspace.dialect_places(), &workspace.machine_places()})
    for (const Place& place : *places) {
      if (leads_elsewhere(place)) continue;
      out.push_back(place.folder.string());
      for (fs::directory_iterator at(place.folder, error), end; !error && at != end; at.increment(error))
        if (std::error_code ignored; at->is_symlink(ignored) && is_followed(at->path()))
          out.push_back(at->path().string());
    }
  out.push_back((folder_of_executable() / "isogloss").string());
  const auto add = [&](const std::string& path) {
    if (path.empty() || path == "-") return;
    const fs::path whole = fs::absolute(path, error);
    out.push_back(path);
    if (!fs::is_directory(path, error)) out.push_back(whole.parent_path().string());
  };
  for (const std::string& path : work.programs) add(path);
  for (const std::string& path : work.reads)
    if (fs::exists(path, error)) add(path);
  return out;
}

void keep_descriptors(std::vector<int> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned first = STDERR_FILENO + 1;
  for (const int descriptor : kept) {
    const auto at = static_cast<unsigned>(descriptor);
    if (at < first) continue;
    if (at > first) ::syscall(SYS_close_range, first, at - 1, 0);
    first = at + 1;
  }
  ::syscall(SYS_close_range, first, ~0u, 0);
}

/// The pipes and the socket between both processes.
struct Lines {
  int socket[2] = {-1, -1}, out[2] = {-1, -1}, errors[2] = {-1, -1};

  bool open() {
    return ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, socket) == 0 && pipe(out) &&
           (is_one() || pipe(errors));
  }
  int errors_to_write() const { return errors[1] >= 0 ? errors[1] : out[1]; }

 private:
  static bool pipe(int (&ends)[2]) {
    constexpr int size = 1 << 20;
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    ::fcntl(ends[0], F_SETPIPE_SZ, size);  // as large as it may be: fewer changes between the processes
    return true;
  }
  /// Where both go to one file, the order of what is written stays.
  static bool is_one() {
    struct stat a {
    }, b{};
    return ::fstat(STDOUT_FILENO, &a) == 0 && ::fstat(STDERR_FILENO, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
  }
};

/// In the new process, up to where it may read what strangers have written.
void begin_work(const UntrustedOptions& options, const UntrustedWork& work, const std::vector<std::string>& readable,
                const Lines& lines, int input, pid_t supervisor, Outputs& outputs, SharedState& state) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != supervisor) end_process(internal_fault);
  ::setpgid(0, 0);
  told = &state;
  remember_terminals();
  if (const std::size_t columns = columns_of(STDOUT_FILENO); columns != 0)
    ::setenv("COLUMNS", std::to_string(columns).c_str(), 1);
  ::dup2(input, STDIN_FILENO);
  ::dup2(lines.out[1], STDOUT_FILENO);
  ::dup2(lines.errors_to_write(), STDERR_FILENO);
  std::vector<int> kept = outputs.descriptors();
  kept.push_back(lines.socket[1]);
  keep_descriptors(std::move(kept));
  OutputFile::use_prepared(outputs.prepared());
  outputs.forget();
  guard_confined();
  Confinement confinement;
  confinement.readable = readable;
  confinement.processor_seconds = options.time_limit();
  constexpr std::uint64_t mib = std::uint64_t{1} << 20, of_libraries = 1024, least_file = 64;
  if (work.memory_mib != 0 && work.memory_mib < UINT64_MAX / mib / 2)
    confinement.address_space_bytes = (work.memory_mib + work.memory_mib / 4 + of_libraries) * mib;
  confinement.file_bytes = std::max(work.output_bytes, least_file * mib);
  const std::string fault = confine(confinement, lines.socket[1]);
  if (!fault.empty()) {
    [[maybe_unused]] const ssize_t n = ::send(lines.socket[1], fault.data(), fault.size(), 0);
    end_process(cannot_start);
  }
  ::close(lines.socket[1]);
  constexpr unsigned usual_patience = 10;
  watch_calls(usual_patience);
}

/// The exit status; what went wrong is reported.
int conclude(const End& end, const SharedState& state, const UntrustedWork& work, Outputs& outputs, Reports& reports) {
  const Location where{work.programs.size() == 1 ? work.programs.front() : std::string()};
  const int status = state.status;
  switch (end.how) {
    case End::How::not_begun: reports.add("IG-0680", {}, {end.why}); return cannot_start;
    case End::How::refused: reports.add("IG-0681", where, {end.why}); return internal_fault;
    case End::How::over_limit: reports.add("IG-0682", where, {end.why}); return input_errors;
    case End::How::by_signal:
      if (end.signal == 0) reports.add("IG-0683", where, {"signal " + std::to_string(end.number) + " ended it"});
      return internal_fault;
    case End::How::by_itself: break;
  }
  if (status < success || status > internal_fault) {
    reports.add("IG-0683", where, {"it ended itself with status " + std::to_string(end.number)});
    return internal_fault;
  }
  int out = std::max(status, std::clamp<int>(end.number, success, internal_fault));
  // Whoever cannot start says why, unless a plugin has closed what it would be said to.
  if (out == cannot_start && !end.has_said && work.common.diagnostics_output.empty())
    reports.add("IG-0683", where, {"it ended with status " + std::to_string(out) + " and without a word"});
  if (!outputs.commit(end.lost_outputs, reports)) out = std::max<int>(out, cannot_start);
  if (!end.lost.empty()) {
    reports.add("IG-0511", {"standard output"}, {end.lost});
    out = std::max<int>(out, cannot_start);
  }
  return out;
}

/// Dies of a signal that it was sent, as a command without --untrusted does.
void die_of(int signal_number) {
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

std::optional<int> supervise(const UntrustedOptions& options, const UntrustedWork& work) {
  Reports reports(work.common);
  if (const std::string fault = fault_of_system(); !fault.empty()) {
    reports.add("IG-0680", {}, {fault});
    return cannot_start;
  }
  std::error_code code;
  for (const std::string& program : work.programs)
    if (program != "-" && fs::exists(program, code) && !fs::is_regular_file(program, code) &&
        !fs::is_directory(program, code)) {
      reports.add("IG-0685", {program}, {});
      return cannot_start;
    }
  void* const memory = ::mmap(nullptr, sizeof(SharedState), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  Lines lines;
  std::string fault;
  const bool reads_stdin = std::find(work.programs.begin(), work.programs.end(), "-") != work.programs.end();
  const int input = stdin_for_work(reads_stdin, fault);
  if (input < 0 || !fault.empty()) {
    reports.add("IG-0510", {"-"}, {fault});
    return cannot_start;
  }
  if (memory == MAP_FAILED || !lines.open()) {
    reports.add("IG-0680", {}, {std::strerror(errno)});
    return cannot_start;
  }
  if (!can_confine_reading()) reports.add("IG-0684", {}, {});
  auto* const state = new (memory) SharedState();
  auto outputs = std::make_unique<Outputs>(work.outputs, *state);
  const std::vector<std::string> readable = readable_by(work);
  const pid_t supervisor = ::getpid(), process = ::fork();
  if (process == 0) {
    begin_work(options, work, readable, lines, input, supervisor, *outputs, *state);
    return std::nullopt;
  }
  for (const int end : {lines.socket[1], lines.out[1], lines.errors[1], input})
    if (end >= 0) ::close(end);
  if (process < 0) {
    reports.add("IG-0680", {}, {std::strerror(errno)});
    return cannot_start;
  }
  outputs->close_writing_ends();
  watch_calls(0);
  const std::uint64_t printed = std::max(work.output_bytes, std::uint64_t{64} << 20);
  const End end = watch_over(process, {lines.socket[0], lines.out[0], lines.errors[0], outputs->handed_on()},
                             {options.time_limit(), work.memory_mib, printed, readable});
  const int status = conclude(end, *state, work, *outputs, reports);
  outputs.reset();
  if (end.signal != 0 && end.how != End::How::by_itself) die_of(end.signal);
  return status;
}

}  // namespace

}  // namespace sandbox

void UntrustedOptions::add_flag_to(CommandLine& line) {
  line.flag("--untrusted", on,
            "Run in a process that cannot write files, connect, start or signal others, whatever a program or plugin "
            "tries (Linux)")
      .group("Untrusted programs and plugins");
}

void UntrustedOptions::add_to(CommandLine& line) {
  add_flag_to(line);
  line.option("--max-time", seconds,
              fmt::format("With --untrusted: stop the work when it takes longer (0: never; {} if not given)",
                          usual_seconds))
      .type_name("SECONDS")
      .group("Untrusted programs and plugins");
}

void UntrustedWork::add_dialect(const std::string& dialect) {
  if (dialect.find('/') != std::string::npos || dialect.ends_with(".xml")) reads.push_back(dialect);
}

UntrustedWork untrusted_work(const CommonOptions& common, const std::string& dialect, const std::string& machine) {
  UntrustedWork out;
  out.common = common;
  out.reads.push_back(machine);
  out.add_dialect(dialect);
  out.outputs.push_back(common.diagnostics_output);
  return out;
}

UntrustedWork untrusted_work(const CommonOptions& common, const ProgramOptions& program) {
  UntrustedWork out = untrusted_work(common, program.dialect, program.machine);
  out.reads.insert(out.reads.end(), {program.offsets, program.tools, program.variables});
  out.reads.insert(out.reads.end(), program.subprograms.begin(), program.subprograms.end());
  return out;
}

std::string program_of_lines(const std::string& named) {
  std::error_code code;
  return std::filesystem::exists(named, code) ? named : named.substr(0, named.rfind(':'));
}

std::optional<int> enter_untrusted(const UntrustedOptions& options, const UntrustedWork& work) {
  if (options.on) return sandbox::supervise(options, work);
  if (!options.is_time_unused()) return std::nullopt;
  Session(work.common).report("IG-0513", {}, {"--max-time belongs to --untrusted"});
  return cannot_start;
}

void end_untrusted(int status) {
  if (sandbox::told != nullptr) sandbox::told->status = status;
}

}  // namespace isogloss::cli

#ifdef ISOGLOSS_SANITIZED
/// The search for leaks starts a process, which the one that works may not.
extern "C" [[gnu::visibility("default")]] int __lsan_is_turned_off() {
  return isogloss::cli::sandbox::told != nullptr ? 1 : 0;
}
#endif
