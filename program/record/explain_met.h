// Diagnostics of a run in the words of the source: decisions, leaks, indices out of bounds.
#pragma once

#include "engine/graph/graph.h"
#include "program/record/deciding_texts.h"
#include "program/record/events.h"
#include "program/record/symbolize.h"

#include <vector>

namespace symreal::program {

// One diagnostic for each place; omits events.diagnostics, which have places already.
std::vector<Diagnostic> explain_met(Events const &events, Symbolizer &symbolizer, DecidingTexts const &texts);

// Locates a crash: the diagnostic gets the place, the call path as notes, and the function in its message.
void explain_crash(Diagnostic &diagnostic, std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer);

// Rewrites the guards' texts in the words of the source. The graph's places must be resolved.
void say_in_words_of_source(Graph &graph, DecidingTexts const &texts);

} // namespace symreal::program
