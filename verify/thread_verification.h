// Code whose threads share an evaluation, against the same code on one thread: equal to the last bit, and how fast.
#pragma once

#include "verify/replay.h"

#include <optional>

namespace symreal::program {

// Nanoseconds of an evaluation: medians of turns that one thread and all take one after the other.
struct ThreadTimes {
  double alone = 0, together = 0;
  double gain = 0, low = 0, high = 0; // how many times as fast, in a turn: median and quartiles
  std::size_t turns = 0;
};

struct ThreadResult {
  unsigned threads = 1;
  std::size_t different = 0;             // samples on which one thread computes other numbers, or returns another guard
  std::optional<ThreadTimes> times = {}; // not of code that calls functions of the program
};

class ThreadVerification {
public:
  // Compiles the file once more, without OpenMP. `start`: a program that runs code which calls functions of it.
  template <class Start> ThreadVerification(std::string const &path, Banner const &banner, Graph const &graph,
                                            Workspace const &workspace, Start const &start)
      : alone_(path, banner, graph, CodeBuild{.object = "generated-alone.so", .alone = true}, workspace),
        result_{banner.threads} {
    if (alone_.needs_program()) start(program_, alone_);
  }

  void compare(Sample const &sample, GeneratedCode::Result const &together);
  // With the times of both on this sample.
  ThreadResult finish(GeneratedCode &together, Sample const *sample);

private:
  GeneratedCode alone_;
  std::unique_ptr<Replay> program_;
  ThreadResult result_;
};

} // namespace symreal::program
