// Symbolizer: maps addresses of the symbolic program to places in the user's source, with inline frames.
#pragma once

#include "program/build/overlay.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace symreal::program {

struct Frame {
  std::string function; // demangled
  Place place;          // in the user's source, if known
  bool rewritten;       // the place is in a rewritten file
};

class Symbolizer {
public:
  Symbolizer(std::string executable, Overlay const &overlay);
  ~Symbolizer();

  // Frames of return addresses (relative to the load base, innermost first). Omits frames without debug information,
  // including the runtime's.
  std::vector<Frame> frames(std::vector<std::uint64_t> const &return_addresses);

private:
  struct Engine;
  std::string executable_;
  Overlay const &overlay_;
  std::unique_ptr<Engine> engine_;
};

} // namespace symreal::program
