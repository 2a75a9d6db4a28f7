// One source: rewritten, and compiled in symbolic mode.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"

namespace symreal::compiler {

struct Translation {
  Words compiler; // the host's, of C++
  Input source;
  Words roots;
  rewrite::Exclusion exclude;
  Action action; // not link
  std::string output;
};

// Whether it went well; else all is reported, and there is no output.
bool translate(Translation const &translation, CommandLine const &line);

// The same for what `translate` has preprocessed before, by itself or on another machine.
bool compile_preprocessed(Translation const &translation, CommandLine const &line);

// Is this a text that `translate` has preprocessed?
bool is_symbolic(std::string const &preprocessed);

} // namespace symreal::compiler
