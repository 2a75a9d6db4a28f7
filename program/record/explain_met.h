// Diagnostics of a run in the words of the source: decisions, leaks, indices out of bounds.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/graph.h"
#include "program/record/events.h"
#include "program/record/symbolize.h"
#include "rewrite/rewrite.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

// Source texts of a program's decisions, by place.
class DecidingTexts {
public:
  // The texts must outlive this object.
  explicit DecidingTexts(std::vector<rewrite::DecidingText> const &texts);

  // The condition, or converted operand, of a decision at this place; null if unknown. `recorded`: the condition in
  // terms of the kernel.
  rewrite::DecidingText const *condition(Place const &place, std::string const &recorded) const;
  rewrite::DecidingText const *conversion(Place const &place) const;

private:
  using Position = std::pair<unsigned, unsigned>;
  struct File {
    std::map<Position, rewrite::DecidingText const *> by_keyword;
    std::multimap<Position, rewrite::DecidingText const *> conditions, conversions; // by begin
  };
  std::map<std::string, File> files_;
};

// One diagnostic for each place; omits events.diagnostics, which have places already.
std::vector<Diagnostic> explain_met(Events const &events, Symbolizer &symbolizer, DecidingTexts const &texts);

// Locates a crash: the diagnostic gets the place, the call path as notes, and the function in its message.
void explain_crash(Diagnostic &diagnostic, std::vector<std::uint64_t> const &addresses, Symbolizer &symbolizer);

// Rewrites the guards' texts in the words of the source. The graph's places must be resolved.
void say_in_words_of_source(Graph &graph, DecidingTexts const &texts);

// Explains decisions that did not become selects by what the rewriter found in the way: adds to each diagnostic about a
// decision a note at the token that blocks its `if`, `?:` or loop.
void explain_refusals(std::vector<Diagnostic> &diagnostics, std::vector<rewrite::Refusal> const &refusals);

} // namespace symreal::program
