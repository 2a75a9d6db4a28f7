// Client of a replay program (the original's or the rewritten text's): runs a kernel numerically on chosen inputs.
#pragma once

#include "engine/graph/evaluate.h"
#include "program/record/record.h"
#include "runtime/replay/replay_protocol.h"
#include "runtime/replay/samples.h"
#include "verify/generated_code.h"

#include <memory>
#include <optional>
#include <string>

namespace symreal::program {

class Replay {
public:
  // Starts the program. `what`: its description; `begun_as`: the name under which the kernel begins. With `code` it can
  // also run that code and the graph. With `profile` it counts branches and writes the counts to that file when this
  // object is destroyed; the kernel is then called once per sample. `request`: further entries of the request.
  Replay(std::string what, std::string const &executable, RunOptions const &options, std::string const &begun_as,
         Graph const &graph, Workspace const &workspace, GeneratedCode const *code = nullptr,
         std::string const &profile = {}, wire::Request request = {});
  ~Replay();
  Replay(Replay const &) = delete;
  Replay &operator=(Replay const &) = delete;

  // Waits until the program reaches the kernel, at most so many seconds. Tells if it does not.
  std::optional<Outcome> miss(unsigned seconds);
  // State of the last run, which tells more about one that has failed.
  replay::State state() const;
  // Runs the kernel and returns its outputs. Throws replay_failed if the kernel does not end on this sample. `later`:
  // further calls in a row, at most `most_later`; each finds the state that the call before left and its own sample in
  // all other inputs. Without support for repeated calls only the first is made. `seconds`: a shorter time limit than
  // the program's; 0: the program's. The first few runs of the original also report its effects outside the program.
  static constexpr std::size_t most_later = 2;
  std::vector<double> run(Sample const &sample, std::span<Sample const> later = {}, unsigned seconds = 0);
  std::size_t calls() const;
  std::vector<double> outputs_of(std::size_t call) const;
  // Inputs of a later call on `sample`, after a call of code that gave these outputs. Requires that a sample has run.
  std::vector<double> next_inputs(Sample const &sample, std::span<double const> outputs) const;
  bool has_run() const { return has_run_; }
  // Changes that the original's kernel left, on the last sample it ran on, in memory that outlives it and is not an
  // output.
  std::vector<replay::LeftBehind> left_behind() const;
  std::vector<replay::OutsideEffect> effects() const;
  // State of the original that no clause names, on this sample: found by rerunning the kernel with other bytes in the
  // memory that it reads.
  std::vector<replay::UnnamedObject> examine(Sample const &sample);
  std::string unexamined() const; // reason why the examination is incomplete; empty if it is complete
  // Hash of the non-numeric parts of the returned object, which entry `returned` of the request describes.
  std::uint64_t returned() const;
  // `inputs`: all inputs of the generated code, including those that derivatives add.
  GeneratedCode::Result run_generated(Sample const &sample, std::span<double const> inputs);
  Evaluation run_graph(Sample const &sample);
  // Call stack at the kernel's begin in a program that counts its branches: return addresses relative to the load base,
  // innermost first. Requires that a sample has run.
  std::vector<std::uint64_t> stack() const;
  // Calls a function of the program, by its number in the graph. Consecutive calls share their state.
  void call(std::size_t function, std::span<double const> arguments, std::span<double> results);

private:
  struct Server;
  void ask(replay::Command command, Sample const &sample, std::span<Sample const> later = {}, unsigned seconds = 0);
  void send(void const *bytes, std::size_t size);
  void require_reached();
  void wait_for_answer();
  std::optional<int> answer(unsigned seconds);
  void end_calls();
  static constexpr unsigned most_watched = 3; // number of runs watched
  unsigned watched_ = 0;
  bool is_calling_ = false, has_run_ = false, is_reached_ = false;
  std::string what_;
  std::unique_ptr<Server> server_;
  Place place_; // of the kernel; for diagnostics
};

} // namespace symreal::program
