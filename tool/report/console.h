// How a run talks to a person: progress on a terminal, diagnostics and the program's output on standard error.
#pragma once

#include "program/front.h"

#include <string>

namespace symreal::tool {

class Console {
public:
  Console();
  ~Console() { clear(); }
  Console(Console const &) = delete;
  Console &operator=(Console const &) = delete;

  // Bound to this console, which must outlive it.
  program::Talk talk();

  void stage(std::string_view name);
  void report(Diagnostic const &diagnostic);
  // A line to the user that is no diagnostic.
  void note(std::string const &text);
  // Wipes the progress line, before anything else is printed.
  void clear();

private:
  bool is_terminal_;
  bool line_shown_ = false;
};

} // namespace symreal::tool
