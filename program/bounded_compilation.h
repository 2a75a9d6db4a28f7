// The compiler's work on a rewritten source, held against its work on the original. Each operation on a number is a
// decision and a call there, so a function that is large for the compiler is many times as large.
#pragma once

#include "program/process.h"
#include "rewrite/request/request.h"

#include <functional>

namespace symreal::program {

struct BoundedCompilation {
  Command usual;       // of the rewritten source
  Command unoptimised; // the same without optimisation
  Command original;    // of the original, as it stands
  std::string source;  // in words
};

// How the compilations are run, and what is said to the user.
struct BoundedRun {
  std::function<Captured(Command const &)> compile, measure;
  std::function<void(std::string const &)> tell;
  rewrite::KeptTexts *kept = nullptr; // what was found out before; may be none
  std::string key;                    // of the source in it
};

// The usual compilation as long as it takes no more than ten times the processor time of the original's and a second,
// else that without optimisation, and a word about it. The original is compiled, to be measured, once the usual
// compilation has taken longer than most.
Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run);

} // namespace symreal::program
