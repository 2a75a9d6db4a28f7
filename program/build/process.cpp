#include "program/build/process.h"

#include "program/build/group_use.h"
#include "program/build/interruption.h"
#include "program/build/opened_files.h"
#include "program/build/read_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Pipe {
  int read_end = -1, write_end = -1;

  Pipe() {
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) == 0) read_end = ends[0], write_end = ends[1];
  }
  ~Pipe() { close_read(), close_write(); }
  Pipe(Pipe const &) = delete;
  Pipe &operator=(Pipe const &) = delete;
  void close_read() { close_end(read_end); }
  void close_write() { close_end(write_end); }

private:
  static void close_end(int &end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

// Data of the child, prepared before the fork: between fork and exec nothing may allocate.
struct Prepared {
  std::vector<char *> arguments, environment;

  explicit Prepared(Command const &command) {
    for (std::string const &word : command.arguments) arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    for (char **entry = environ; *entry; ++entry)
      if (!overridden(*entry, command)) environment.push_back(*entry);
    for (std::string const &entry : command.environment) environment.push_back(const_cast<char *>(entry.c_str()));
    environment.push_back(nullptr);
  }

private:
  static bool overridden(std::string_view entry, Command const &command) {
    std::string_view name = entry.substr(0, entry.find('=') + 1);
    for (std::string const &added : command.environment)
      if (std::string_view(added).starts_with(name)) return true;
    return false;
  }
};

[[noreturn]] void become(Command const &command, Prepared const &prepared, Pipe const &output, Pipe const &failure,
                         pid_t parent, OpenedFiles const *opened) {
  auto give_up = [&] {
    int reason = errno;
    if (write(failure.write_end, &reason, sizeof reason) < 0) _exit(126);
    _exit(127);
  };
  // Puts the child into its own process group, so that a time-out also ends its descendants; it dies with the tool.
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  if (!command.directory.empty() && chdir(command.directory.c_str()) != 0) give_up();
  int input = open(command.standard_input.empty() ? "/dev/null" : command.standard_input.c_str(), O_RDONLY);
  if (input < 0 || dup2(input, 0) < 0 || dup2(output.write_end, 1) < 0 || dup2(output.write_end, 2) < 0) give_up();
  // Fixes addresses, as stack contents may depend on them.
  if (command.at_fixed_addresses) personality(ADDR_NO_RANDOMIZE);
  for (int descriptor : command.inherited) fcntl(descriptor, F_SETFD, 0);
  signal(SIGPIPE, SIG_DFL);
  if (opened) opened->install();
  execvpe(prepared.arguments[0], prepared.arguments.data(), prepared.environment.data());
  give_up();
  std::abort();
}

// Cuts a stream into lines.
class Lines {
public:
  explicit Lines(LineSink const &sink) : sink_(sink) {}
  void add(std::string_view text) {
    for (std::size_t end; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
      rest_ += text.substr(0, end);
      sink_(rest_);
      rest_.clear();
    }
    rest_ += text;
  }
  void finish() {
    if (!rest_.empty()) sink_(rest_);
    rest_.clear();
  }

private:
  LineSink const &sink_;
  std::string rest_;
};

// Time limits of a process group.
class Limits {
public:
  Limits(Command const &command, pid_t group, Clock::time_point start)
      : group_(group),
        start_(start),
        seconds_(command.time_limit),
        processor_(command.processor_limit) {}

  bool any() const { return seconds_ > 0 || processor_.seconds > 0; }

  // Milliseconds until the next check, -1 without limits; nullopt if the group must end.
  std::optional<int> hold() {
    constexpr double most = 1e6; // largest timeout that poll() takes
    double left = most;
    if (seconds_ > 0) left = std::min(left, seconds_ - seconds_since(start_));
    if (left <= 0) return ended_by(Ending::timed_out);
    if (processor_.seconds > 0) {
      used_ = use_of_group(group_);
      if (processor_.seconds <= used_.seconds && processor_.further) ask();
      double const more = processor_.seconds - used_.seconds;
      if (more <= 0) return ended_by(Ending::over_limit);
      constexpr double least = 0.02;
      left = std::min(left, std::max(least, more / 2)); // several processes may use time at once
    }
    return any() ? static_cast<int>(left * 1000) + 1 : -1;
  }

  Ending ending() const { return ending_; }
  GroupUse const &used() const { return used_; }

private:
  void ask() {
    kill(-group_, SIGSTOP);
    processor_.seconds = std::exchange(processor_.further, {})();
    kill(-group_, SIGCONT);
  }
  std::optional<int> ended_by(Ending ending) {
    ending_ = ending;
    return {};
  }

  pid_t const group_;
  Clock::time_point const start_;
  double const seconds_;
  ProcessorLimit processor_;
  Ending ending_ = Ending::exited;
  GroupUse used_;
};

// Reads to the end of the stream; false if a limit came first.
bool read_to_end(int descriptor, Lines &lines, Limits &limits) {
  std::array<char, 8192> buffer;
  for (;;) {
    std::optional<int> const wait = limits.hold();
    if (!wait) return false;
    pollfd wanted = {descriptor, POLLIN, 0};
    int ready = poll(&wanted, 1, *wait);
    if (ready < 0 && errno != EINTR) return true;
    if (ready <= 0) continue;
    ssize_t got = read(descriptor, buffer.data(), buffer.size());
    if (got == 0 || (got < 0 && errno != EINTR)) return true;
    if (got > 0) lines.add({buffer.data(), static_cast<std::size_t>(got)});
  }
}

// Waits for the exit status; false if a limit came first (a process may close its output and run on).
bool wait_for(pid_t child, int &status, rusage &used, Limits &limits) {
  constexpr unsigned least = 2'000, most = 50'000; // microseconds between polls
  for (unsigned pause = least; limits.any(); pause = std::min(2 * pause, most)) {
    if (wait4(child, &status, WNOHANG, &used) == child) return true;
    if (!limits.hold()) return false;
    usleep(pause);
  }
  while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  return true;
}

} // namespace

