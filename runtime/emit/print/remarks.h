// Comments on what a kernel rests on.
#pragma once

#include "emit/print/emission.h"

namespace symreal {

// The state that is baked in; empty where none is.
std::string frozen_remark(Emission const &emission);

// The guards. `what_is_returned` where one does not hold, as a sentence.
std::string guard_remark(Emission const &emission, std::string const &what_is_returned);

} // namespace symreal
