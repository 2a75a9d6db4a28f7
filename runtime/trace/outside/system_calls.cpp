#include "runtime/trace/outside/system_calls.h"

#if defined(__linux__) && defined(__x86_64__)

#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/outside/call_dispatch.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include <utility>

namespace symreal::trace {

namespace {

bool has_begun = false, is_watching = false, is_discarding = false;

// Noted in the handler, where nothing may be allocated.
struct Noted {
  long number;
  long file;     // a descriptor, or -1
  bool is_asked; // asks only, without a lasting effect
  char path[240];
};
Noted noted[32];
std::size_t noted_count = 0;

enum class Does { reads, writes, moves, opens, closes, asks, names, limits, maps, controls, other };
struct Call {
  long number;
  Does does;
  char const *what; // behind "the kernel"
  int path = -1;    // which argument is one
};

// Calls that concern the program alone. Every other one that no row names counts.
constexpr long harmless[] = {SYS_brk,
                             SYS_munmap,
                             SYS_mprotect,
                             SYS_mremap,
                             SYS_madvise,
                             SYS_futex,
                             SYS_rt_sigaction,
                             SYS_rt_sigprocmask,
                             SYS_rt_sigreturn,
                             SYS_sigaltstack,
                             SYS_sched_yield,
                             SYS_clock_gettime,
                             SYS_clock_getres,
                             SYS_gettimeofday,
                             SYS_time,
                             SYS_times,
                             SYS_getrusage,
                             SYS_getpid,
                             SYS_gettid,
                             SYS_getppid,
                             SYS_getuid,
                             SYS_geteuid,
                             SYS_getgid,
                             SYS_getegid,
                             SYS_uname,
                             SYS_sysinfo,
                             SYS_getrandom,
                             SYS_getrlimit,
                             SYS_fstat,
                             SYS_getdents64,
                             SYS_fadvise64,
                             SYS_poll,
                             SYS_select,
                             SYS_nanosleep,
                             SYS_clock_nanosleep,
                             SYS_sched_getaffinity,
                             SYS_getcpu,
                             SYS_set_robust_list,
                             SYS_rseq,
                             SYS_arch_prctl,
                             SYS_exit,
                             SYS_exit_group,
                             SYS_membarrier,
                             SYS_tgkill,
                             SYS_restart_syscall,
                             SYS_clone,
                             SYS_clone3,
                             SYS_fstatfs,
                             SYS_mlock,
                             SYS_mincore,
                             SYS_sched_getparam,
                             SYS_sched_getscheduler};
constexpr Call calls[] = {
    {SYS_read, Does::reads, "reads from"},
    {SYS_pread64, Does::reads, "reads from"},
    {SYS_readv, Does::reads, "reads from"},
    {SYS_stat, Does::asks, "looks at", 0},
    {SYS_lstat, Does::asks, "looks at", 0},
    {SYS_newfstatat, Does::asks, "looks at", 1},
    {SYS_statx, Does::asks, "looks at", 1},
    {SYS_access, Does::asks, "looks at", 0},
    {SYS_faccessat, Does::asks, "looks at", 1},
    {SYS_faccessat2, Does::asks, "looks at", 1},
    {SYS_readlink, Does::asks, "looks at", 0},
    {SYS_readlinkat, Does::asks, "looks at", 1},
    {SYS_statfs, Does::asks, "looks at", 0},
    {SYS_getcwd, Does::asks, "asks for the working directory"},
    {SYS_write, Does::writes, "writes to"},
    {SYS_pwrite64, Does::writes, "writes to"},
    {SYS_writev, Does::writes, "writes to"},
    {SYS_pwritev, Does::writes, "writes to"},
    {SYS_sendto, Does::writes, "writes to"},
    {SYS_sendmsg, Does::writes, "writes to"},
    {SYS_ftruncate, Does::writes, "truncates"},
    {SYS_lseek, Does::moves, "uses the position in"},
    {SYS_open, Does::opens, "opens", 0},
    {SYS_openat, Does::opens, "opens", 1},
    {SYS_close, Does::closes, "closes"},
    {SYS_creat, Does::names, "creates", 0},
    {SYS_truncate, Does::names, "truncates", 0},
    {SYS_unlink, Does::names, "removes", 0},
    {SYS_unlinkat, Does::names, "removes", 1},
    {SYS_rename, Does::names, "renames", 0},
    {SYS_renameat, Does::names, "renames", 1},
    {SYS_renameat2, Does::names, "renames", 1},
    {SYS_mkdir, Does::names, "makes the directory", 0},
    {SYS_mkdirat, Does::names, "makes the directory", 1},
    {SYS_rmdir, Does::names, "removes the directory", 0},
    {SYS_link, Does::names, "links", 0},
    {SYS_symlink, Does::names, "links", 1},
    {SYS_chmod, Does::names, "changes the permissions of", 0},
    {SYS_chdir, Does::names, "changes the working directory to", 0},
    {SYS_fork, Does::other, "starts a process"},
    {SYS_vfork, Does::other, "starts a process"},
    {SYS_execve, Does::other, "starts a program"},
    {SYS_wait4, Does::other, "waits for a process"},
    {SYS_kill, Does::other, "sends a signal"},
    {SYS_socket, Does::other, "opens a socket"},
    {SYS_umask, Does::other, "changes the mask of permissions"},
    {SYS_setitimer, Does::other, "sets a timer"},
    {SYS_alarm, Does::other, "sets a timer"},
    {SYS_prctl, Does::controls, "names its thread"},
    {SYS_prlimit64, Does::limits, "changes a limit of the process"},
    {SYS_mmap, Does::maps, "maps, so as to change it,"},
};

Call const *row_of(long number) {
  auto const *found = std::ranges::find(calls, number, &Call::number);
  return found == std::end(calls) ? nullptr : found;
}

// Descriptors that the kernel itself has opened.
constexpr long most_files = 1024;
bool is_own_file[most_files];

// The path of an open file, without allocation.
void path_of(long descriptor, char (&path)[240]) {
  char link[40] = "/proc/self/fd/";
  char digits[20];
  std::size_t count = 0, end = std::strlen(link);
  do digits[count++] = static_cast<char>('0' + descriptor % 10);
  while ((descriptor /= 10) > 0);
  while (count > 0) link[end++] = digits[--count];
  long const size = syscall(SYS_readlink, link, path, sizeof path - 1); // readlink() would notify the recording
  path[size > 0 ? size : 0] = 0;
}

// Whether the call does something that lasts, by its arguments.
bool lasts(Does does, long const (&arguments)[6]) {
  if (does == Does::limits) return arguments[2] != 0;
  if (does == Does::controls) return arguments[0] == PR_SET_NAME;
  if (does == Does::maps)
    return (arguments[3] & MAP_SHARED) != 0 && (arguments[3] & MAP_ANONYMOUS) == 0 && (arguments[2] & PROT_WRITE) != 0;
  return true;
}

// And no thread of this one.
bool starts_process(long number, long const (&arguments)[6]) {
  if (number == SYS_clone) return (arguments[0] & CLONE_THREAD) == 0;
  return number == SYS_clone3 && (*reinterpret_cast<std::uint64_t const *>(arguments[0]) & CLONE_THREAD) == 0;
}

// `closed`: the path of the file that the call has closed.
void note(long number, long const (&arguments)[6], long result, char const *closed) {
  if (starts_process(number, arguments)) number = SYS_fork;
  Call const *row = row_of(number);
  if (!row && std::ranges::find(harmless, number) != std::end(harmless)) return;
  Does const does = row ? row->does : Does::other;
  bool const is_opened = (does == Does::opens || number == SYS_creat) && result >= 0 && result < most_files;
  if (is_opened) is_own_file[result] = true;
  if (does == Does::closes && arguments[0] >= 0 && arguments[0] < most_files &&
      std::exchange(is_own_file[arguments[0]], false))
    return;
  if (!lasts(does, arguments)) return;
  Noted one{number, -1, does == Does::reads || does == Does::asks, {}};
  if (does == Does::opens) one.is_asked = (arguments[row->path + 1] & (O_WRONLY | O_RDWR | O_CREAT | O_TRUNC)) == 0;
  bool const is_own = arguments[0] >= 0 && arguments[0] < most_files && is_own_file[arguments[0]];
  if (does == Does::moves) one.is_asked = is_own || (arguments[1] == 0 && arguments[2] == SEEK_CUR);
  if (does == Does::reads || does == Does::writes || does == Does::moves) one.file = arguments[0];
  if (does == Does::maps) one.file = arguments[4];
  if (closed) std::memcpy(one.path, closed, sizeof one.path);
  if (row && row->path >= 0) {
    auto const *path = reinterpret_cast<char const *>(arguments[row->path]);
    for (std::size_t k = 0; path && path[k] && k + 1 < sizeof one.path; ++k) one.path[k] = path[k];
    if (one.path[0] == 0) return; // of a file that is open
  }
  for (std::size_t k = 0; k < noted_count; ++k)
    if (noted[k].number == number && noted[k].file == one.file && noted[k].is_asked == one.is_asked &&
        std::strcmp(noted[k].path, one.path) == 0)
      return;
  if (noted_count < std::size(noted)) noted[noted_count++] = one;
}

void keep_mask(sigset_t &mask) {
  bool const was_blocked = sigismember(&mask, SIGSYS) == 1; // as it is in the handler
  sigset_t now;
  sigprocmask(SIG_BLOCK, nullptr, &now);
  for (int signal = 1; signal < NSIG; ++signal) {
    bool const is_blocked = signal == SIGSYS ? was_blocked : sigismember(&now, signal) == 1;
    (void)(is_blocked ? sigaddset(&mask, signal) : sigdelset(&mask, signal));
  }
}

void on_call(int, siginfo_t *, void *context) {
  set_dispatch(false);
  auto &registers = static_cast<ucontext_t *>(context)->uc_mcontext.gregs;
  auto const [number, arguments] = call_in(registers);
  bool const is_own = memory::OwnWork::is_going_on();
  // A new thread or process goes on behind the call, on a stack that may be its own: the call is made again, unwatched.
  bool const is_copy = number == SYS_clone && (arguments[0] & CLONE_VM) == 0; // of the process
  if ((number == SYS_clone && !is_copy) || number == SYS_clone3 || number == SYS_vfork) {
    if (!is_own) note(number, arguments, 0, nullptr);
    registers[REG_RIP] -= 2;
    is_watching = false;
    return;
  }
  Call const *row = row_of(number);
  char closed[sizeof Noted::path];
  bool const is_closing = number == SYS_close;
  if (is_closing) path_of(arguments[0], closed);
  bool const is_dropped = is_discarding && !is_own && row && row->does == Does::writes;
  registers[REG_RAX] = is_dropped ? arguments[2] : carry_out(number, arguments);
  constexpr long last_error = -4095;
  bool const has_failed = registers[REG_RAX] < 0 && registers[REG_RAX] >= last_error;
  // When the handler returns, the signals that its context blocks are blocked.
  if (number == SYS_rt_sigprocmask && !has_failed) keep_mask(static_cast<ucontext_t *>(context)->uc_sigmask);
  if (!is_own && !has_failed) note(number, arguments, registers[REG_RAX], is_closing ? closed : nullptr);
  if ((is_copy || number == SYS_fork) && registers[REG_RAX] == 0) dispatch(); // the copy is not watched by itself
  set_dispatch(true);
}

// The action of each signal, and the blocked ones.
struct Signals {
  std::array<struct sigaction, NSIG> actions = {};
  sigset_t blocked = {};
};
Signals signals_before;

void read_signals(Signals &signals) {
  for (int number = 1; number < NSIG; ++number)
    sigaction(number, nullptr, &signals.actions[static_cast<std::size_t>(number)]);
  sigprocmask(SIG_BLOCK, nullptr, &signals.blocked);
}

// The recording has those that the processor raises for itself.
constexpr int own_signals[] = {SIGSYS, SIGFPE, SIGTRAP, SIGSEGV, SIGBUS, SIGILL};

void compare_signals(std::vector<Effect> &effects) {
  static Signals now;
  read_signals(now);
  for (int number = 1; number < NSIG; ++number) {
    if (std::ranges::find(own_signals, number) != std::end(own_signals)) continue;
    auto const at = static_cast<std::size_t>(number);
    if (now.actions[at].sa_handler != signals_before.actions[at].sa_handler)
      effects.push_back({Effect::Kind::changes, "changes what signal " + std::to_string(number) + " does"});
    if (sigismember(&now.blocked, number) != sigismember(&signals_before.blocked, number))
      effects.push_back({Effect::Kind::changes, "changes whether signal " + std::to_string(number) + " is blocked"});
  }
}

std::string in_quotes(std::string const &text) { return "'" + text + "'"; }

std::string name_of_file(long descriptor) {
  char path[256];
  ssize_t const size = readlink(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), path, sizeof path);
  return size > 0 ? in_quotes({path, static_cast<std::size_t>(size)}) : "file " + std::to_string(descriptor);
}

Effect effect_of(Noted const &one) {
  Call const *row = row_of(one.number);
  if (!row) return {Effect::Kind::changes, "makes system call " + std::to_string(one.number)};
  if (row->does == Does::writes && one.file == STDOUT_FILENO)
    return {Effect::Kind::prints, "writes to standard output"};
  if (row->does == Does::writes && one.file == STDERR_FILENO) return {Effect::Kind::prints, "writes to standard error"};
  std::string what = row->what;
  if (one.file >= 0) what += " " + name_of_file(one.file);
  if (row->path >= 0 || row->does == Does::closes) what += " " + in_quotes(one.path);
  return {one.is_asked ? Effect::Kind::asks : Effect::Kind::changes, what};
}

} // namespace

void watch_calls() {
  noted_count = 0;
  std::ranges::fill(is_own_file, false);
  read_signals(signals_before);
  has_begun = is_watching = begin_dispatch(on_call);
  set_dispatch(is_watching);
}

void end_calls(std::vector<Effect> &effects) {
  set_dispatch(false);
  is_watching = false;
  if (!std::exchange(has_begun, false)) return; // notes from before a thread began count
  end_dispatch();
  compare_signals(effects);
  for (std::size_t k = 0; k < noted_count; ++k) effects.push_back(effect_of(noted[k]));
}

void discard_output(bool discard) { is_discarding = discard; }

} // namespace symreal::trace

#else

namespace symreal::trace {

void watch_calls() {}
void end_calls(std::vector<Effect> &) {}
void discard_output(bool) {}

} // namespace symreal::trace

#endif
