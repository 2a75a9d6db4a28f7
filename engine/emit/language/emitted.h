// Options of an emission, and the files that it returns.
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
  std::set<std::string, std::less<>> extras = {}; // extra files, such as "mainline" (language.h)
  bool trace_comments = false;                    // every statement has a comment with its source lines
  bool check_values = false;  // one operation per statement; a call reports its first NaN or infinity
  bool is_single = false;     // numbers are float
  bool origins = false;       // records the source locations of statement lines
  std::string reference = {}; // the mathematical library of the original; empty without an original
};

// Lines of one statement, and the source locations of its operations.
struct LineOrigin {
  std::size_t first_line, last_line;
  std::vector<LocationId> locations;
};

struct EmittedFile {
  std::string name;
  std::string text;
  std::vector<LineOrigin> origins = {}; // on request, if the graph has locations
};

} // namespace symreal
