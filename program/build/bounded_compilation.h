// Compilation of a rewritten source within a bound relative to the original's compilation. Each operation on a number
// is a decision and a call there, so a source that is large for the compiler grows many times.
#pragma once

#include "program/build/process.h"
#include "rewrite/request/request.h"

#include <functional>

namespace symreal::program {

struct BoundedCompilation {
  Command usual;         // command for the rewritten source
  Command unoptimised;   // the same command without optimisation
  Command original;      // command for the unchanged original
  std::string source;    // name of the source in messages
  bool is_large = false; // the source itself is large
  double reading = 0;    // seconds that the rewriter took to read it; 0 if unknown
};

// Size in bytes from which a source is large. A smaller source may still be slow to compile because of its headers.
inline constexpr std::size_t large_source = 12'000;

// Callbacks that run the compilations and inform the user.
struct BoundedRun {
  std::function<Captured(Command const &)> compile, measure;
  std::function<void(std::string const &)> tell;
  rewrite::KeptTexts *kept = nullptr; // results of earlier runs; may be null
  std::string key;                    // key of the source in `kept`
};

// Compiles within ten times the processor time of the original's compilation plus one second. Most sources finish
// within two seconds, or three times their reading time if their headers are large; then the original is not measured.
// Otherwise (a large source: after one second) the compilation pauses while the original is compiled, and resumes with
// a share that leaves time for an unoptimised compilation, which replaces it, with a note, once the share is spent. A
// small source may exceed the bound by some seconds, also with a note.
Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run);

} // namespace symreal::program
