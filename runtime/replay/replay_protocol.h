// Protocol between the replay program and its client.
//
//   server ──0──▶ client: the program has reached the kernel
//   client ──command──▶ server: fork; the fork runs the kernel on the inputs in shared memory and ends ──status──▶
//   client
//
// A fork that has run the kernel answers itself, goes back to the state in which it began (runtime/memory/rollback.h),
// and takes the next command, as long as the kernel calls the system for nothing: so all that a run has left is memory.
// A run that calls the system, or does not end well, is given up and made again in a fork of its own.
//
// The generated code and the recorded graph of a kernel with external functions run here as well, each in a fork, so
// that both call the program's own functions in the state in which the kernel finds them. For differences and dual
// numbers a fork answers a sequence of function calls: the client sends the number of a function, four bytes, until it
// sends `no_function`.
//
// The request (runtime/wire/request.h) names the shared file, two descriptors and the kernel, with external functions
// the generated code and the graph, and where the client may ask for state that no clause names (unnamed_state.h) the
// variables that the sources may change:
//   replay=<file>,<commands>,<answers>
// An answer is the status of the fork as waitpid gives it, four bytes. When the commands end, so does the server.
#pragma once

#include "engine/graph/evaluate.h"
#include "runtime/memory/memory_image.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace symreal::replay {

// State of a fork. `inside`: the first call's inputs are given, and none of its outputs is read yet.
enum class State : std::uint32_t { begun, inside, left, complete, wrong_shape };

enum class Command : char { none = 0, original = 'o', generated = 'c', graph = 'g', functions = 'f' };
inline constexpr std::uint32_t no_function = ~std::uint32_t{0};

// Value of outputs that are not inputs before a later call, so that an output left unwritten shows.
inline constexpr double spoilt_output = -7654.321;

// Change that the original's kernel has left in memory that outlives it and is not an output.
struct LeftBehind {
  std::uint64_t size, first, end; // of the object, and of the bytes in it that changed
  std::uint64_t now;              // hash of the changed bytes
  memory::Region region;
  char name[183]; // linker name, truncated
  bool operator==(LeftBehind const &other) const {
    return size == other.size && first == other.first && end == other.end && now == other.now &&
           std::string_view(name) == other.name;
  }
};

// Time limit for the repeated runs of the original that search for state that no clause names.
inline constexpr unsigned most_seconds_examined = 30;

// An object that no clause names and that holds state of the original's kernel, at the bytes from `first`.
struct UnnamedObject {
  LeftBehind object;
  std::uint64_t instruction; // the first to access it, relative to the load base
  std::uint32_t is_read;     // the outputs depend on it; else it is overwritten
  std::uint32_t unused;
};

// An effect of the original's kernel outside of the program, in words; for a function whose result comes from there,
// its name.
enum class Outside : std::uint8_t { passes, lasts, result };
struct OutsideEffect {
  Outside kind;
  char what[183];
};

// The head of the shared file. As doubles follow: the inputs, the parameters and the outputs of each call in a row; for
// each input the output that is the same number, or -1; inputs and outputs of the generated code, which may have
// derivatives; arguments and results of a call.
struct Head {
  std::uint32_t input_count, parameter_count, output_count;
  std::uint32_t seconds; // after which a sample is given up
  State state;
  std::uint32_t constant_count, guard_count; // of the generated code
  std::int32_t failed;                       // return value of the generated code
  std::uint32_t failing_guard;               // of the graph: the first that does not hold
  Premises premises;
  Command command; // which is not answered yet
  std::uint32_t left_count;
  std::uint32_t most_calls; // of the kernel in a row, each on the state that the one before it has left
  std::uint32_t calls_wanted, calls_done;
  std::uint32_t code_input_count, code_output_count;
  std::uint32_t most_arguments, most_results; // of a function
  std::uint64_t stack[16]; // of a program that counts its branches: where the kernel begins, see Memory::stack
  LeftBehind left[16];
  std::uint64_t returned;      // a hash of the non-numeric parts of the object that the first call returns
  std::uint32_t watches_world; // the client wants to know the effects
  std::uint32_t effect_count;
  std::uint32_t keeps_formats; // of the standard streams, which the kernel is known to read
  OutsideEffect effects[8];
  std::uint32_t examines; // the client asks for state that no clause names
  std::uint32_t unnamed_count;
  UnnamedObject unnamed[8];
  char unexamined[96]; // why the search was incomplete; empty if it was complete
};
static_assert(sizeof(Head) % sizeof(double) == 0);

inline std::size_t shared_size(Head const &head) {
  std::size_t const calls = std::size_t{head.input_count} + head.parameter_count + head.output_count;
  std::size_t const code = std::size_t{head.code_input_count} + head.code_output_count;
  std::size_t const call = std::size_t{head.most_arguments} + head.most_results;
  return sizeof(Head) + sizeof(double) * (calls * head.most_calls + head.input_count + code + call);
}
inline double *shared_inputs(Head *head, std::size_t call = 0) {
  return reinterpret_cast<double *>(head + 1) + call * head->input_count;
}
inline double *shared_parameters(Head *head, std::size_t call = 0) {
  return shared_inputs(head, head->most_calls) + call * head->parameter_count;
}
inline double *shared_outputs(Head *head, std::size_t call = 0) {
  return shared_parameters(head, head->most_calls) + call * head->output_count;
}
inline double *shared_links(Head *head) { return shared_outputs(head, head->most_calls); }
inline double *shared_code_inputs(Head *head) { return shared_links(head) + head->input_count; }
inline double *shared_code_outputs(Head *head) { return shared_code_inputs(head) + head->code_input_count; }
inline double *shared_arguments(Head *head) { return shared_code_outputs(head) + head->code_output_count; }
inline double *shared_results(Head *head) { return shared_arguments(head) + head->most_arguments; }

} // namespace symreal::replay
