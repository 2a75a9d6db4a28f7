// Recording: runs the symbolic program, once or for each path, and collects the kernels that it records, or explains
// why it records none.
#pragma once

#include "engine/graph/graph.h"
#include "program/build/overlay.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "program/record/events.h"
#include "program/record/explore.h"

#include <string>
#include <vector>

namespace symreal::program {

// Options for running the program, for recording and verification alike.
struct RunOptions {
  std::vector<std::string> arguments;
  std::string directory;                                      // empty: the current one
  std::string standard_input;                                 // empty: no input
  double time_limit = 60;                                     // seconds
  bool run_on = false;                                        // let the program run to its own end
  std::string decisions = "error", floating_point = "finite"; // for the recording, in the options' spelling
  std::string paths_met = {};                                 // table of samples that choose the paths
  bool places = false;                                        // keep the source places of nodes
  bool from_instructions = false; // the original runs, and its instructions record themselves (oracle/)
};

// Values that the recorded call baked in (rewrite/model/signature.h), as bits.
struct BakedObject {
  rewrite::Baked what; // with the shape of the compared parts
  std::vector<std::size_t> lengths;
  std::vector<unsigned long long> values;
};

struct Recorded {
  Graph graph;                                      // as recorded, before any pass
  rewrite::Kernel kernel;                           // the kernel in the source
  std::string output_file;                          // name given in `generate`, else empty
  std::string begun_as;                             // for replay: name at its begin
  std::vector<std::vector<Note>> frozen_reads = {}; // parallel to graph.frozen: place of the first read
  std::vector<std::string> scratch = {};            // static integers of functions, as in RecordedKernel
  Clauses clauses = {};                             // clauses that its pragma lacks, as in RecordedKernel
  std::vector<BakedObject> baked = {};              // if a wrapper needs them (program/wrapper/baked_values.h)
  std::optional<Exploration> exploration = {};      // of a kernel with decisions, under policy explore
};

// Clauses that the kernel's pragma or call lacks, ready to paste, as a note to the last diagnostic that asks for them.
Note clause_note(rewrite::Kernel const &kernel, Clauses const &clauses, std::string const &behind = {});

struct Recording {
  std::vector<Recorded> kernels;       // in the order of recording
  std::vector<Diagnostic> diagnostics; // of any severity
  double seconds = 0;
};

// Records the kernels. `wanted`: kernels that must be recorded; empty: at least one. `sink` receives the program's
// output.
Recording record(std::string const &executable, RunOptions const &options, rewrite::Result const &rewritten,
                 std::vector<rewrite::Kernel> const &wanted, Overlay const &overlay, Workspace const &workspace,
                 LineSink const &sink);

} // namespace symreal::program
