#include "sandbox/reading.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#if __has_include(<linux/landlock.h>)
#include <linux/landlock.h>
#endif

namespace isogloss::cli::sandbox {

namespace fs = std::filesystem;

namespace {

/// What the loader, the C library and the sanitizers open on their own.
constexpr const char* of_system[] = {"/lib",
                                     "/lib32",
                                     "/lib64",
                                     "/libx32",
                                     "/usr/lib",
                                     "/usr/lib32",
                                     "/usr/lib64",
                                     "/usr/libx32",
                                     "/usr/local/lib",
                                     "/etc/ld.so.cache",
                                     "/etc/localtime",
                                     "/usr/share/locale",
                                     "/usr/share/zoneinfo",
                                     "/proc/self",
                                     "/proc/meminfo",
                                     "/proc/cpuinfo",
                                     "/sys/devices/system/cpu",
                                     "/dev/null",
                                     "/dev/random",
                                     "/dev/urandom"};

/// The process's own folder of /proc, where the path goes through "self".
fs::path as_seen_by(pid_t process, const fs::path& path) {
  const fs::path self = "/proc/self";
  if (std::mismatch(self.begin(), self.end(), path.begin(), path.end()).first != self.end()) return path;
  return "/proc" / fs::path(std::to_string(process)) / path.lexically_relative(self);
}

}  // namespace

ReadablePlaces::ReadablePlaces(const std::vector<std::string>& readable, pid_t process) : process_(process) {
  std::error_code error;
  const auto add = [&](const std::string& path) {
    const fs::path real = fs::canonical(as_seen_by(process, path), error);
    if (!error) places_.push_back(real);
  };
  for (const char* const path : of_system) add(path);
  for (const std::string& path : readable) add(path);
}

std::string ReadablePlaces::elsewhere(int folder, const std::string& path) const {
  std::error_code error;
  fs::path whole = path;
  if (whole.is_relative()) {
    const std::string descriptor = folder == AT_FDCWD ? "cwd" : "fd/" + std::to_string(folder);
    whole = fs::read_symlink("/proc/" + std::to_string(process_) + "/" + descriptor, error) / whole;
  }
  const fs::path real = fs::canonical(as_seen_by(process_, whole.lexically_normal()), error);
  if (error) return {};
  for (const fs::path& place : places_)
    if (std::mismatch(place.begin(), place.end(), real.begin(), real.end()).first == place.end()) return {};
  return real.string();
}

#if defined(LANDLOCK_ACCESS_FS_READ_FILE) && defined(SYS_landlock_create_ruleset)

namespace {

/// What the first version of Landlock knows, so that any kernel with Landlock can do it. Writing is refused twice: here
/// and by the filter of calls.
constexpr std::uint64_t handled =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_READ_FILE |
    LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
    LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
    LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
    LANDLOCK_ACCESS_FS_MAKE_SYM;

bool allow_below(int rules, const char* path) {
  const int place = ::open(path, O_PATH | O_CLOEXEC);
  if (place < 0) return true;  // whoever needs it reports that it is not there
  struct stat info {};
  const bool is_folder = ::fstat(place, &info) == 0 && S_ISDIR(info.st_mode);
  landlock_path_beneath_attr rule{};
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  if (is_folder) rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
  rule.parent_fd = place;
  const long error = ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  ::close(place);
  return error == 0;
}

}  // namespace

bool can_confine_reading() {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
}

std::string confine_reading(const std::vector<std::string>& readable) {
  if (!can_confine_reading()) return {};
  landlock_ruleset_attr attributes{};
  attributes.handled_access_fs = handled;
  const int rules =
      static_cast<int>(::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0));
  bool is_confined = rules >= 0;
  for (const char* const path : of_system) is_confined = is_confined && allow_below(rules, path);
  for (const std::string& path : readable) is_confined = is_confined && allow_below(rules, path.c_str());
  is_confined = is_confined && ::syscall(SYS_landlock_restrict_self, rules, 0) == 0;
  const int error = errno;
  if (rules >= 0) ::close(rules);
  return is_confined ? "" : std::string("reading cannot be confined: ") + std::strerror(error);
}

#else

bool can_confine_reading() { return false; }
std::string confine_reading(const std::vector<std::string>&) { return {}; }

#endif

}  // namespace isogloss::cli::sandbox
