// The formats of the standard streams of C++: state that the whole program has.
#pragma once

#include <array>
#include <ios>
#include <string>
#include <vector>

namespace symreal::trace {

struct StreamFormat {
  std::ios_base::fmtflags flags = {};
  std::streamsize precision = 0, width = 0;
  char fill = 0;
  bool operator==(StreamFormat const &) const = default;
};
using StreamFormats = std::array<StreamFormat, 4>;

StreamFormats read_formats();
// The streams whose formats are others by now.
std::vector<std::string> changed_formats(StreamFormats const &before);

// Gives each stream another format, so that output that depends on it shows.
void change_formats();

} // namespace symreal::trace
