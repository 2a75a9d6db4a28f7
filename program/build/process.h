// Runner of a single process without a shell: argument vector, directory, environment, standard input, limits. Standard
// output and error arrive as one stream of lines, in the order in which they were written.
#pragma once

#include "runtime/wire/request.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::program {

// Limit of the processor time of all processes of a command together.
struct ProcessorLimit {
  double seconds = 0;                   // 0: no limit
  std::function<double()> further = {}; // called once at the limit while they pause; returns the new limit
};

struct Command {
  std::vector<std::string> arguments;        // arguments[0] is looked up in PATH
  std::string directory = {};                // empty: the current one
  std::vector<std::string> environment = {}; // "NAME=value", added to the current one
  wire::Request request = {};                // to a program that is linked with the runtime
  std::string standard_input = {};           // a file; empty: no input
  double time_limit = 0;                     // seconds; 0: no limit
  ProcessorLimit processor_limit = {};
  bool at_fixed_addresses = false; // without address randomisation, if the system permits
  std::vector<int> inherited = {}; // descriptors inherited besides 0, 1 and 2
  int stop = -1;                   // a pipe's read end: once all write ends are closed, the processes are killed
  bool notes_opened = false;       // opened files are noted (read_files.h)
};

enum class Ending {
  exited,      // status is the exit status
  signalled,   // status is the signal
  timed_out,   // killed, with the processes it started
  over_limit,  // killed for exceeding the processor time
  stopped,     // killed as the caller wished
  not_started, // status is the errno
};

struct Outcome {
  Ending ending;
  int status = 0;
  double seconds = 0;
  double processor_seconds = 0; // of it and the processes that it waited for, unless it timed out
  std::size_t most_memory = 0;  // in bytes, of the largest process

  bool success() const { return ending == Ending::exited && status == 0; }
};

using LineSink = std::function<void(std::string_view line)>;

// Calls `sink` for every line of output, without its newline; the last line may lack one.
Outcome run(Command const &command, LineSink const &sink);

// Outcome and whole output of a command.
struct Captured {
  Outcome outcome;
  std::string output;
};
Captured capture(Command const &command);

// The command as a line to paste into a shell.
std::string shell_line(std::vector<std::string> const &arguments);

// Splits an option such as --run-args or --link into words: blanks separate; quotes and backslashes as in a POSIX
// shell.
std::vector<std::string> split_words(std::string_view text);

} // namespace symreal::program
