// The sinks of the programs that one source is compiled as, one each, and what one that is started by hand does
// with a graph.
#pragma once

#include "runtime/trace/kernel/kernel.h"

namespace symreal::trace {

std::unique_ptr<Sink> make_recorder();
std::unique_ptr<Sink> make_recorder_of_original();
std::unique_ptr<Sink> make_replay();
std::unique_ptr<Sink> make_original();

// Runs the whole pipeline to C in this process, for a program started by hand. Defined in libsymreal_generate.a;
// libsymreal_runtime.a, which the tool links into rewritten programs, has no emitter and reports that (by_hand/).
void generate_here(Graph const &graph, std::string const &output_file);

} // namespace symreal::trace
