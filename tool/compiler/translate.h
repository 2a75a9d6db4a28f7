// Translation of one source: rewrites it and compiles it in symbolic mode.
#pragma once

#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"

namespace symreal::compiler {

struct Translation {
  Words compiler; // the host's C++ compiler
  Input source;
  Words roots;
  rewrite::Exclusion exclude;
  Action action; // other than link
  std::string output;
};

// Translates a source. Returns false without output after reporting errors.
bool translate(Translation const &translation, CommandLine const &line);

// Compiles a source that `translate` has preprocessed, here or on another machine.
bool compile_preprocessed(Translation const &translation, CommandLine const &line);

// Is this a text that `translate` has preprocessed?
bool is_symbolic(std::string const &preprocessed);

} // namespace symreal::compiler
