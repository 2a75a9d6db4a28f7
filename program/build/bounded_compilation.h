// The compiler's work on a rewritten source, held against its work on the original. Each operation on a number is a
// decision and a call there, so a function that is large for the compiler is many times as large.
#pragma once

#include "program/build/process.h"
#include "rewrite/request/request.h"

#include <functional>

namespace symreal::program {

struct BoundedCompilation {
  Command usual;         // of the rewritten source
  Command unoptimised;   // the same without optimisation
  Command original;      // of the original, as it stands
  std::string source;    // in words
  bool is_large = false; // the source
  double reading = 0;    // seconds that it took to read it, as far as that is known
};

// In bytes. Where a smaller source is large for the compiler, its headers are.
inline constexpr std::size_t large_source = 12'000;

// How the compilations are run, and what is said to the user.
struct BoundedRun {
  std::function<Captured(Command const &)> compile, measure;
  std::function<void(std::string const &)> tell;
  rewrite::KeptTexts *kept = nullptr; // what was found out before; may be none
  std::string key;                    // of the source in it
};

// All that is tried together stays within ten times the processor time of the original's compilation and a second. The
// usual compilation of most sources is done in two seconds, or in three times what it took to read the source where its
// headers are large, and the original is not measured. Any other, and that of a large source after a second, waits
// there until the original has been compiled; then it gets the share that leaves
// enough for the one without optimisation, which takes its place, with a word about it. A small source may exceed the
// bound by some seconds; this is told as well.
Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run);

} // namespace symreal::program
