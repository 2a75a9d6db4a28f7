// Comments on the assumptions of a kernel: frozen state and guards.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

// Comment on the state that is baked in; empty without such state.
std::string frozen_remark(Emission const &emission);

// Comment on the guards, and the status that compute returns.
std::string guard_remark(Emission const &emission);

} // namespace symreal
