#include "program/guard_verification.h"

#include <algorithm>
#include <bit>

namespace symreal::program {

static bool is_untouched(std::vector<double> const &outputs) {
  return std::all_of(outputs.begin(), outputs.end(),
                     [](double value) { return std::bit_cast<std::uint64_t>(value) == GeneratedCode::untouched; });
}

// A guard of the code is always the same one of the graph, has its text, and both are in the same order.
static bool is_origin(Graph const &graph, std::size_t failing, std::size_t number,
                      std::vector<GuardCheck> const &guards) {
  GuardCheck const &guard = guards[number];
  if (guard.origin) return *guard.origin == failing;
  for (std::size_t other = 0; other < guards.size(); ++other)
    if (guards[other].origin && (other < number) != (*guards[other].origin < failing)) return false;
  return guard.text.starts_with(graph.guards[failing].text);
}

void check_guards(Graph const &graph, std::size_t failing, GeneratedCode::Result const &result, std::size_t sample,
                  Verification &verification) {
  bool const should_fail = failing < graph.guards.size();
  auto mismatch = [&](std::string found) {
    if (verification.guards_different++ == 0)
      verification.guard_mismatch = {sample, should_fail ? graph.guards[failing].text : "", std::move(found)};
  };
  verification.refused += should_fail;
  if (result.failed == 0) {
    if (should_fail) mismatch("no guard");
    return;
  }
  auto const number = static_cast<std::size_t>(result.failed) - 1;
  if (result.failed < 0 || number >= verification.guards.size())
    return mismatch("guard " + std::to_string(result.failed));
  GuardCheck &guard = verification.guards[number];
  if (!should_fail || !is_origin(graph, failing, number, verification.guards))
    return mismatch("guard " + std::to_string(result.failed) + ", " + guard.text);
  guard.origin = failing;
  ++guard.failed;
  if (!is_untouched(result.outputs)) mismatch("that guard, but wrote to its outputs");
}

} // namespace symreal::program
