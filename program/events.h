// What the symbolic program tells about its recording: the file `events`, one event a line, fields separated by tabs.
//
//   started     kernel
//   kernel      name  N.graph  output file
//   diagnostic  SYM0nn  file  line  column  message
//   decision    count  condition  address,address,...   hexadecimal, relative to the load base, innermost first
//   frozen      kernel  name  place  value
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace symreal::program {

struct RecordedKernel {
  std::string name, graph_file, output_file;
};

struct Decision {
  std::size_t count = 0;
  std::string condition;
  std::vector<std::uint64_t> addresses;
};

struct FrozenState {
  std::string kernel, name, place, value;
};

struct Events {
  std::vector<std::string> started; // kernels that were begun
  std::vector<RecordedKernel> kernels;
  std::vector<Diagnostic> diagnostics;
  std::vector<Decision> decisions;
  std::vector<FrozenState> frozen;
};

// A file that does not exist holds no events.
Events read_events(std::string const &path);

} // namespace symreal::program
