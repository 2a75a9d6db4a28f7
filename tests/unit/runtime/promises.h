// What the tests of the modes' promises on random graphs have in common.
#pragma once

#include "engine/optimise/passes/pass.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <optional>

namespace symreal::test {

// As many as SYMREAL_RANDOM_GRAPHS says, else as usual.
inline std::uint64_t wanted_graphs(std::uint64_t usual) {
  char const *const wanted = std::getenv("SYMREAL_RANDOM_GRAPHS");
  return wanted ? std::strtoull(wanted, nullptr, 10) : usual;
}

// The graph after all passes. Nothing where the guard can never hold.
inline std::optional<Graph> passed(Graph const &graph, PassSettings const &settings) {
  try {
    return run_passes(graph, default_passes(), settings);
  } catch (DiagnosticError const &error) {
    EXPECT_EQ(error.diagnostic().id, DiagnosticId::contradictory_guard);
    return {};
  }
}

} // namespace symreal::test
