// --paths-met: under policies explore and auto, restricts code to the paths that given samples take; a guard refuses
// each other branch.
//
//   x[0],x[1],m      a table: the names of inputs and parameters as `generate` prints them, in any order; further
//   0.5,1,2.5        columns are ignored; without columns for parameters they have their recorded values
#pragma once

#include "engine/ops/floating_point.h"
#include "program/record/path_tree.h"
#include "runtime/replay/samples.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// Reads a table of samples. Throws unreadable_file, paths_met_file.
std::vector<Sample> read_sample_table(std::string const &file, Graph const &graph);

class MetPaths {
public:
  // The recorded sample counts as a given one.
  MetPaths(std::string file, Graph const &graph);
  std::size_t samples() const { return samples_.size() - 1; }

  // Notes at each decision of the path which outcomes the samples that reach it have.
  void note(RecordedPath &path) const;
  // Outcomes up to the first decision where all samples leave the path, with theirs; nullopt if they follow it.
  static std::optional<Outcomes> correction(RecordedPath const &path);
  // Throws paths_outside if no given sample satisfies the premises and all guards of the merged graph.
  void require_inside(Graph const &graph, FloatingPoint mode, Place const &place) const;

private:
  std::string file_;
  std::vector<Sample> samples_;
};

} // namespace symreal::program
