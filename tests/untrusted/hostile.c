/* A plugin that tries one thing which no plugin should: HOSTILE_DEED says which, HOSTILE_WHEN in which function, and
   HOSTILE_TARGET on what. It tells on standard error how it went. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../bad_plugins/sound.h"

static const char* target;

static int opened(int descriptor) {
  if (descriptor < 0) return -1;
  const ssize_t n = write(descriptor, "hostile\n", 8);
  close(descriptor);
  return n == 8 ? 0 : -1;
}

static int creates(void) { return opened(open(target, O_WRONLY | O_CREAT, 0600)); }
static int truncates(void) { return open(target, O_RDONLY | O_TRUNC) < 0 ? -1 : 0; }
static int writes_by_old_call(void) { return opened((int)syscall(SYS_creat, target, 0600)); }
static int makes_temporary(void) { return opened(open("/tmp", O_TMPFILE | O_RDWR, 0600)); }
static int removes(void) { return unlink(target); }
static int renames(void) {
  char other[4096];
  snprintf(other, sizeof other, "%s.hostile", target);
  return rename(target, other);
}
static int changes_mode(void) { return chmod(target, 0777); }
static int makes_link(void) {
  char other[4096];
  snprintf(other, sizeof other, "%s.hostile", target);
  return symlink(target, other);
}
static int connects_at(int family, const struct sockaddr* address, socklen_t size) {
  const int line = socket(family, SOCK_STREAM, 0);
  if (line < 0) return -1;
  const int done = connect(line, address, size) == 0 && write(line, "hostile\n", 8) == 8 ? 0 : -1;
  close(line);
  return done;
}
static int connects(void) {
  struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(target))};
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connects_at(AF_INET, (const struct sockaddr*)&address, sizeof address);
}
static int executes(void) { /* and is no more, where it succeeds */
  char script[5000];
  snprintf(script, sizeof script, "echo hostile > '%s'", target);
  char* const words[] = {"sh", "-c", script, NULL};
  execve("/bin/sh", words, environ);
  return -1;
}
static int starts(void) {
  char script[5000];
  snprintf(script, sizeof script, "echo hostile > '%s'", target);
  return system(script) == 0 ? 0 : -1;
}
static int forks(void) {
  const pid_t child = fork();
  /* The host reports a call of _exit(). */
  if (child == 0) syscall(SYS_exit_group, opened(open(target, O_WRONLY | O_CREAT, 0600)) == 0 ? 0 : 1);
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0 ? 0 : -1;
}
static int bombs(void) {
  for (;;)
    if (syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0) < 0) return -1;
}
static int kills_parent(void) { return kill(getppid(), SIGKILL); }
static int kills_group(void) { return kill(0, SIGKILL); }
static int kills_all(void) { return kill(-1, SIGKILL); }
static int kills_by_thread(void) { return (int)syscall(SYS_tgkill, getppid(), getppid(), SIGKILL); }
static int kills_by_descriptor(void) {
  const int process = (int)syscall(SYS_pidfd_open, getppid(), 0);
  return process < 0 ? -1 : (int)syscall(SYS_pidfd_send_signal, process, SIGKILL, NULL, 0);
}
static int traces_parent(void) { return ptrace(PTRACE_ATTACH, getppid(), NULL, NULL) == 0 ? 0 : -1; }
static int writes_parents_memory(void) {
  char byte = 0;
  struct iovec here = {&byte, 1}, there = {(void*)&target, 1};
  return process_vm_writev(getppid(), &here, 1, &there, 1, 0) == 1 ? 0 : -1;
}
static int writes_own_memory(void) { return open("/proc/self/mem", O_RDWR) < 0 ? -1 : 0; }
static int lifts_limits(void) {
  const struct rlimit none = {RLIM_INFINITY, RLIM_INFINITY};
  return setrlimit(RLIMIT_NOFILE, &none) == 0 || setrlimit(RLIMIT_FSIZE, &none) == 0 ? 0 : -1;
}
static int outlives_parent(void) { return prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0); }
static int sends_to_terminal(void) { return ioctl(STDIN_FILENO, TIOCSTI, "x"); }
static int unshares(void) { return unshare(CLONE_NEWUSER); }
static int mounts(void) { return mount("none", "/tmp", "tmpfs", 0, NULL); }
static int keeps_in_memory(void) { return opened((int)syscall(SYS_memfd_create, "hostile", 0)); }
static int shares_memory(void) { return shmget(IPC_PRIVATE, 4096, IPC_CREAT | 0600) < 0 ? -1 : 0; }
static int makes_ring(void) {
  char parameters[256] = {0};
  return syscall(SYS_io_uring_setup, 1, parameters) < 0 ? -1 : 0;
}
static int changes_flags_of_output(void) { return fcntl(STDOUT_FILENO, F_SETFL, O_APPEND); }
static int writes_inherited(void) { return write(atoi(target), "hostile\n", 8) == 8 ? 0 : -1; }
static int reads(void) {
  char text[64] = {0};
  const int descriptor = open(target, O_RDONLY);
  const ssize_t n = descriptor < 0 ? -1 : read(descriptor, text, sizeof text - 1);
  if (n > 0) fprintf(stderr, "hostile: read '%s'\n", text);
  return n > 0 ? 0 : -1;
}
static int calls_by_interrupt(void) {
#if defined(__x86_64__)
  long done;
  /* creat() of the calls of 32 bits, which have other numbers */
  __asm__ volatile("int $0x80" : "=a"(done) : "a"(8), "b"(0), "c"(0600) : "memory");
  return done < 0 ? -1 : 0;
#else
  return -1;
#endif
}
static int quits(void) { return (int)syscall(SYS_exit_group, 0); }
static int loops(void) {
  for (volatile int forever = 1; forever;) {
  }
  return 0;
}
static int loops_without_watch(void) {
  const struct itimerval none = {{0, 0}, {0, 0}};
  sigset_t all;
  setitimer(ITIMER_REAL, &none, NULL);
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, NULL);
  for (int number = 1; number < 32; ++number) signal(number, SIG_IGN);
  return loops();
}
static int sleeps(void) {
  const struct itimerval none = {{0, 0}, {0, 0}};
  setitimer(ITIMER_REAL, &none, NULL);
  fprintf(stderr, "hostile: sleeps\n");
  for (;;) pause();
}
static int naps(void) {
  usleep(500000);
  return 0;
}
static int stops_itself(void) { return kill(getpid(), SIGSTOP); }
static int closes_output(void) { return close(STDOUT_FILENO) + close(STDERR_FILENO); }
static int closes_output_and_loops(void) {
  close(STDOUT_FILENO);
  close(STDERR_FILENO);
  return loops_without_watch();
}
static int allocates(void) {
  for (;;) {
    const size_t size = (size_t)1 << 24;
    char* const memory = malloc(size);
    if (memory == NULL) {
      errno = ENOMEM;
      return -1;
    }
    memset(memory, 1, size);
  }
}
static void* wait_for_ever(void* nothing) {
  for (;;) pause();
  return nothing;
}
static int starts_threads(void) {
  for (int i = 0; i < 1000; ++i) {
    pthread_t thread;
    if (pthread_create(&thread, NULL, wait_for_ever, NULL) == 0) continue;
    if (i == 0) return -1;
    break;  // the stacks of a few hundred are more than the address space
  }
  sleep(5);
  return 0;
}
/* In the status of the process, its name stands before the number of its threads. */
static int hides_threads(void) {
  prctl(PR_SET_NAME, "Threads: 1", 0, 0, 0);
  return starts_threads();
}
static void* allocate(void* nothing) {
  allocates();
  sleep(5);
  return nothing;
}
/* A thread that has ended has no memory: the process looks as if it had none. */
static int ends_first_thread_and_allocates(void) {
  pthread_t thread;
  if (pthread_create(&thread, NULL, allocate, NULL) != 0) return -1;
  return (int)syscall(SYS_exit, 0);
}
static int shares_memory_without_a_file(void) {
  return mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? -1 : 0;
}
static int prints_without_end(void) {
  static char text[1 << 16];
  memset(text, 'x', sizeof text);
  for (;;)
    if (write(STDOUT_FILENO, text, sizeof text) < 0) return -1;
}
static int takes_hold_of_terminal(void) {
  static const char text[] =
      "\033]0;hostile\007\033[2J\xc2\x9b"
      "2J\rhostile\n";
  return write(STDERR_FILENO, text, sizeof text - 1) > 0 ? 0 : -1;
}

