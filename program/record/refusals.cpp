#include "program/record/refusals.h"

namespace symreal::program {
namespace {

// The innermost condition around the place: the one that begins last.
rewrite::Refusal const *find(Place const &place, std::vector<rewrite::Refusal> const &refusals) {
  rewrite::Refusal const *found = nullptr;
  for (rewrite::Refusal const &one : refusals) {
    bool const covers = one.condition.file == place.file && one.condition.line <= place.line &&
                        place.line <= one.last_line &&
                        (one.condition.line < place.line || one.condition.column <= place.column || !found);
    if (covers) found = &one;
  }
  return found;
}

} // namespace

void explain_refusals(std::vector<Diagnostic> &diagnostics, std::vector<rewrite::Refusal> const &refusals) {
  for (Diagnostic &diagnostic : diagnostics) {
    if (diagnostic.id != DiagnosticId::symbolic_decision) continue;
    if (rewrite::Refusal const *refusal = find(diagnostic.place, refusals))
      diagnostic.notes.insert(diagnostic.notes.begin(), {refusal->token, "not selectable: " + words(refusal->reason)});
  }
}

} // namespace symreal::program