Outcome run(Command const &command, LineSink const &sink) {
  auto start = Clock::now();
  Prepared prepared(command);
  Pipe output, failure;
  std::optional<OpenedFiles> opened;
  if (command.notes_opened) opened.emplace();
  pid_t parent = getpid();
  pid_t child = output.read_end < 0 || failure.read_end < 0 ? -1 : fork();
  if (child < 0) return {Ending::not_started, errno, 0};
  if (child == 0) become(command, prepared, output, failure, parent, opened ? &*opened : nullptr);
  setpgid(child, child);
  Doomed group(child); // the child and its descendants
  output.close_write();
  failure.close_write();

  int reason = 0;
  if (read(failure.read_end, &reason, sizeof reason) == sizeof reason) {
    group.spare();
    waitpid(child, nullptr, 0);
    return {Ending::not_started, reason, seconds_since(start)};
  }
  if (opened && !opened->serve(note_opened)) note_unseen();
  Lines lines(sink);
  int status = 0;
  rusage used = {};
  Limits limits(command, child, start);
  bool ended = read_to_end(output.read_end, lines, limits) && wait_for(child, status, used, limits);
  if (!ended) {
    kill(-child, SIGKILL);
    waitpid(child, &status, 0);
  }
  lines.finish();
  double seconds = seconds_since(start);
  if (!ended) return {limits.ending(), 0, seconds, limits.used().seconds, limits.used().most_memory};
  auto const in_seconds = [](timeval const &time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  double const processor = in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
  std::size_t const memory = static_cast<std::size_t>(used.ru_maxrss) * 1024;
  if (WIFSIGNALED(status)) return {Ending::signalled, WTERMSIG(status), seconds, processor, memory};
  return {Ending::exited, WEXITSTATUS(status), seconds, processor, memory};
}

Captured capture(Command const &command) {
  Captured captured;
  captured.outcome = run(command, [&](std::string_view line) { captured.output.append(line) += '\n'; });
  return captured;
}

} // namespace symreal::program
