// What is asked of an emission, and the files that it gives.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/floating_point.h"

#include <set>
#include <string>
#include <vector>

namespace symreal {

struct EmitOptions {
  std::string base_name = "kernel"; // files are base_name.c, base_name.h, base_name_main.c
  std::string prefix = {};          // of every identifier with external linkage: "arm" gives arm_compute
  FloatingPoint mode = FloatingPoint::finite;
  std::set<std::string, std::less<>> extras = {}; // files on request, such as "mainline" (language.h)
  bool trace_comments = false;                    // every statement says which source lines it comes from
  bool check_values = false;  // one operation a statement, and the first NaN or infinity of a call is reported
  bool is_single = false;     // numbers are float
  bool angles = false;        // sines and cosines of inputs are computed side by side (schedule/angles.h)
  bool origins = false;       // where the lines of statements come from is wanted
  std::string reference = {}; // the mathematical library of the original; empty without an original
};

// Lines of a file that hold one statement, and where its operations come from.
struct LineOrigin {
  std::size_t first_line, last_line;
  std::vector<LocationId> locations;
};

struct EmittedFile {
  std::string name;
  std::string text;
  std::vector<LineOrigin> origins = {}; // on request, where the graph has places
};

} // namespace symreal
