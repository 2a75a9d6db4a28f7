// Front end of every run on sources, in three stages:
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
  rewrite::Request source; // excluded sources are compiled unchanged
  BuildRequest build;      // compilers and linking; its sources follow from `source`
  RunOptions run;
  std::string kernel;                     // record only these kernels, between commas; empty: all
  std::vector<std::string> called = {};   // record only these kernels, which a driver program calls; empty: all
  std::vector<std::string> verified = {}; // record only those of these kernels that exist; if none does, all
  bool keep = false;                      // keep the workspace
  bool replay = false;                    // also build the programs for verification
  bool branches = false;                  // with `replay`: also build the program that counts branches
};

// Callbacks by which a run reports to the user.
struct Talk {
  std::function<void(std::string_view stage)> stage;
  std::function<void(Diagnostic const &)> report;
  LineSink program_output;
  std::function<void(std::string const &)> note;
  // Reports a refused kernel whose pragma lacks clauses; may be null.
  std::function<void(Recorded const &)> lacking = {};
};

struct Front {
  std::unique_ptr<Workspace> workspace; // holds the executables
  std::unique_ptr<Overlay> overlay;
  rewrite::Result rewritten;
  std::vector<rewrite::Kernel> wanted; // requested kernels of the sources
  BuildRequest build;
  rewrite::Result annotated; // annotated text of the original, for verification
  std::string symbolic_program, replay_program;
  std::string original_program;       // empty if main is hand-written with REAL: the replay program is the original
  std::vector<std::string> own_flags; // the user's flags that may change numbers
  std::string own_flags_program;      // empty without such flags
  CoveredProgram covered;             // if requested
  std::vector<Recorded> kernels;      // at least one, names distinct
  std::vector<std::string> read;      // files that the graphs were made from
  double rewrite_seconds = 0, build_seconds = 0, run_seconds = 0;
};

// The stages, in order; each continues from the previous one, and returns false after reporting an error. They also
// throw DiagnosticError.
//
// Rewrites the sources: REAL replaces double.
bool rewrite_sources(FrontRequest const &request, Front &front, Talk const &talk);
// Builds the symbolic program and the programs for verification.
bool build_programs(FrontRequest const &request, Front &front, Talk const &talk);
// Runs the symbolic program once and reads the recorded graphs.
bool record_kernels(FrontRequest const &request, Front &front, Talk const &talk);

// Checks that machine and program permit recording from instructions. Throws oracle_not_possible.
void require_instructions(rewrite::Result const &annotated);

// Options for running the front's programs. A program that is written with REAL records kernels that are not wanted as
// well, in an order that is unknown before the run, and so runs to its end.
RunOptions run_of(Front const &front, RunOptions run);

// Runs all three stages. Nullopt after an error was reported.
std::optional<Front> run_front(FrontRequest const &request, Talk const &talk);

} // namespace symreal::program
