// Window search: improves stretches of a network separately.
//
// Local gains decide, so that large networks gain as much as small ones, in time proportional to their size. Values
// from outside are known inside a window, so identities that depend on the whole network still hold in it.
#pragma once

#include "engine/optimise/algebra/search.h"

namespace symreal::algebra {

struct WindowSettings {
  std::size_t length = 300; // operations per window
  int steps = 8;            // steps per window
};

// One pass over randomly cut windows. The result may be larger if windows duplicate operations.
Network improved_in_windows(Network const &network, WindowSettings const &settings, Search &search);

} // namespace symreal::algebra
