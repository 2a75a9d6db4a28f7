// What a run has met, as diagnostics in the words of the source: decisions, leaks, indices that lie outside.
#pragma once

#include "engine/graph/graph.h"
#include "program/record/deciding_texts.h"
#include "program/record/events.h"
#include "program/record/symbolize.h"

#include <vector>

namespace symreal::program {

// One a place; those of events.diagnostics, which have their places already, are left out.
std::vector<Diagnostic> explain_met(Events const &events, Symbolizer &symbolizer, DecidingTexts const &texts);

// Where the program stood when a signal ended it: the diagnostic gets the place, the call path as notes, and the
// function in its message.
void explain_crash(Diagnostic &diagnostic, std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer);

// The guards of the graph, whose places must be resolved.
void say_in_words_of_source(Graph &graph, DecidingTexts const &texts);

} // namespace symreal::program
