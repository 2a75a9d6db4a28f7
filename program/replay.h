// The client of the replay program: runs a kernel of the original, in numbers, on inputs of our choice.
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
  // Starts the program. `begun_as`: the name under which the kernel begins.
  // With `code` it also runs that, and the graph, in the program.
  Replay(std::string const &executable, RunOptions const &options, std::string const &begun_as, Graph const &graph,
         Workspace const &workspace, GeneratedCode const *code = nullptr);
  ~Replay();
  Replay(Replay const &) = delete;
  Replay &operator=(Replay const &) = delete;

  // The outputs of the original. Throws replay_failed when the kernel does not end on this sample.
  std::vector<double> run(Sample const &sample);
  GeneratedCode::Result run_generated(Sample const &sample);
  Evaluation run_graph(Sample const &sample);

private:
  struct Server;
  void ask(replay::Command command, Sample const &sample);
  std::vector<double> outputs() const;

  std::unique_ptr<Server> server_;
  Place place_; // of the kernel, for diagnostics
};

} // namespace symreal::program
