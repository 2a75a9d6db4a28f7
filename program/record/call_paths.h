// Diagnostics of a run, merged to one for each place, however many call paths lead there.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <string>
#include <vector>

namespace symreal::program {

struct Met {
  Diagnostic diagnostic;     // the notes give the call path
  std::size_t count = 0;     // occurrences along this path; 0: not counted
  std::size_t frames = 0;    // length of the call path
  std::string recorded = {}; // its subject in terms of the kernel's inputs, unless the message says so
};

// One diagnostic for each place, in order of first occurrence. Each has the shortest of its paths; its message gives
// the number of occurrences and of paths.
std::vector<Diagnostic> once_a_place(std::vector<Met> const &all);

} // namespace symreal::program
