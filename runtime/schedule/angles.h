// Sines and cosines side by side.
//
// A robot's kernel of six joints spends half of its time in the library's sin and cos. Most of its angles are inputs,
// so they are known when function compute begins: it computes all of them in one loop without calls, which compilers
// make vectors of, into arrays `sine` and `cosine`.
#pragma once

#include "schedule/schedule.h"

namespace symreal {

// The schedule without the statements that compute sines and cosines of inputs. Those in blocks stay, and operations
// that are exact.
Schedule with_angles(Schedule plan);

// What function compute begins with, in words; empty where that is nothing.
std::string describe(Angles const &angles);

} // namespace symreal
