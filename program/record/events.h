// Events of a recording (runtime/wire/event.def), read from the file `events`.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "runtime/wire/event.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

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

// State that a kernel reads, with the place of its first read.
using FrozenRead = wire::events::Frozen;

struct Events {
  std::vector<std::string> started; // names of kernels that were begun
  std::vector<RecordedKernel> kernels;
  std::vector<Diagnostic> diagnostics;
  std::vector<Decision> decisions, carried, settled;
  std::vector<DecidedEvent> decided;
  std::vector<std::vector<std::uint64_t>> joined_at;
  std::vector<std::size_t> undecided; // numbers of kernels
  std::vector<wire::events::Joined> joined;
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