static int prints_a_result(void) { /* into every pipe that it finds; a bracket is printed a million times */
  static char many[1000000];
  for (int descriptor = 3; descriptor < 64; ++descriptor) {
    if (write(descriptor, target, 0) < 0) continue;
    for (const char* at = target; *at != 0; ++at) {
      const size_t count = *at == '[' || *at == ']' ? sizeof many : 1;
      memset(many, *at, count);
      write(descriptor, many, count);
    }
    write(descriptor, "\n", 1);
  }
  return 0;
}

static void* print(void* nothing) {
  prints_without_end();
  return nothing;
}
/* Whoever hands on what it prints waits for a reader. */
static int prints_and_allocates(void) {
  pthread_t thread;
  if (pthread_create(&thread, NULL, print, NULL) != 0) return -1;
  sleep(1);
  return allocates();
}
static int prints_many_names(void) { /* as a result, into every pipe that it finds */
  static char many[12000001];
  size_t size = 0;
  for (int i = 0; i < 1000000; ++i) size += (size_t)sprintf(many + size, "\"%d\":0,", i);
  many[size - 1] = '}';
  for (int descriptor = 3; descriptor < 64; ++descriptor)
    if (write(descriptor, "{\"Summary\":{", 12) == 12) {
      for (size_t at = 0; at < size;) {
        const ssize_t n = write(descriptor, many + at, size - at);
        if (n <= 0) break;
        at += (size_t)n;
      }
      static const char rest[] = ",\"First\":null,\"Called\":[],\"Places\":[]}\n";
      if (write(descriptor, rest, sizeof rest - 1) < 0) return -1;
    }
  return 0;
}

