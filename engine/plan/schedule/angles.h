// Sines and cosines side by side.
//
// A robot's kernel of six joints spends half of its time in the library's sin and cos, an almanac's series nearly all.
// Most angles are inputs or follow from them by a few sums and products, so they are known before anything else:
// function compute begins with all of them in one loop without calls, which compilers make vectors of, into arrays
// `sine` and `cosine`.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// The schedule without the statements that compute these sines and cosines. Those in blocks stay, and operations that
// are exact. Angles that are computed go first only where no statement stands in a block or is a thread's own, where
// there are several, and where hardly anything must be computed again for it.
Schedule with_angles(Schedule plan);

// What function compute begins with, in words; empty where that is nothing.
std::string describe(Angles const &angles);

} // namespace symreal
