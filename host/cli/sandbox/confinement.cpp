#include "sandbox/confinement.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

#ifdef ISOGLOSS_SECCOMP
#include <linux/seccomp.h>
#include <seccomp.h>
#endif

namespace isogloss::cli::sandbox {

namespace {

std::string error_of(const char* what, int number) { return std::string(what) + ": " + std::strerror(number); }

std::string limit(const Confinement& confinement) {
  // What the caller has limited further stays so.
  const auto set = [](auto resource, rlim_t soft, rlim_t hard) {
    struct rlimit value {};
    if (::getrlimit(resource, &value) != 0) return false;
    value = {std::min(soft, value.rlim_cur), std::min(hard, value.rlim_max)};
    return ::setrlimit(resource, &value) == 0;
  };
  // No dump of memory: 0 would allow one to a program that takes dumps, 1 does not.
  bool is_set = set(RLIMIT_CORE, 1, 1);
  constexpr rlim_t most_files = 256;
  is_set = set(RLIMIT_NOFILE, most_files, most_files) && is_set;
  if (confinement.processor_seconds != 0)
    is_set = set(RLIMIT_CPU, confinement.processor_seconds, confinement.processor_seconds + 2) && is_set;
  if (confinement.file_bytes != 0) is_set = set(RLIMIT_FSIZE, confinement.file_bytes, confinement.file_bytes) && is_set;
// AddressSanitizer reserves terabytes.
#ifndef ISOGLOSS_SANITIZED
  if (confinement.address_space_bytes != 0)
    is_set = set(RLIMIT_AS, confinement.address_space_bytes, confinement.address_space_bytes) && is_set;
#endif
  return is_set ? "" : error_of("its limits cannot be set", errno);
}

}  // namespace

#ifdef ISOGLOSS_SECCOMP

namespace {

/// Calls that change nothing outside the process, whatever their arguments are. Some of them the C library makes on its
/// own, at times that nobody can foretell.
constexpr const char* harmless[] = {
    // of what is open already
    "read", "readv", "pread64", "preadv", "preadv2", "write", "writev", "close", "lseek", "_llseek", "fstat", "fstat64",
    "ftruncate", "ftruncate64", "fsync", "fdatasync", "fadvise64", "fadvise64_64", "readahead", "getdents",
    "getdents64", "dup", "dup2", "dup3", "poll", "ppoll", "select", "pselect6", "fstatfs", "fstatfs64",
    // of names, without opening them
    "stat", "stat64", "lstat", "lstat64", "newfstatat", "fstatat64", "statx", "access", "faccessat", "faccessat2",
    "readlink", "readlinkat", "getcwd", "statfs", "statfs64",
    // memory
    "brk", "munmap", "mremap", "mprotect", "madvise", "mincore", "membarrier", "get_mempolicy",
    // its own signals, threads and clocks
    "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigreturn", "rt_sigpending", "rt_sigtimedwait", "rt_sigsuspend",
    "sigaltstack", "pause", "restart_syscall", "futex", "futex_waitv", "set_robust_list", "get_robust_list",
    "set_tid_address", "rseq", "sched_yield", "sched_getaffinity", "sched_getparam", "sched_getscheduler", "nanosleep",
    "clock_nanosleep", "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "setitimer", "getitimer",
    "alarm", "exit", "exit_group",
    // questions
    "getpid", "getppid", "gettid", "getpgrp", "getpgid", "getsid", "getuid", "geteuid", "getgid", "getegid",
    "getresuid", "getresgid", "getgroups", "getrusage", "getrlimit", "ugetrlimit", "uname", "sysinfo", "getcpu",
    "getrandom"};

/// The rules of one process.
class Rules {
 public:
  Rules() : context_(seccomp_init(SCMP_ACT_NOTIFY), seccomp_release) {
    // Calls by the numbers of another architecture have other meanings.
    if (context_ != nullptr) seccomp_attr_set(context_.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  }

  template <class... Comparisons>
  void allow(const char* call, const Comparisons&... comparisons) {
    add(SCMP_ACT_ALLOW, call, comparisons...);
  }
  template <class... Comparisons>
  void add(std::uint32_t action, const char* call, const Comparisons&... comparisons) {
    if (context_ == nullptr) return;
    const int number = seccomp_syscall_resolve_name(call);
    if (number < 0) return;  // this architecture has no such call
    const int error = seccomp_rule_add(context_.get(), action, number, sizeof...(comparisons), comparisons...);
    if (error != 0) fault_ = error_of(call, -error);
  }
  /// The descriptor that tells which call is refused.
  int load(std::string& fault) {
    if (context_ == nullptr) fault_ = "no memory for its rules";
    const int error = fault_.empty() ? seccomp_load(context_.get()) : 0;
    if (error != 0) fault_ = error_of("the filter cannot be loaded", -error);
    fault = fault_;
    return fault.empty() ? seccomp_notify_fd(context_.get()) : -1;
  }

 private:
  std::unique_ptr<void, void (*)(scmp_filter_ctx)> context_;
  std::string fault_;
};

#define ISOGLOSS_IS(argument, value) \
  scmp_arg_cmp { argument, SCMP_CMP_EQ, static_cast<scmp_datum_t>(value), 0 }
#define ISOGLOSS_BITS_ARE(argument, mask, value) \
  scmp_arg_cmp { argument, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(mask), static_cast<scmp_datum_t>(value) }

void allow_threads(Rules& rules) {
  constexpr auto others = static_cast<unsigned>(CLONE_NEWNS | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER |
                                                CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWCGROUP | CLONE_PTRACE);
  rules.allow("clone", ISOGLOSS_BITS_ARE(0, others | CLONE_THREAD, CLONE_THREAD));
  // Its flags lie in memory, where no filter sees them; the C library then uses clone.
  rules.add(SCMP_ACT_ERRNO(ENOSYS), "clone3");
}

/// What no call of open has that only reads.
constexpr auto bits_of_writing = static_cast<unsigned>(O_ACCMODE | O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY));

/// Memory that is shared without a file stays when it is let go of in one place, and nobody counts it.
void allow_memory(Rules& rules) {
  for (const char* const call : {"mmap", "mmap2"}) {
    rules.allow(call, ISOGLOSS_BITS_ARE(3, MAP_TYPE, MAP_PRIVATE));
    rules.allow(call, ISOGLOSS_BITS_ARE(3, MAP_TYPE | MAP_ANONYMOUS, MAP_SHARED));
  }
}

void allow_with_arguments(Rules& rules, int socket) {
  // Where the kernel confines reading, the one who watches looks at each file that is opened, to report what it
  // refuses.
  if (!can_confine_reading()) {
    rules.allow("open", ISOGLOSS_BITS_ARE(1, bits_of_writing, O_RDONLY));
    rules.allow("openat", ISOGLOSS_BITS_ARE(2, bits_of_writing, O_RDONLY));
  }
  for (const char* const call : {"fcntl", "fcntl64"})
    for (const int command : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL})
      rules.allow(call, ISOGLOSS_IS(1, command));
  for (const auto request : {TCGETS, TIOCGWINSZ}) rules.allow("ioctl", ISOGLOSS_IS(1, request));
  // Asked, not set.
  rules.allow("prlimit64", ISOGLOSS_IS(2, 0));
  rules.allow("prctl", ISOGLOSS_IS(0, PR_SET_NAME));
  // Of its own threads: the one that reads ahead leaves the processor of the run.
  rules.allow("sched_setaffinity", ISOGLOSS_IS(0, 0));
  rules.allow("kill", ISOGLOSS_IS(0, ::getpid()));
  rules.allow("tgkill", ISOGLOSS_IS(0, ::getpid()));
#ifdef ISOGLOSS_SANITIZED
  // UndefinedBehaviorSanitizer asks with a pipe whether memory can be read.
  for (const char* const call : {"pipe", "pipe2"}) rules.allow(call);
#endif
  // For the one message below: afterwards the process has no socket any more, and can make none.
  rules.allow("sendmsg", ISOGLOSS_IS(0, socket));
}

#undef ISOGLOSS_IS
#undef ISOGLOSS_BITS_ARE

std::string send_descriptor(int socket, int descriptor) {
  char byte = '+';
  iovec part{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof descriptor)] = {};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  return ::sendmsg(socket, &message, 0) == 1 ? "" : error_of("the watch over it cannot begin", errno);
}

