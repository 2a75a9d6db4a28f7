#include "program/build/process.h"

#include "engine/diagnostics/diagnostic.h"
#include "program/build/interruption.h"
#include "program/build/read_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <poll.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
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

// The file of a request, which has no name and lives as long as a process has it open; none for an empty request.
class RequestFile {
public:
  explicit RequestFile(wire::Request const &request) {
    if (request.is_empty()) return;
    std::string const content = request.content();
    descriptor_ = memfd_create("symreal-request", MFD_CLOEXEC);
    bool const is_written =
        descriptor_ >= 0 && write(descriptor_, content.data(), content.size()) == static_cast<ssize_t>(content.size());
    if (!is_written)
      fail(DiagnosticId::no_workspace, {}, "no file in memory can be made: " + std::string(std::strerror(errno)));
  }
  ~RequestFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  RequestFile(RequestFile const &) = delete;
  RequestFile &operator=(RequestFile const &) = delete;
  int descriptor() const { return descriptor_; }

private:
  int descriptor_ = -1;
};

// Data of the child, prepared before the fork: between fork and exec nothing may allocate, or change the parent's
// memory.
struct Prepared {
  std::vector<char *> arguments, environment;
  RequestFile request;
  std::string request_entry; // of the environment

  explicit Prepared(Command const &command)
      : request(command.request),
        request_entry(fmt::format("{}={}", wire::request_variable, request.descriptor())) {
    for (std::string const &word : command.arguments) arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    for (char **entry = environ; *entry; ++entry)
      if (!overridden(*entry, command)) environment.push_back(*entry);
    for (std::string const &entry : command.environment) environment.push_back(const_cast<char *>(entry.c_str()));
    if (request.descriptor() >= 0) environment.push_back(request_entry.data());
    environment.push_back(nullptr);
  }

private:
  static bool overridden(std::string_view entry, Command const &command) {
    std::string_view name = entry.substr(0, entry.find('=') + 1);
    if (name.starts_with(wire::request_variable)) return true; // one that this process was given
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
  if (prepared.request.descriptor() >= 0) fcntl(prepared.request.descriptor(), F_SETFD, 0);
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

// User and system time of a process and of the children that it has waited for.
double seconds_of(fs::path const &process) {
  std::ifstream in(process / "stat");
  std::string line;
  std::getline(in, line);
  std::size_t const name_end = line.rfind(')'); // the program's name may contain blanks
  if (name_end == line.npos) return 0;
  std::istringstream rest(line.substr(name_end + 1));
  constexpr int before = 11; // fields between the name and the times
  std::string passed;
  for (int i = 0; i < before; ++i) rest >> passed;
  double ticks = 0;
  for (int i = 0; i < 4; ++i) {
    double one = 0;
    rest >> one;
    ticks += one;
  }
  return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::size_t memory_of(fs::path const &process) {
  std::ifstream in(process / "status");
  for (std::string word; in >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && in >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

// Processor time and memory used by a process group, including ended processes that another one of the group has waited
// for. Read from /proc.
struct GroupUse {
  double seconds = 0;
  std::size_t most_memory = 0; // in bytes, of the largest process
};

GroupUse use_of_group(pid_t group) {
  GroupUse use;
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    std::string const name = at->path().filename().string();
    pid_t process = 0;
    std::from_chars(name.data(), name.data() + name.size(), process);
    if (process == 0 || getpgid(process) != group) continue;
    use.seconds += seconds_of(at->path());
    use.most_memory = std::max(use.most_memory, memory_of(at->path()));
  }
  return use;
}

// Limits of a process group: times, and the caller's wish.
class Limits {
public:
  Limits(Command const &command, pid_t group, Clock::time_point start)
      : group_(group),
        start_(start),
        seconds_(command.time_limit),
        stop_(command.stop),
        processor_(command.processor_limit) {}

  bool any() const { return seconds_ > 0 || stop_ >= 0 || processor_.seconds > 0; }
  int stop() const { return stop_; }

  // Milliseconds until the next check, -1 without limits; nullopt if the group must end.
  std::optional<int> hold() {
    constexpr double most = 1e6; // largest timeout that poll() takes
    double left = most;
    if (seconds_ > 0) left = std::min(left, seconds_ - seconds_since(start_));
    if (left <= 0) return ended_by(Ending::timed_out);
    if (pollfd wish = {stop_, POLLIN, 0}; stop_ >= 0 && poll(&wish, 1, 0) > 0) return ended_by(Ending::stopped);
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
  int const stop_;
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
    std::array<pollfd, 2> wanted = {{{descriptor, POLLIN, 0}, {limits.stop(), POLLIN, 0}}}; // poll skips -1
    int ready = poll(wanted.data(), wanted.size(), *wait);
    if (ready < 0 && errno != EINTR) return true;
    if (ready <= 0 || wanted[0].revents == 0) continue;
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
  // vfork copies no page tables, which are large while syntax trees are in memory.
  pid_t child = output.read_end < 0 || failure.read_end < 0 ? -1 : vfork();
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
  if (opened) opened->serve();
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

std::string shell_line(std::vector<std::string> const &arguments) {
  std::string line;
  for (std::string const &word : arguments) {
    if (!line.empty()) line += ' ';
    bool plain =
        !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                                "_-+=./,:@%") == word.npos;
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  bool inside = false; // inside a word, possibly an empty one ('')
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    bool blank = quote == 0 && (c == ' ' || c == '\t' || c == '\n');
    if (blank) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    bool escapes =
        c == '\\' && quote != '\'' && i + 1 < text.size() && (quote == 0 || text[i + 1] == '"' || text[i + 1] == '\\');
    if (escapes)
      words.back() += text[++i];
    else if (quote != 0 && c == quote)
      quote = 0;
    else if (quote == 0 && (c == '\'' || c == '"'))
      quote = c;
    else
      words.back() += c;
  }
  if (quote != 0) fail(DiagnosticId::bad_option, {}, "a quote is not closed in '" + std::string(text) + "'");
  return words;
}

} // namespace symreal::program
