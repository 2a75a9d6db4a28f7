// The client of a replay program, that of the original or of the rewritten text: runs a kernel, in numbers, on inputs
// of our choice.
#pragma once

#include "engine/graph/evaluate.h"
#include "program/record/record.h"
#include "runtime/replay/replay_protocol.h"
#include "runtime/replay/samples.h"
#include "verify/generated_code.h"

#include <memory>
#include <string>

namespace symreal::program {

class Replay {
public:
  // Starts the program. `what` it is, in words; `begun_as`: the name under which the kernel begins.
  // With `code` it also runs that, and the graph, in the program. With `profile` the program counts its branches, and
  // writes them to that file when this ends; the kernel is called once then. `environment`: what else the program
  // finds in its own.
  Replay(std::string what, std::string const &executable, RunOptions const &options, std::string const &begun_as,
         Graph const &graph, Workspace const &workspace, GeneratedCode const *code = nullptr,
         std::string const &profile = {}, std::vector<std::string> const &environment = {});
  ~Replay();
  Replay(Replay const &) = delete;
  Replay &operator=(Replay const &) = delete;

  // The outputs of the kernel. Throws replay_failed when the kernel does not end on this sample.
  // `later`: further calls of the kernel in a row, at most `most_later`. Each finds the state that the one before it
  // has left, and its own sample in all other inputs. A machine or kind of kernel that cannot repeat a call has the
  // first. `seconds`: a shorter time limit than the program's; 0: that one. The first few runs of the original also
  // tell what it does outside of the program.
  static constexpr std::size_t most_later = 2;
  std::vector<double> run(Sample const &sample, std::span<Sample const> later = {}, unsigned seconds = 0);
  std::size_t calls() const;
  std::vector<double> outputs_of(std::size_t call) const;
  // The inputs of a later call on `sample`, after a call of code that gave these outputs. Known once a sample has run.
  std::vector<double> next_inputs(Sample const &sample, std::span<double const> outputs) const;
  bool has_run() const { return has_run_; }
  // What the kernel left, on the last sample that it ran on, in memory that outlives it and is no output; of the
  // original only.
  std::vector<replay::LeftBehind> left_behind() const;
  std::vector<replay::OutsideEffect> effects() const;
  // State of the original that no clause names, on this sample: its kernel runs again and again with other bytes in the
  // memory that it meets.
  std::vector<replay::UnnamedObject> examine(Sample const &sample);
  std::string unexamined() const; // why not all was tried then; empty if it was
  // A hash of what is no number in the object that the kernel has returned, where SYMREAL_RETURNED says what that is.
  std::uint64_t returned() const;
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
  void ask(replay::Command command, Sample const &sample, std::span<Sample const> later = {}, unsigned seconds = 0);
  void send(void const *bytes, std::size_t size);
  void wait_for_answer();
  void end_calls();
  static constexpr unsigned most_watched = 3; // runs
  unsigned watched_ = 0;
  bool is_calling_ = false, has_run_ = false;
  std::string what_;
  std::unique_ptr<Server> server_;
  Place place_; // of the kernel, for diagnostics
};

} // namespace symreal::program
