// Checks of verify. Each compares one property of the generated code, the wrapper or the original on the samples, and
// fills its members of the result. verification.cpp lists them.
#pragma once

#include "verify/later_calls.h"
#include "verify/single_runs.h"
#include "verify/verification.h"

#include <memory>

namespace symreal::program {

// The kernel, its generated code and the running original: what all checks share.
class Subject {
public:
  Subject(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
          Banner const &banner, VerificationOptions const &options);

  Front const &front;
  RunOptions const &run;
  Recorded const &recorded;
  std::string const &path;
  Banner const &banner;
  VerificationOptions const &options;

private:
  std::optional<Graph> completed_; // if the kernel calls functions of the program and has derivatives
  std::string changeable_;         // file with the names of the variables that the sources may change

public:
  Graph const &graph;
  GeneratedCode code;
  bool const in_program;     // the code calls functions of the program, so that a process of the original runs it
  std::vector<double> seeds; // of directional derivatives; the inputs of the generated code end with them
  std::string const &original_program;
  std::unique_ptr<Replay> original;
  LaterCalls later_calls;

  // Starts a program, `what` in diagnostics, that runs this kernel and `code` if given.
  std::unique_ptr<Replay> start(char const *what, std::string const &executable, GeneratedCode const *code = nullptr,
                                std::string const &profile = {}) const;
  std::vector<double> with_seeds(std::vector<double> inputs) const;
  // Is the original a program of its own, and not the rewritten one that records as well?
  bool has_original() const { return !front.original_program.empty(); }
  // Does the code decide exactly as the original does? Otherwise rounding moves the decision boundaries.
  bool is_exact() const { return banner.mode != FloatingPoint::fast && !banner.is_single; }
};

// A sample within the premises and all guards, and what ran on it.
struct CheckedSample {
  std::size_t number;
  Sample const &sample;
  std::vector<double> const &original;
  std::vector<double> const &generated; // the original's outputs if the code has derivatives alone
  std::span<double const> derivatives;  // stored by the generated code
  std::vector<double> const &recorded;  // outputs of the recorded graph
  std::vector<double> const &values;    // of its nodes; empty if the graph is evaluated in the program
  std::vector<LaterCall> const &later;  // calls of the original that followed in the same process
  std::uint64_t returned;               // hash of the non-numeric parts of the original's result
  std::vector<replay::LeftBehind> const &left_by_generated; // changes made by functions that the generated code calls
  SingleRuns const *single;                                 // in single precision
};

class Check {
public:
  virtual ~Check() = default;
  // Sees each sample on which the generated code ran, whether the original follows or not.
  virtual void see(Sample const &, GeneratedCode::Result const &) {}
  // Returns true if a member of the result refers to the sample.
  virtual bool compare(CheckedSample const &sample) = 0;
  virtual void finish() {}
};

// Each adds to `result`, and returns null where the options, the banner or the program leave nothing to check.
using MakeCheck = std::unique_ptr<Check>(Subject &subject, Verification &result);
MakeCheck check_derivatives, check_threads, check_left_state, check_outputs, check_later_calls, check_next_call,
    check_rewritten, check_own_flags, check_wrapper, check_unnamed_state, check_exact_errors, check_branches;

// State that several checks report.
void add_left(std::vector<LeftState> &all, std::string const &name);
std::string describe(replay::LeftBehind const &left);
bool contains(std::vector<replay::LeftBehind> const &all, replay::LeftBehind const &left);

bool all_same(std::vector<double> const &one, std::vector<double> const &other);
bool all_near(std::vector<double> const &one, std::vector<double> const &other, FloatingPoint mode, double tolerance);

// Adds a comparison of all outputs. Returns true if one is the worst so far.
bool compare_outputs(std::vector<OutputComparison> &outputs, std::size_t number, std::vector<double> const &wanted,
                     std::vector<double> const &found, FloatingPoint mode = FloatingPoint::strict,
                     double tolerance = 0);

} // namespace symreal::program
