// Events of a recording, which the symbolic program writes to the file `events`: one event a line, fields between tabs.
//
//   started     kernel
//   kernel      name  N.graph  output file
//   diagnostic  SYM0nn  file  line  column  message
//   warning     SYM0nn  file  line  column  message
//   located     SYM0nn  message  address,address,...
//   met         SYM0nn  message  address,address,...  count
//   frozen      kernel  name  place  values  address,address,...
//   scratch     name
//   clause      input, output, scratch or constant  name, name, ...
//   decision    count  condition  address,address,...   hexadecimal, relative to the load base, innermost first
//   carried     count  condition  address,address,...
//   settled     count  condition  address,address,...
//   decided     node  t, f or j  condition  address,address,...   decisions of the explored kernel, in order;
//                                                              T or F: assumed, without a path for the other outcome,
//                                                              which is an exact zero; Y or N: out of an input's range
//   joined      pieces  selects   for the last decision, a j: both its branches are recorded and have joined
//   in_vain     pieces  of a failed attempt at a join
//   join        address,address,...   decision whose branches join
//   followed    count   of decisions that earlier ones imply
//   beyond      count   of decisions beyond the depth, which are guards
//   undecided   K       number of a kernel with decisions to explore, in a run of its own
//   cut                 the kernel was left before its end
//
// Readers ignore other kinds of event.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/diagnostics/diagnostic.h"

namespace symreal::program {

// Arguments of clauses, by clause name.
using Clauses = std::map<std::string, std::string>;

struct RecordedKernel {
  std::string name, graph_file, output_file;
  std::string begun_as;             // name at its begin: a kernel in a block is named at its end
  std::vector<std::string> scratch; // static integers of functions; their last values are never read
  Clauses clauses = {};             // clauses that its pragma lacks; "elsewhere": names that no pragma there can use
};

// A diagnostic whose place is given by the program's call stack.
struct Located {
  DiagnosticId id;
  std::string message;
  std::vector<std::uint64_t> addresses;
  std::size_t count = 0; // occurrences there; 0: not counted
};

struct Decision {
  std::size_t count = 0;
  std::string condition;
  std::vector<std::uint64_t> addresses;
};

// A decision on an explored path.
struct DecidedEvent {
  std::uint32_t condition; // node of the condition
  bool outcome, is_assumed, is_joined, is_by_range;
  std::string text;
  std::vector<std::uint64_t> addresses;
};

// A decision whose two branches have joined.
struct JoinedEvent {
  std::size_t pieces, selects;
  std::size_t zeros, by_range; // conditions in the branches that were taken as not met
};

// State that a kernel reads, with the place of its first read.
struct FrozenRead {
  std::string kernel, name, place;
  std::vector<std::uint64_t> addresses;
};

struct Events {
  std::vector<std::string> started; // names of kernels that were begun
  std::vector<RecordedKernel> kernels;
  std::vector<Diagnostic> diagnostics;
  std::vector<Decision> decisions, carried, settled;
  std::vector<DecidedEvent> decided;
  std::vector<std::vector<std::uint64_t>> joined_at;
  std::vector<std::size_t> undecided; // numbers of kernels
  std::vector<JoinedEvent> joined;
  std::size_t followed = 0, beyond = 0, in_vain = 0;
  bool is_cut_off = false;
  std::vector<Located> located;
  std::vector<FrozenRead> frozen;
  std::vector<std::string> scratch; // of the kernel that has not ended yet
  Clauses clauses;                  // of the kernel that has not ended yet
};

// Reads events; empty if the file is missing.
Events read_events(std::string const &path);

// Call stack that a program ended by a signal left in the file `crash`, innermost first; empty if it left none.
std::vector<std::uint64_t> read_crash(std::string const &path);

} // namespace symreal::program
