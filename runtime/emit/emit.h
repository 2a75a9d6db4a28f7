// Graph to C99: a source with preprocess() and compute(), a header, and on request a runnable main.
#pragma once

#include "graph/graph.h"
#include "passes/floating_point.h"

#include <string>
#include <vector>

namespace symreal {

struct EmitOptions {
  std::string base_name = "kernel"; // files are base_name.c, base_name.h, base_name_main.c
  std::string prefix = {};          // of every identifier with external linkage: "arm" gives arm_compute
  FloatingPoint mode = FloatingPoint::finite;
  bool mainline = false;
  bool trace_comments = false; // every statement says which source lines it comes from
  bool check_values = false;   // one operation a statement, and the first NaN or infinity of a call is reported
};

// Lines of a file that hold one statement, and where its operations come from.
struct LineOrigin {
  std::size_t first_line, last_line;
  std::vector<LocationId> locations;
};

struct EmittedFile {
  std::string name;
  std::string text;
  std::vector<LineOrigin> origins = {}; // where the graph has places
};

// The generated functions, with `prefix_` before their names if a prefix is given:
//   void preprocess(double const *parameters, double *constants);
//   void compute(double const *input, double const *constants, double *output);
// All inputs are read before an output is written, so the arrays may overlap. Nothing is allocated, no state is kept.
// With guards compute is an int: 0, or k + 1 for the first guard, k, that does not hold; output is untouched then. Then
// there also are
//   enum { guard_count = n };
//   char const *guard_text(int guard);
std::vector<EmittedFile> emit_c(Graph const &graph, EmitOptions const &options);

// Throws unwritable_output where generated text would replace a file that is not generated: a function `step` of a
// kernel may well stand in a step.c.
void require_ours(std::string const &path, std::string const &text);

// The condition of a guard in words, and its places: the user's own first, then those further in.
std::string guard_text(Graph const &graph, Guard const &guard);

} // namespace symreal