/// Which argument of a call is a path; -1: none.
int path_argument(std::string_view call) {
  for (const std::string_view at_folder : {"openat", "openat2", "unlinkat", "mkdirat", "mknodat", "renameat",
                                           "renameat2", "linkat", "fchmodat", "fchownat", "utimensat", "execveat"})
    if (call == at_folder) return 1;
  for (const std::string_view first : {"open", "creat", "unlink", "mkdir", "rmdir", "mknod", "rename", "link", "chmod",
                                       "chown", "lchown", "truncate", "execve", "chdir", "chroot", "utime", "utimes"})
    if (call == first) return 0;
  return -1;
}

std::string text_at(pid_t process, std::uint64_t address) {
  const std::string memory = "/proc/" + std::to_string(process) + "/mem";
  const int descriptor = ::open(memory.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  char text[512];
  ssize_t size = ::pread(descriptor, text, sizeof text, static_cast<off_t>(address));
  // The text may stand at the end of the memory that can be read.
  if (size < 0) {
    const std::uint64_t page = 4096;
    size = ::pread(descriptor, text, std::min<std::uint64_t>(sizeof text, page - address % page),
                   static_cast<off_t>(address));
  }
  ::close(descriptor);
  return size <= 0 ? std::string() : std::string(text, ::strnlen(text, static_cast<std::size_t>(size)));
}

}  // namespace

