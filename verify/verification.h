// The proof by samples: the original against the generated code, and against the rewritten text that was recorded.
#pragma once

#include "program/build/branches.h"
#include "program/record/front.h"
#include "runtime/replay/compare.h"
#include "runtime/replay/decisions.h"
#include "runtime/replay/samples.h"
#include "verify/derivative_verification.h"
#include "verify/exact_errors.h"
#include "verify/exact_values.h"
#include "verify/generated_code.h"
#include "verify/thread_verification.h"

#include <map>

namespace symreal::program {

// The samples whose number, from 0, is `index` modulo `count`: so many runs try all of them together.
struct Shard {
  std::size_t index = 0, count = 1;
  bool has(std::size_t sample) const { return sample % count == index; }
};

struct VerificationOptions {
  std::size_t samples = 1000, min_samples = 100;
  std::uint64_t seed = 1;
  Shard shard = {};
  std::vector<Sample> given = {};    // besides those that are drawn
  std::vector<Sample> replayed = {}; // in place of those that are drawn, if there are any
  double tolerance = 1e-9;           // mode fast, and single precision
  bool wrapper = false;              // also what its wrapper does; the kernel has its baked values then
  bool branches = false;             // also count the branches of the original
  unsigned exact_bits = 0;           // also compare with exact values, of so many bits
};

inline constexpr double single_tolerance = 1e-3; // of single precision, unless another is asked for

// A guard of the generated code.
struct GuardCheck {
  std::string text;
  std::size_t failed = 0; // samples on which it is the first that does not hold
};

// A sample on which the generated code returned another guard than the original's decisions ask for.
struct GuardMismatch {
  std::size_t sample;
  std::string expected, found;
};

// How often a decision of the recorded graph was met on the samples inside, and on those that a guard refuses.
struct DecisionCoverage {
  std::string place;
  bool is_guards = false;
  DecisionCounts counts;
};

// An object that outlives the kernel, that the original leaves changed, and that is no output.
struct LeftState {
  std::string name;    // in words
  std::size_t samples; // on which it is
};

struct Verification {
  FloatingPoint mode = FloatingPoint::finite;
  bool is_single = false;                    // of code in single precision, see single_runs.h
  bool has_values = true;                    // otherwise the code has derivatives alone
  double tolerance = 0;                      // that it was compared with
  std::string mathematics;                   // the mathematical library of the original; of shards, all of them
  std::size_t inside = 0;                    // samples that satisfy the premises of the mode and all guards
  std::size_t not_finite = 0, zero_sign = 0; // and those that do not, by premise
  std::size_t undefined = 0;                 // samples on which the original has no meaning, in no mode
  std::vector<OutputComparison> outputs;     // per slot, over the samples inside
  // With the user's own flags, where these may change the numbers, per slot: the generated code against the original
  // that has them, and the code that has them against the original. Else empty.
  std::vector<std::uint64_t> own_flags_ulp, own_code_ulp;
  std::size_t outside_different = 0; // samples outside that differ in some output, not an error
  std::size_t graph_different = 0;   // samples inside on which the recorded graph itself differs from the original
  // Of code in single precision: samples that were left out because single precision decides otherwise, and numbers,
  // per slot, that were because it loses too much.
  std::size_t decided_otherwise = 0;
  std::vector<std::size_t> lost;
  std::size_t tried = 0;                   // samples
  std::size_t around = 0;                  // of these, at the boundaries of decisions
  std::map<std::size_t, Sample> named;     // those that other members name by their number
  std::vector<DecisionCoverage> decisions; // of the recorded graph, but of one that calls functions of the program
  std::size_t crossed = 0;                 // of these, that samples stand on both sides of
  std::optional<BranchResult> branches;    // of the original, where they were asked for
  std::vector<OutputComparison> rewritten; // per slot, the rewritten text against the original: equal to the last bit
  std::vector<OutputComparison> called_again; // per slot, over the second and third of three calls in a row
  // Per slot, of the original on samples that a guard refuses: behind a call within the guards against alone.
  std::vector<OutputComparison> called_beyond;
  std::vector<OutputComparison> wrapped; // per slot, the generated code behind its wrapper against itself; or empty
  std::vector<LeftState> left, left_by_wrapper;
  // Objects that no clause names, on a few samples: the outputs of the original depend on them, or it overwrites them
  // with the bytes that they hold.
  std::vector<LeftState> unnamed, overwritten;
  std::string unexamined; // why not all was tried; empty if it was
  // Effects of the original outside of the program, in words, on a few samples: those that last, and others.
  std::vector<LeftState> changes_outside, outside;
  std::size_t next_call_different = 0;      // samples on which the program's own next call gives something else
  std::vector<LeftState> missed_by_wrapper; // where it gives other results than the original, behind "the original"

  std::vector<GuardCheck> guards;              // of the generated code, in order
  std::size_t refused = 0;                     // samples within the premises on which one does not hold
  std::size_t guards_different = 0;            // samples on which the code decided otherwise than it should
  std::optional<GuardMismatch> guard_mismatch; // the first of them
  std::optional<ThreadResult> threads;         // of code whose threads share an evaluation
  ExactJudgement exact;                        // of mode fast, beyond the tolerance
  std::optional<ErrorResult> errors;           // against exact values, where they were asked for
  std::optional<DerivativeResult> derivatives; // of code that has some
};

// Adds what other samples of the same kernel and file have shown.
void join(Verification &verification, Verification const &other);

// Outputs that differ on some sample.
std::size_t count_different(std::vector<OutputComparison> const &outputs);

// `code` must belong to `recorded`; see require_match.
Verification verify(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                    Banner const &banner, VerificationOptions const &options);

// The kernel that the file says it was generated from. Throws foreign_file when there is none or its shape differs.
Recorded const &require_match(std::vector<Recorded> const &kernels, Banner const &banner, std::string const &path);

} // namespace symreal::program
