// The client of a replay program, that of the original or of the rewritten text: runs a kernel, in numbers, on inputs
// of our choice.
#pragma once

#include "graph/evaluate.h"
#include "program/generated_code.h"
#include "program/record.h"
#include "verify/replay_protocol.h"
#include "verify/samples.h"

#include <memory>
#include <string>

namespace symreal::program {

class Replay {
public:
  // Starts the program. `what` it is, in words; `begun_as`: the name under which the kernel begins.
  // With `code` it also runs that, and the graph, in the program. With `profile` the program counts its branches, and
  // writes them to that file when this ends; the kernel is called once then.
  Replay(std::string what, std::string const &executable, RunOptions const &options, std::string const &begun_as,
         Graph const &graph, Workspace const &workspace, GeneratedCode const *code = nullptr,
         std::string const &profile = {});
  ~Replay();
  Replay(Replay const &) = delete;
  Replay &operator=(Replay const &) = delete;

  // The outputs of the kernel. Throws replay_failed when the kernel does not end on this sample.
  std::vector<double> run(Sample const &sample);
  // Later calls of the kernel in a row, on the sample that it ran on last: each finds the state that the one before it
  // has left, and all other inputs as in the first. What another machine or kind of kernel cannot repeat has one call.
  std::size_t calls() const;
  std::vector<double> outputs_of(std::size_t call) const;
  // The inputs of the next call of code that gave these outputs.
  std::vector<double> next_inputs(Sample const &sample, std::vector<double> const &outputs) const;
  // What the kernel left, on the last sample that it ran on, in memory that outlives it and is no output; of the
  // original only.
  std::vector<replay::LeftBehind> left_behind() const;
  // `inputs`: all that the generated code has, also those that derivatives add.
  GeneratedCode::Result run_generated(Sample const &sample, std::span<double const> inputs);
  Evaluation run_graph(Sample const &sample);
  // Where the kernel begins, in a program that counts its branches: return addresses, innermost first, relative to
  // where it is loaded. Once a sample has run.
  std::vector<std::uint64_t> stack() const;
  // A function of the program, by its number in the graph. Calls in a row find the state that the one before it has
  // left.
  void call(std::size_t function, std::span<double const> arguments, std::span<double> results);

private:
  struct Server;
  void ask(replay::Command command, Sample const &sample);
  void send(void const *bytes, std::size_t size);
  void wait_for_answer();
  void end_calls();
  bool is_calling_ = false;
  std::string what_;
  std::unique_ptr<Server> server_;
  Place place_; // of the kernel, for diagnostics
};

} // namespace symreal::program