std::string fault_of_system() {
  constexpr unsigned with_listener = 5;
  return seccomp_api_get() >= with_listener ? "" : "the kernel has no seccomp filter with a listener (Linux 5.0)";
}

std::string confine(const Confinement& confinement, int socket) {
  if (std::string fault = limit(confinement); !fault.empty()) return fault;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return error_of("PR_SET_NO_NEW_PRIVS", errno);
  if (std::string fault = confine_reading(confinement.readable); !fault.empty()) return fault;
  Rules rules;
  for (const char* const call : harmless) rules.allow(call);
  allow_threads(rules);
  allow_memory(rules);
  allow_with_arguments(rules, socket);
  std::string fault;
  const int listener = rules.load(fault);
  if (!fault.empty()) return fault;
  fault = send_descriptor(socket, listener);
  ::close(listener);
  return fault;
}

std::string refused_call(int listener, pid_t process, const ReadablePlaces& places) {
  seccomp_notif* request = nullptr;
  seccomp_notif_resp* response = nullptr;
  if (seccomp_notify_alloc(&request, &response) != 0) return "a call";
  std::string out;
  if (seccomp_notify_receive(listener, request) == 0) {
    const seccomp_data& data = request->data;
    const std::unique_ptr<char, void (*)(void*)> name(seccomp_syscall_resolve_num_arch(data.arch, data.nr), std::free);
    out = name != nullptr ? name.get() : "call number " + std::to_string(data.nr);
    const int argument = path_argument(out);
    std::string path = argument >= 0 ? text_at(process, data.args[argument]) : std::string();
    const bool is_open = out == "open" || out == "openat";
    if (is_open && can_confine_reading() && (data.args[argument + 1] & bits_of_writing) == O_RDONLY) {
      path = places.elsewhere(argument == 0 ? AT_FDCWD : static_cast<int>(data.args[0]), path);
      // Landlock decides; this is only what it would tell. The loader looks for libraries in many places.
      if (path.empty() || path.find(".so") != std::string::npos) {
        response->id = request->id;
        response->flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
        seccomp_notify_respond(listener, response);
        out.clear();
      }
    }
    if (!out.empty() && !path.empty()) out += " (" + path + ")";
  }
  seccomp_notify_free(request, response);
  return out;
}

#else

std::string fault_of_system() { return "this isogloss was built without libseccomp"; }
std::string confine(const Confinement&, int) { return fault_of_system(); }
std::string refused_call(int, pid_t, const ReadablePlaces&) { return {}; }

#endif

}  // namespace isogloss::cli::sandbox
