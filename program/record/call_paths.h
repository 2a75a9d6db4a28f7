// What a run met, a diagnostic for each place, however many call paths lead there.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <string>
#include <vector>

namespace symreal::program {

struct Met {
  Diagnostic diagnostic;     // its notes are the call path
  std::size_t count = 0;     // how often, along this path; 0: nobody counted
  std::size_t frames = 0;    // of the path
  std::string recorded = {}; // what it is about in terms of the kernel's inputs, where the message does not say
};

// In the order of the first meetings. Each has the shortest of its paths; its message tells how often it was met and
// how many paths there are.
std::vector<Diagnostic> once_a_place(std::vector<Met> const &all);

} // namespace symreal::program
