// Runs one process without a shell: argument vector, directory, environment, standard input, time limit. Standard
// output and standard error of the process arrive as one stream of lines, in the order in which they were written.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::program {

// A limit of the processor time that all processes of one command take together.
struct ProcessorLimit {
  double seconds = 0;                   // 0: none
  std::function<double()> further = {}; // asked once when it is reached, while they wait: the limit from there on
};

struct Command {
  std::vector<std::string> arguments;        // arguments[0] is looked up in PATH
  std::string directory = {};                // empty: the current one
  std::vector<std::string> environment = {}; // "NAME=value", added to the current one
  std::string standard_input = {};           // a file; empty: no input at all
  double time_limit = 0;                     // seconds; 0: none
  ProcessorLimit processor_limit = {};
  bool at_fixed_addresses = false; // where the system can do that
  std::vector<int> inherited = {}; // descriptors that stay open, with their numbers, besides 0, 1 and 2
  bool notes_opened = false;       // files that it opens are noted (read_files.h)
};

enum class Ending {
  exited,      // status is the exit status
  signalled,   // status is the signal
  timed_out,   // it and the processes it started were killed
  over_limit,  // the same, for their processor time
  not_started, // status is the errno that says why
};

struct Outcome {
  Ending ending;
  int status = 0;
  double seconds = 0;
  double processor_seconds = 0; // of it and of the processes that it waited for, unless it has timed out
  std::size_t most_memory = 0;  // in bytes, of the largest of them

  bool success() const { return ending == Ending::exited && status == 0; }
};

using LineSink = std::function<void(std::string_view line)>;

// Calls `sink` for every line of output, without its newline; a last line without newline counts as a line.
Outcome run(Command const &command, LineSink const &sink);

// The same with the output gathered.
struct Captured {
  Outcome outcome;
  std::string output;
};
Captured capture(Command const &command);

// The command as a line that can be pasted into a shell.
std::string shell_line(std::vector<std::string> const &arguments);

// Words of an option like --run-args or --link: separated by blanks; quotes and backslashes as in a POSIX shell.
std::vector<std::string> split_words(std::string_view text);

} // namespace symreal::program
