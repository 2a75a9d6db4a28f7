// Verification by samples: compares the original with the generated code and with the recorded rewritten text.
#pragma once

#include "program/build/branches.h"
#include "program/record/front.h"
#include "runtime/replay/boundaries.h"
#include "runtime/replay/compare.h"
#include "runtime/replay/samples.h"
#include "verify/exact_errors.h"
#include "verify/exact_values.h"
#include "verify/generated_code.h"

#include <map>
#include <memory>
#include <optional>

namespace symreal::program {

// The samples whose number, from 0, is `index` modulo `count`; `count` shards together cover all samples.
struct Shard {
  std::size_t index = 0, count = 1;
  bool has(std::size_t sample) const { return sample % count == index; }
};

struct VerificationOptions {
  std::size_t samples = 1000, min_samples = 100;
  std::uint64_t seed = 1;
  Shard shard = {};
  std::vector<Sample> given = {};    // samples in addition to the drawn ones
  std::vector<Sample> replayed = {}; // samples in place of the drawn ones, if any
  double tolerance = 1e-9;           // for mode fast and single precision
  std::string wrapper = {}; // program that tests its wrapper (program::build_wrapped); empty: no wrapper is verified
  bool branches = false;    // also count the branches of the original
  bool fork_each = false;   // no fork runs the original on several samples
  unsigned exact_bits = 0;  // also compare with exact values of this many bits; 0: do not
};

inline constexpr double single_tolerance = 1e-3; // default for single precision

// A guard of the generated code.
struct GuardCheck {
  std::string text;
  std::size_t failed = 0; // samples on which it is the first guard that does not hold
};

// A sample on which the generated code returned another guard than the original's decisions require.
struct GuardMismatch {
  std::size_t sample;
  std::string expected, found;
};

// Outcomes of a decision of the recorded graph, on samples inside and on samples that a guard refuses.
struct DecisionCoverage {
  std::string place;
  bool is_guards = false;
  DecisionCounts counts;
};

// An object that outlives the kernel, is not an output, and was changed by the original.
struct LeftState {
  std::string name;    // description
  std::size_t samples; // number of samples concerned
};

// Nanoseconds of an evaluation: medians over turns that alternate between one thread and all.
struct ThreadTimes {
  double alone = 0, together = 0;
  double gain = 0, low = 0, high = 0; // speedup in a turn: median and quartiles
  std::size_t turns = 0;
};

// Threads that share an evaluation.
struct ThreadResult {
  unsigned threads = 1;
  std::size_t different = 0;             // samples on which one thread computes other numbers or returns another guard
  std::optional<ThreadTimes> times = {}; // nullopt if the code calls functions of the program
};

// Verdict on one element of a derivative after the samples so far.
struct DerivativeElement {
  // Samples whose differences are sharp enough to judge by; samples that differ from those, or from dual numbers.
  std::size_t judged = 0, different = 0;
  // Worst error, as a fraction of the error allowed there; expected and found values; the reference that gave them.
  double error = 0, expected = 0, found = 0;
  bool is_by_differences = false;
  std::shared_ptr<Sample const> worst = {};
  // Samples on which it differs from the unoptimised formulas, which the mode promises to keep; the first such sample:
  std::size_t broken = 0;
  double promised = 0, given = 0;
  std::shared_ptr<Sample const> first_broken = {};
};

struct DerivativeResult {
  // Derivative objects, matrices in full even if stored packed; their slots follow the original's.
  std::vector<Object> objects;
  std::vector<DerivativeElement> elements;
  std::size_t tried = 0, promised = 0; // samples, and those on which the mode promises equal numbers
  std::size_t left_out = 0;            // samples that would have taken too long
  double tolerance = 0;
};

// An element with fewer judged samples (or fewer than half of those tried, if that is less) counts as unverified.
inline constexpr std::size_t least_judged = 10;

struct Verification {
  FloatingPoint mode = FloatingPoint::finite;
  bool is_single = false;                    // the code is in single precision (single_runs.h)
  bool has_values = true;                    // false: the code has derivatives alone
  double tolerance = 0;                      // tolerance of the comparison
  std::string mathematics;                   // the original's mathematical library; with shards, all their libraries
  std::size_t inside = 0;                    // samples that satisfy the premises of the mode and all guards
  std::size_t not_finite = 0, zero_sign = 0; // samples that violate a premise, by premise
  std::size_t undefined = 0;                 // samples on which the original is undefined in every mode
  std::vector<OutputComparison> outputs;     // per slot, over the samples inside
  // Distances per slot under the user's own flags, if these may change numbers, else empty: generated code against the
  // original built with them, and code built with them against the original.
  std::vector<std::uint64_t> own_flags_ulp, own_code_ulp;
  std::size_t outside_different = 0; // samples outside on which some output differs; not an error
  std::size_t graph_different = 0;   // samples inside on which the recorded graph itself differs from the original
  // In single precision: samples left out because single precision decides otherwise; and per slot, numbers left out
  // because single precision loses too much.
  std::size_t decided_otherwise = 0;
  std::vector<std::size_t> lost;
  std::size_t tried = 0;                   // samples
  std::size_t around = 0;                  // of these, samples at decision boundaries
  std::map<std::size_t, Sample> named;     // samples that other members refer to by number
  std::vector<DecisionCoverage> decisions; // of the recorded graph, unless it calls functions of the program
  std::size_t crossed = 0;                 // of these, decisions with samples on both sides
  std::optional<BranchResult> branches;    // of the original, if asked for
  std::vector<OutputComparison> rewritten; // per slot, the rewritten text against the original: must be bitwise equal
  std::vector<OutputComparison> called_again; // per slot, over the second and third of three consecutive calls
  // Per slot, the original on samples that a guard refuses: after a call within the guards against without one.
  std::vector<OutputComparison> called_beyond;
  std::vector<OutputComparison> wrapped; // per slot, the generated code by its wrapper against directly; or empty
  std::vector<LeftState> left, left_by_wrapper;
  // Objects that no clause names, examined on a few samples: `unnamed` ones change the original's outputs,
  // `overwritten` ones it overwrites with the bytes that they hold.
  std::vector<LeftState> unnamed, overwritten;
  std::string unexamined; // reason why the examination is incomplete; empty if it is complete
  // Effects of the original outside the program, described, on a few samples: lasting ones, and others.
  std::vector<LeftState> changes_outside, outside;
  std::size_t next_call_different = 0; // samples on which the program's own next call gives other outputs
  std::string next_call_ended;         // how the original ends within that call, where the first call returns; or empty
  std::string next_call_missed;        // reason why it is not compared, unless the program just ends before it
  std::vector<LeftState> missed_by_wrapper; // changed values that the wrapper misses, as words behind "the original"

  std::vector<GuardCheck> guards;              // of the generated code, in order
  std::size_t refused = 0;                     // samples within the premises on which a guard fails
  std::size_t guards_different = 0;            // samples on which the code returned another guard than it should
  std::optional<GuardMismatch> guard_mismatch; // the first such sample
  std::optional<ThreadResult> threads;         // if threads share an evaluation
  ExactJudgement exact;                        // in mode fast, for differences beyond the tolerance
  std::optional<ErrorResult> errors;           // against exact values, if asked for
  std::optional<DerivativeResult> derivatives; // if the code has derivatives
};

// Adds the results of other samples of the same kernel and file.
void join(Verification &verification, Verification const &other);

// Number of outputs that differ on some sample.
std::size_t count_different(std::vector<OutputComparison> const &outputs);

// `code` must belong to `recorded`; see require_match.
Verification verify(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                    Banner const &banner, VerificationOptions const &options);

// The kernel that the file's banner names. Throws foreign_file if no such kernel is recorded or its shape differs.
Recorded const &require_match(std::vector<Recorded> const &kernels, Banner const &banner, std::string const &path);

} // namespace symreal::program
