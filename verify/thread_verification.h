// Verification of code whose threads share an evaluation, against one thread: bitwise equality and speed.
#pragma once

#include "verify/replay.h"

#include <optional>

namespace symreal::program {

// Nanoseconds of an evaluation: medians over turns that alternate between one thread and all.
struct ThreadTimes {
  double alone = 0, together = 0;
  double gain = 0, low = 0, high = 0; // speedup in a turn: median and quartiles
  std::size_t turns = 0;
};

struct ThreadResult {
  unsigned threads = 1;
  std::size_t different = 0;             // samples on which one thread computes other numbers or returns another guard
  std::optional<ThreadTimes> times = {}; // nullopt if the code calls functions of the program
};

class ThreadVerification {
public:
  // Compiles the file again without OpenMP. `start` starts a program that runs code which calls functions of it.
  template <class Start> ThreadVerification(std::string const &path, Banner const &banner, Graph const &graph,
                                            Workspace const &workspace, Start const &start)
      : alone_(path, banner, graph, CodeBuild{.object = "generated-alone.so", .alone = true}, workspace),
        result_{banner.threads} {
    if (alone_.needs_program()) start(program_, alone_);
  }

  void compare(Sample const &sample, GeneratedCode::Result const &together);
  // Returns the result, with the times of both on this sample.
  ThreadResult finish(GeneratedCode &together, Sample const *sample);

private:
  GeneratedCode alone_;
  std::unique_ptr<Replay> program_;
  ThreadResult result_;
};

} // namespace symreal::program
