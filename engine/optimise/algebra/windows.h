// Search in windows: stretches of a network, each improved by itself.
//
// What is local is accepted by what it saves locally, so that large networks gain as much as small ones, and time is in
// proportion to size. The values of what comes from outside a window are known inside, so identities that rest on the
// whole still hold in it.
#pragma once

#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct WindowSettings {
  std::size_t length = 300; // operations in a window
  int steps = 8;            // in each
};

// One pass over the network, cut at random. It may be larger by what windows have computed twice.
Network improved_in_windows(Network const &network, WindowSettings const &settings, Search &search);

} // namespace symreal::algebra
