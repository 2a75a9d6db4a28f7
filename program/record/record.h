// Runs the symbolic program, once or once for each path, and gathers the kernels it records, or says why there are
// none.
#pragma once

#include "engine/graph/graph.h"
#include "program/build/overlay.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "program/record/events.h"
#include "program/record/explore.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace symreal::program {

// How the program is run, for recording and for verification alike.
struct RunOptions {
  std::vector<std::string> arguments;
  std::string directory;                                      // empty: the current one
  std::string standard_input;                                 // empty: none
  double time_limit = 60;                                     // seconds
  bool run_on = false;                                        // let the program go on to its own end
  std::string decisions = "error", floating_point = "finite"; // for the recording, as the options spell them
  std::string paths_met = {};                                 // a table of samples that choose the paths
  bool places = false;                                        // keep the source places of nodes
  bool from_instructions = false; // what runs is the original, whose instructions record themselves (oracle/)
};

// What the recorded call found in the values that it has baked in (rewrite/model/baked_values.h), as bits.
struct BakedObject {
  rewrite::Baked what; // with the shape of what counts
  std::vector<std::size_t> lengths;
  std::vector<unsigned long long> values;
};

struct Recorded {
  Graph graph;                                      // as recorded, no pass has run
  rewrite::Kernel kernel;                           // what the source says of it
  std::string output_file;                          // the name in generate, else empty
  std::string begun_as;                             // for replay: the name under which it begins
  std::vector<std::vector<Note>> frozen_reads = {}; // parallel to graph.frozen: where each was first read
  std::vector<std::string> scratch = {};            // static integers of functions, as in RecordedKernel
  Clauses clauses = {};                             // that its pragma lacks, as there
  std::vector<BakedObject> baked = {};              // where a wrapper needs them (program/wrapper/baked_values.h)
  std::optional<Exploration> exploration = {};      // of a kernel that decides, under policy explore
};

// What the kernel's pragma or call lacks, ready to be pasted, for the last of the diagnostics that ask for it.
Note clause_note(rewrite::Kernel const &kernel, Clauses const &clauses, std::string const &behind = {});

struct Recording {
  std::vector<Recorded> kernels;       // in the order of recording
  std::vector<Diagnostic> diagnostics; // of any severity
  double seconds = 0;
};

// `wanted`: the kernels that must be recorded; none: those that are, at least one. `sink` receives the program's
// output.
Recording record(std::string const &executable, RunOptions const &options, rewrite::Result const &rewritten,
                 std::vector<rewrite::Kernel> const &wanted, Overlay const &overlay, Workspace const &workspace,
                 LineSink const &sink);

} // namespace symreal::program
