// --paths-met: under policies explore and auto, the paths that given samples take become code, and a guard refuses each
// branch that none of them takes.
//
//   x[0],x[1],m      a table: the names of inputs and parameters as `generate` prints them, in any order; further
//   0.5,1,2.5        columns are not looked at; without columns for parameters these have their recorded values
#pragma once

#include "engine/ops/floating_point.h"
#include "program/record/path_tree.h"
#include "runtime/replay/samples.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// Throws unreadable_file, paths_met_file.
std::vector<Sample> read_sample_table(std::string const &file, Graph const &graph);

class MetPaths {
public:
  // The recorded sample counts as one of them.
  MetPaths(std::string file, Graph const &graph);
  std::size_t samples() const { return samples_.size() - 1; }

  // Notes at each decision of the path which ways samples go that come by.
  void note(RecordedPath &path) const;
  // The outcomes up to the first decision that samples leave otherwise than the path does, and theirs.
  static std::optional<Outcomes> correction(RecordedPath const &path);
  // Throws paths_outside where no given sample lies within the premises and the guards of the whole.
  void require_inside(Graph const &graph, FloatingPoint mode, Place const &place) const;

private:
  std::string file_;
  std::vector<Sample> samples_;
};

} // namespace symreal::program
