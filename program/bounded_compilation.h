// The compiler's work on a rewritten source, held against its work on the original. Each operation on a number is a
// decision and a call there, so a function that is large for the compiler is many times as large.
#pragma once

#include "program/process.h"
#include "rewrite/request/request.h"

#include <functional>

namespace symreal::program {

struct BoundedCompilation {
  Command usual;         // of the rewritten source
  Command unoptimised;   // the same without optimisation
  Command original;      // of the original, as it stands
  std::string source;    // in words
  bool is_large = false; // the source: to measure the original first costs less than to try in vain
};

// In bytes. Smaller sources are compiled in seconds.
inline constexpr std::size_t large_source = 12'000;

// How the compilations are run, and what is said to the user.
struct BoundedRun {
  std::function<Captured(Command const &)> compile, measure;
  std::function<void(std::string const &)> tell;
  rewrite::KeptTexts *kept = nullptr; // what was found out before; may be none
  std::string key;                    // of the source in it
};

// The usual compilation as long as it takes no more than ten times the processor time of the original's and a second,
// else that without optimisation, and a word about it. All that is tried together is to stay within that: of a large
// source the original is measured first, and the usual compilation gets the share that leaves enough for the other; of
// any other source the original is measured once the usual compilation has taken longer than most.
Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run);

} // namespace symreal::program
