// Signs that differ from iteration to iteration: which factors go, and that the results are the same numbers.
#include "engine/plan/reroll/bodies.h"
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/reroll/signs.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <algorithm>
#include <array>
#include <random>

namespace symreal {
namespace {

using Builder = test::GraphBuilder;
using reroll::Leaf;
using reroll::LoopFunction;
using reroll::LoopStep;

LoopStep const &loop(LoopFunction const &function) {
  return *std::ranges::max_element(function.steps, {}, &LoopStep::count);
}

// The loops of the graph with few signs, which compute what the graph does. Sums of opposite numbers aside the values
// are the same; those are compared with ==, which takes -0 for 0.
LoopFunction with_few_signs(Graph const &graph) {
  std::optional<LoopFunction> const before = test::loops_of_compute(rerolled(schedule(graph), FloatingPoint::strict));
  EXPECT_TRUE(before);
  if (!before) return {};
  LoopFunction after = reroll::with_few_signs(*before);
  std::vector<double> inputs;
  for (std::size_t k = 0; k < graph.input_count(); ++k) inputs.push_back(std::sin(1.0 + static_cast<double>(k * k)));
  std::vector<double> const values = evaluate(graph, inputs, {}),
                            run = test::run(after, {}, inputs, graph.results.size());
  for (std::size_t k = 0; k < graph.results.size(); ++k) EXPECT_EQ(run[k], values[graph.results[k]]);
  return after;
}

Op sum_or_difference(bool is_sum) { return is_sum ? Op::add : Op::sub; }

// y -> y z - x, but every `period` times y z + x: how many operations its loop has.
std::size_t operations_of_chain(std::uint32_t period, bool is_number) {
  Builder make;
  NodeId const z = is_number ? make.number(2) : make.input(100);
  NodeId y = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k)
    y = make(sum_or_difference(k % period == 0), make(Op::mul, y, z), make.input(k));
  Graph const graph = make.finish({y});
  return reroll::operations_of(loop(with_few_signs(graph)).body);
}

// y is a negative every other time.
TEST(Signs, OfWhatIsCarriedOnAlternate) { EXPECT_EQ(operations_of_chain(2, false), 2); }

// No signs of y make a sum of this: two differences follow each sum.
TEST(Signs, ThatContradictEachOtherTakeOneFactor) { EXPECT_EQ(operations_of_chain(3, false), 3); }

// Numbers in tables take any sign.
TEST(Signs, GoIntoTables) { EXPECT_EQ(operations_of_chain(3, true), 2); }

// What one loop leaves as negatives, another reads as such, and straight-line code.
TEST(Signs, GoThroughMemory) {
  Builder make;
  std::vector<NodeId> stored;
  NodeId y = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    y = make(sum_or_difference(k % 2 == 0), make(Op::mul, y, make.input(100)), make.input(k));
    stored.push_back(y);
  }
  NodeId z = make.input(101);
  for (std::size_t k = 60; k-- > 0;)
    z = make(Op::mul, make(sum_or_difference(k % 2 == 0), make(Op::mul, z, make.input(100)), stored[k]),
             make.input(102));
  Graph const graph = make.finish({make(Op::add, z, make(Op::sqrt, make(Op::mul, stored[7], stored[7]))), stored[9]});
  LoopFunction const function = with_few_signs(graph);
  EXPECT_EQ(function.loops, 2);
  std::size_t operations = 0;
  for (LoopStep const &step : function.steps)
    if (step.count > 1) operations += reroll::operations_of(step.body);
  EXPECT_EQ(operations, 5);
}

// Two loops over the same numbers, which one of them takes as negatives: both have the table with the positive ones.
TEST(Signs, OfTablesAreThoseThatLoopsCanShare) {
  Builder make;
  auto const number = [](std::uint32_t k) { return std::sin(1.0 + 3 * k) - 0.25; };
  std::vector<NodeId> stored;
  NodeId y = make.input(0);
  for (std::uint32_t k = 1; k <= 60; ++k) {
    y = make(Op::sub, make(Op::mul, y, make.input(100)), make(Op::mul, make.input(k), make.number(number(k))));
    stored.push_back(y);
  }
  NodeId z = make.input(101);
  for (std::uint32_t k = 60; k > 0; --k)
    z = make(Op::add, make(Op::mul, z, make.input(100)), make(Op::mul, stored[k - 1], make.number(-number(k))));
  LoopFunction const function = with_few_signs(make.finish({z}));
  EXPECT_EQ(function.loops, 2);
  std::size_t tables = 0;
  for (LoopStep const &step : function.steps)
    for (Leaf const &leaf : step.leaves) {
      if (leaf.array != Array::values) continue;
      ++tables;
      EXPECT_GT(*std::ranges::max_element(leaf.values, {}, [](double value) { return std::fabs(value); }), 0);
    }
  EXPECT_EQ(tables, 2);
}

// A body of random operations with random signs, over random periods.
Graph random_chain(std::mt19937 &random) {
  auto const below = [&](unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(random); };
  struct Plan {
    Op op;
    unsigned a, b, period;
    double factor;
  };
  unsigned const length = 3 + below(10), carried = 2;
  std::vector<Plan> body;
  for (unsigned p = 0; p < length; ++p) {
    Op const op = std::array{Op::add, Op::add, Op::sub, Op::mul, Op::mul, Op::abs}[below(6)];
    body.push_back({op, below(carried + 2 + p), below(carried + 2 + p), 1 + below(4), below(2) ? 0.0 : 0.75});
  }
  Builder make;
  std::vector<NodeId> results, state = {make.input(0), make.input(1)};
  for (unsigned k = 0; k < 40; ++k) {
    std::vector<NodeId> values = state;
    values.push_back(make.input(2 + k));
    values.push_back(make.input(50));
    for (Plan const &plan : body) {
      bool const flips = k % plan.period == 0;
      NodeId const a = values[plan.a], b = values[plan.b];
      bool const is_sum = plan.op == Op::add || plan.op == Op::sub;
      NodeId value = plan.op == Op::abs ? make(Op::abs, a) : make(is_sum ? sum_or_difference(flips) : Op::mul, a, b);
      // Values stay of a size.
      value = make(Op::mul, value, make.number(plan.factor == 0 ? 0.5 : flips ? plan.factor : -plan.factor));
      values.push_back(value);
    }
    state.assign(values.end() - carried, values.end());
    if (k % 5 == 0) results.push_back(values[values.size() - 3]);
  }
  for (NodeId id : state) results.push_back(id);
  return make.finish(results);
}

TEST(Signs, OfRandomLoopsLeaveTheResults) {
  std::mt19937 random(7);
  unsigned loops = 0, cheaper = 0;
  for (unsigned sample = 0; sample < 300; ++sample) {
    Graph const graph = random_chain(random);
    std::optional<LoopFunction> const before = test::loops_of_compute(rerolled(schedule(graph), FloatingPoint::strict));
    if (!before) continue;
    ++loops;
    LoopFunction const after = with_few_signs(graph);
    EXPECT_TRUE(test::loops_of_compute(
        rerolled(schedule(graph), FloatingPoint::finite))); // with the proof that nothing has changed
    cheaper += reroll::operations_of(loop(after).body) < reroll::operations_of(loop(*before).body);
  }
  EXPECT_GT(loops, 100);
  EXPECT_GT(cheaper, 20);
}

} // namespace
} // namespace symreal
