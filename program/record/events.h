// What the symbolic program tells about its recording: the file `events`, one event a line, fields separated by tabs.
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
//   decided     node  t, f or j  condition  address,address,...   of the kernel that is explored, one after the other;
//                                                              T or F: assumed, without a path for the other outcome,
//                                                              which is an exact zero; Y or N: out of an input's range
//   joined      pieces  selects   of the last decision, a j: both its ways are recorded, and have come together
//   in_vain     pieces  whose ways did not come together
//   join        address,address,...   where ways part that come together
//   followed    count   of decisions that earlier ones settle
//   beyond      count   of decisions beyond the depth, which are guards
//   undecided   K       the K-th kernel has decisions to explore, in a run of its own
//   cut                 the kernel was left in its middle
//
// Other kinds of event are for other readers.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/diagnostics/diagnostic.h"

namespace symreal::program {

// By the names of clauses: what would stand in their parentheses.
using Clauses = std::map<std::string, std::string>;

struct RecordedKernel {
  std::string name, graph_file, output_file;
  std::string begun_as;             // a kernel in a block learns its name at its end
  std::vector<std::string> scratch; // static integers of functions in which nobody reads what is left
  Clauses clauses = {};             // that its pragma lacks; "elsewhere": what no pragma there can name
};

// A diagnostic whose place is where the program stood.
struct Located {
  DiagnosticId id;
  std::string message;
  std::vector<std::uint64_t> addresses;
  std::size_t count = 0; // how often it was met there; 0: nobody counted
};

struct Decision {
  std::size_t count = 0;
  std::string condition;
  std::vector<std::uint64_t> addresses;
};

// On an explored path.
struct DecidedEvent {
  std::uint32_t condition; // the node
  bool outcome, is_assumed, is_joined, is_by_range;
  std::string text;
  std::vector<std::uint64_t> addresses;
};

// Ways that have come together.
struct JoinedEvent {
  std::size_t pieces, selects;
  std::size_t zeros, by_range; // conditions in them that were taken as not met
};

// State that a kernel reads: where it was first read.
struct FrozenRead {
  std::string kernel, name, place;
  std::vector<std::uint64_t> addresses;
};

struct Events {
  std::vector<std::string> started; // kernels that were begun
  std::vector<RecordedKernel> kernels;
  std::vector<Diagnostic> diagnostics;
  std::vector<Decision> decisions, carried, settled;
  std::vector<DecidedEvent> decided;
  std::vector<std::vector<std::uint64_t>> joined_at;
  std::vector<std::size_t> undecided; // kernels, by number
  std::vector<JoinedEvent> joined;
  std::size_t followed = 0, beyond = 0, in_vain = 0;
  bool is_cut_off = false;
  std::vector<Located> located;
  std::vector<FrozenRead> frozen;
  std::vector<std::string> scratch; // of the kernel that has not ended yet
  Clauses clauses;                  // of the same
};

// A file that does not exist holds no events.
Events read_events(std::string const &path);

// What a program that was ended by a signal has left in the file `crash`: where it stood, innermost first. Empty where
// it has left nothing.
std::vector<std::uint64_t> read_crash(std::string const &path);

} // namespace symreal::program
