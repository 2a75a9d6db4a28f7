// Comments by which a generated file describes itself: its first lines, frozen state, guards.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// First lines of every generated file, for verification and for readers. One line is JSON, so that a tool can recognise
// the file as its own.
std::string banner(Emission const &emission);

// Comment on the state that is baked in; empty without such state.
std::string frozen_remark(Emission const &emission);

// Comment on the guards, and the status that compute returns.
std::string guard_remark(Emission const &emission);

} // namespace symreal
