// A function of loops, run as generated code runs it.
#pragma once

#include "engine/graph/evaluate.h"
#include "engine/plan/reroll/reroll.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal::test {

// What stands in the arrays of which compute takes sines and cosines.
inline std::vector<double> angles_of(Plan const &plan, std::vector<double> const &inputs) {
  std::vector<double> angles;
  for (std::uint32_t const slot : plan.angles.inputs) angles.push_back(inputs[slot]);
  std::vector<double> const values = evaluate(*plan.graph, inputs, {});
  if (PlanFunction const *const helper = plan.find(FunctionKind::angles))
    for (NodeId const id : helper->results) angles.push_back(values[id]);
  return angles;
}

inline std::optional<reroll::LoopFunction> loops_of_compute(Rerolled const &loops) {
  auto const found = loops.functions.find(FunctionKind::compute);
  return found == loops.functions.end() ? std::nullopt : std::optional(found->second);
}

inline std::vector<double> run(reroll::LoopFunction const &function, std::vector<double> const &angles,
                               std::vector<double> const &inputs, std::size_t results) {
  std::vector<double> memory(function.memory), output(results);
  for (reroll::LoopStep const &step : function.steps) {
    std::vector<double> leaves(step.leaves.size());
    for (std::uint32_t k = 0; k < step.count; ++k) {
      for (std::size_t i = 0; i < leaves.size(); ++i) {
        reroll::Leaf const &leaf = step.leaves[i];
        switch (leaf.array) {
        case Array::input: leaves[i] = inputs[leaf.access.at(k)]; break;
        case Array::sine: leaves[i] = std::sin(angles[leaf.access.at(k)]); break;
        case Array::cosine: leaves[i] = std::cos(angles[leaf.access.at(k)]); break;
        case Array::values: leaves[i] = value_at(leaf, k, step.nest); break;
        case Array::memory:
          if (!leaf.is_carried || k == 0) leaves[i] = memory[leaf.access.at(k)];
          break;
        default: ADD_FAILURE() << "nothing is precomputed";
        }
      }
      std::vector<double> const values = evaluate(step.body, leaves, {});
      for (reroll::Store const &store : step.stores)
        (store.is_result ? output : memory)[store.access.at(k)] = values[store.value];
      for (std::size_t i = 0; i < leaves.size(); ++i)
        if (step.leaves[i].is_carried) leaves[i] = values[step.leaves[i].next];
    }
  }
  for (reroll::Mirror const &mirror : function.mirrors)
    reroll::for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t from) { output[to] = output[from]; });
  return output;
}

} // namespace symreal::test
