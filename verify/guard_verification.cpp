#include "verify/guard_verification.h"

#include <algorithm>
#include <bit>

namespace symreal::program {

static bool is_untouched(std::vector<double> const &outputs) {
  return std::all_of(outputs.begin(), outputs.end(),
                     [](double value) { return std::bit_cast<std::uint64_t>(value) == GeneratedCode::untouched; });
}

// Does the code's guard have the text of this guard of the graph?
static bool is_text_of(GuardCheck const &check, Guard const &guard) {
  return check.text.find(guard.text) != check.text.npos;
}

// May the code return this guard if `failing` is the graph's first guard that does not hold?
static bool is_expected(Graph const &graph, std::size_t failing, GuardCheck const &returned,
                        std::vector<GuardCheck> const &guards) {
  if (is_text_of(returned, graph.guards[failing])) return true;
  for (GuardCheck const &other : guards)
    if (is_text_of(other, graph.guards[failing])) return false; // the code has that guard
  for (std::size_t k = failing + 1; k < graph.guards.size(); ++k)
    if (is_text_of(returned, graph.guards[k])) return true;
  return false;
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
  if (!should_fail || !is_expected(graph, failing, guard, verification.guards))
    return mismatch("guard " + std::to_string(result.failed) + ", " + guard.text);
  ++guard.failed;
  if (!is_untouched(result.outputs)) mismatch("that guard, but wrote to its outputs");
}

} // namespace symreal::program
