// Console of a run: progress, diagnostics and the program's output, on standard error.
//
// On a terminal, a stage's counts (support/progress.h) and time are updated in one line; elsewhere they are printed as
// lines at intervals.
#pragma once

#include "program/record/front.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace symreal::tool {

class Console {
public:
  Console();
  ~Console();
  Console(Console const &) = delete;
  Console &operator=(Console const &) = delete;

  // Callbacks bound to this console, which must outlive them.
  program::Talk talk();

  // Ends the previous stage and begins another one.
  void stage(std::string_view name);
  void report(Diagnostic const &diagnostic);
  // Prints a line for the user that is not a diagnostic.
  void note(std::string const &text);
  // Ends the stage, before its result is printed.
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  void watch();
  void show();
  void wipe();
  void print_line(std::string const &line);

  bool is_terminal_;
  bool line_shown_ = false;
  std::chrono::duration<double> interval_; // interval between lines; 0: no lines
  std::mutex mutex_;                       // guards the members below and standard error
  std::condition_variable changed_;
  std::string stage_; // empty: no stage
  Clock::time_point begun_, next_;
  bool is_over_ = false;
  std::thread watcher_;
};

} // namespace symreal::tool
