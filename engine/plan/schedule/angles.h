// Vectorised sines and cosines.
//
// A kernel of a robot with six joints spends half of its time in the library's sin and cos, the series of an almanac
// nearly all. Most angles are inputs or follow from inputs by a few sums and products, so they are known at the start:
// function compute begins by filling arrays `sine` and `cosine` in one loop without calls, which compilers vectorise.
#pragma once

#include "engine/plan/schedule/schedule.h"

namespace symreal {

// The schedule without the statements of these sines and cosines. Statements in blocks stay, and exact operations.
// Computed angles move to the start only if no statement is in a block or assigned to a thread, there are several
// angles, and next to nothing must be recomputed for them.
Plan with_angles(Plan plan);

// Description of the sines and cosines at the start; empty without angles.
std::string describe(Angles const &angles);

} // namespace symreal
