// The sinks of the programs that one source is compiled as, one each.
#pragma once

#include "runtime/trace/kernel/kernel.h"

namespace symreal::trace {

std::unique_ptr<Sink> make_recorder();
std::unique_ptr<Sink> make_recorder_of_original();
std::unique_ptr<Sink> make_replay();
std::unique_ptr<Sink> make_original();

} // namespace symreal::trace
