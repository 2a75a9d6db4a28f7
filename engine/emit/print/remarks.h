// Comments on what a kernel rests on.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// The state that is baked in; empty where none is.
std::string frozen_remark(Emission const &emission);

// The guards, and what compute returns.
std::string guard_remark(Emission const &emission);

} // namespace symreal
