// A function of loops, run as generated code runs it.
#pragma once

#include "engine/graph/evaluate.h"
#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/schedule/schedule.h"

#include <cmath>
#include <gtest/gtest.h>

namespace symreal::test {

// What stands in the arrays of which compute takes sines and cosines.
inline std::vector<double> angles_of(Schedule const &plan, std::vector<double> const &inputs) {
  std::vector<double> angles;
  for (std::uint32_t const slot : plan.angles.inputs) angles.push_back(inputs[slot]);
  std::vector<double> const values = evaluate(*plan.graph, inputs, {});
  for (NodeId const id : plan.angles.computed.results) angles.push_back(values[id]);
  return angles;
}

inline std::vector<double> run(reroll::LoopFunction const &function, std::vector<double> const &angles,
                               std::vector<double> const &inputs, std::size_t results) {
  std::vector<double> memory(function.memory), output(results);
  for (reroll::LoopStep const &step : function.steps) {
    std::vector<double> leaves(step.leaves.size());
    for (std::uint32_t k = 0; k < step.count; ++k) {
      for (std::size_t i = 0; i < leaves.size(); ++i) {
        reroll::Leaf const &leaf = step.leaves[i];
        switch (leaf.kind) {
        case reroll::Leaf::Kind::given: leaves[i] = inputs[leaf.access.at(k)]; break;
        case reroll::Leaf::Kind::read: ADD_FAILURE() << "nothing is precomputed"; break;
        case reroll::Leaf::Kind::sine: leaves[i] = std::sin(angles[leaf.access.at(k)]); break;
        case reroll::Leaf::Kind::cosine: leaves[i] = std::cos(angles[leaf.access.at(k)]); break;
        case reroll::Leaf::Kind::memory: leaves[i] = memory[leaf.access.at(k)]; break;
        case reroll::Leaf::Kind::values: leaves[i] = value_at(leaf, k, step.nest); break;
        case reroll::Leaf::Kind::carried:
          if (k == 0) leaves[i] = memory[leaf.access.at(0)];
          break;
        }
      }
      std::vector<double> const values = evaluate(step.body, leaves, {});
      for (reroll::Store const &store : step.stores)
        (store.is_result ? output : memory)[store.access.at(k)] = values[store.value];
      for (std::size_t i = 0; i < leaves.size(); ++i)
        if (step.leaves[i].kind == reroll::Leaf::Kind::carried) leaves[i] = values[step.leaves[i].next];
    }
  }
  for (reroll::Mirror const &mirror : function.mirrors)
    reroll::for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t from) { output[to] = output[from]; });
  return output;
}

} // namespace symreal::test
