// Addresses of the symbolic program as places in the user's source, inline frames included.
#pragma once

#include "program/build/overlay.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace symreal::program {

struct Frame {
  std::string function; // demangled
  Place place;          // in the user's source where that is known
  bool rewritten;       // it stands in a rewritten file
};

class Symbolizer {
public:
  Symbolizer(std::string executable, Overlay const &overlay);
  ~Symbolizer();

  // The frames of return addresses (relative to the executable's load base, innermost first). Frames without debug
  // information, those of the runtime among them, are left out.
  std::vector<Frame> frames(std::vector<std::uint64_t> const &return_addresses);

private:
  struct Engine;
  std::string executable_;
  Overlay const &overlay_;
  std::unique_ptr<Engine> engine_;
};

} // namespace symreal::program