static const struct {
  const char* name;
  int (*act)(void);
} deeds[] = {
#define DEED(name) \
  { #name, name }
    DEED(creates),
    DEED(truncates),
    DEED(writes_by_old_call),
    DEED(makes_temporary),
    DEED(removes),
    DEED(renames),
    DEED(changes_mode),
    DEED(makes_link),
    DEED(connects),
    DEED(executes),
    DEED(starts),
    DEED(forks),
    DEED(bombs),
    DEED(kills_parent),
    DEED(kills_group),
    DEED(kills_all),
    DEED(kills_by_thread),
    DEED(kills_by_descriptor),
    DEED(traces_parent),
    DEED(writes_parents_memory),
    DEED(writes_own_memory),
    DEED(lifts_limits),
    DEED(outlives_parent),
    DEED(sends_to_terminal),
    DEED(unshares),
    DEED(mounts),
    DEED(keeps_in_memory),
    DEED(shares_memory),
    DEED(makes_ring),
    DEED(changes_flags_of_output),
    DEED(writes_inherited),
    DEED(reads),
    DEED(calls_by_interrupt),
    DEED(quits),
    DEED(loops),
    DEED(loops_without_watch),
    DEED(sleeps),
    DEED(naps),
    DEED(stops_itself),
    DEED(closes_output),
    DEED(closes_output_and_loops),
    DEED(allocates),
    DEED(starts_threads),
    DEED(hides_threads),
    DEED(ends_first_thread_and_allocates),
    DEED(shares_memory_without_a_file),
    DEED(prints_without_end),
    DEED(prints_and_allocates),
    DEED(prints_many_names),
    DEED(takes_hold_of_terminal),
    DEED(prints_a_result),
};

static void act(const char* now) {
  const char* const deed = getenv("HOSTILE_DEED");
  const char* const when = getenv("HOSTILE_WHEN");
  if (deed == NULL || when == NULL || strcmp(when, now) != 0) return;
  target = getenv("HOSTILE_TARGET");
  for (size_t i = 0; i < sizeof deeds / sizeof *deeds; ++i) {
    if (strcmp(deeds[i].name, deed) != 0) continue;
    errno = 0;
    const int done = deeds[i].act();
    fprintf(stderr, "hostile: %s %s (%s)\n", deed, done == 0 ? "succeeded" : "failed", strerror(errno));
    return;
  }
  fprintf(stderr, "hostile: no deed %s\n", deed);
}

__attribute__((constructor)) static void at_load(void) { act("load"); }

static ig_status create(const ig_link_api* api, ig_link* link, const ig_field* ids, void** self) {
  act("create");
  return sound_create(api, link, ids, self);
}
static void destroy(void* self) {
  act("destroy");
  sound_destroy(self);
}
static ig_status build(void* self, const ig_host* host, ig_block* block) {
  act("build");
  return sound_build(self, host, block);
}

static ig_syntax syntax = SOUND_SYNTAX;
static const ig_syntax* const syntaxes[] = {&syntax};
static const ig_plugin plugin = SOUND_PLUGIN("hostile", syntaxes);

const ig_plugin* ig_plugin_v1(void) {
  act("entry");
  syntax.create = create;
  syntax.destroy = destroy;
  syntax.build = build;
  return &plugin;
}
