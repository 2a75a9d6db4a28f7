// The front half of every run on sources, in three stages:
//
//   sources ──rewrite──▶ overlay ──build──▶ symbolic program ──run──▶ recorded graphs
//                           └─────build──▶ replay program
//           └──annotations alone────build──▶ original program (both for verification)
#pragma once

#include "program/build/branches.h"
#include "program/build/compile.h"
#include "program/record/record.h"

#include <functional>
#include <memory>
#include <optional>

namespace symreal::program {

struct FrontRequest {
  rewrite::Request source; // those that it excludes are compiled as they are
  BuildRequest build;      // the compiler and linking; the sources follow from the above
  RunOptions run;
  std::string kernel;                   // only this one; empty: all
  std::vector<std::string> called = {}; // only these, by name, if there are any: a driver program calls them
  bool keep = false;                    // leave the workspace
  bool replay = false;                  // build what verification runs too
  bool branches = false;                // with that: and what counts branches
};

// How a run talks to its user.
struct Talk {
  std::function<void(std::string_view stage)> stage;
  std::function<void(Diagnostic const &)> report;
  LineSink program_output;
  std::function<void(std::string const &)> note;
  // What the pragma of a kernel that was refused lacks; may be none.
  std::function<void(Recorded const &)> lacking = {};
};

struct Front {
  std::unique_ptr<Workspace> workspace; // holds the executables
  std::unique_ptr<Overlay> overlay;
  rewrite::Result rewritten;
  std::vector<rewrite::Kernel> wanted; // of the sources' kernels those that are asked for
  BuildRequest build;
  rewrite::Result annotated; // the original's text with its annotations, for verification
  std::string symbolic_program, replay_program;
  std::string original_program;       // empty for a main that was written by hand with REAL: the replay is its original
  std::vector<std::string> own_flags; // those of the user that may change the numbers
  std::string own_flags_program;      // empty when there are none
  CoveredProgram covered;             // where it was asked for
  std::vector<Recorded> kernels;      // at least one, names distinct
  std::vector<std::string> read;      // the files that it was made from
  double rewrite_seconds = 0, build_seconds = 0, run_seconds = 0;
};

// The stages: each goes on from the one before, and is false when an error was reported. They also throw
// DiagnosticError.
//
// Source to text with REAL in place of double.
bool rewrite_sources(FrontRequest const &request, Front &front, Talk const &talk);
// Text to programs: the symbolic one, and those that verification runs.
bool build_programs(FrontRequest const &request, Front &front, Talk const &talk);
// The symbolic program, run once, to graphs.
bool record_kernels(FrontRequest const &request, Front &front, Talk const &talk);

// What a recording of instructions needs of the machine and of the program. Throws oracle_not_possible.
void require_instructions(rewrite::Result const &annotated);

// How the front's programs run. Which kernel comes first is not known before the run, so one among several is waited
// for to the program's end.
RunOptions run_of(Front const &front, RunOptions run);

// All three. Nothing when an error was reported.
std::optional<Front> run_front(FrontRequest const &request, Talk const &talk);

} // namespace symreal::program
