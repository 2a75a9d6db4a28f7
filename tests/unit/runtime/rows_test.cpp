// Random chains of stages that are alike, each or every second or third one: the proof of each, and how many become
// rows.
#include "engine/plan/reroll/reroll.h"
#include "engine/plan/schedule/schedule.h"
#include "graph_builder.h"
#include "loop_run.h"

#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

using reroll::LoopFunction;
using reroll::LoopStep;

// Chain i goes through the stages from i to 0, or from i to the last one. A stage computes a new state from that of the
// stage before, with inputs and numbers of its own.
class RandomChains {
public:
  explicit RandomChains(std::mt19937 &random) : random_(random) {}

  Graph graph() {
    std::uint32_t const count = 12 + below(10);
    bool const goes_down = below(2) != 0;
    for (unsigned k = 0; k < period_; ++k) stages_.push_back(random_stage());
    for (std::uint32_t i = 0; i < count; ++i) {
      std::vector<NodeId> state;
      for (unsigned s = 0; s < states_; ++s) state.push_back(make_.input(1000 + states_ * i + s));
      for (std::uint32_t step = 0; step < (goes_down ? i + 1 : count - i); ++step)
        pass(state, goes_down ? i - step : i + step);
      results_.insert(results_.end(), state.begin(), state.end());
    }
    for (std::size_t k = 0; looks_back_ && k < between_.size(); k += 17)
      results_.push_back(make_(Op::mul, between_[k], between_[k]));
    return make_.finish(results_,
                        below(4) == 0 ? std::vector{between_[below(40)], between_.back()} : std::vector<NodeId>());
  }

private:
  struct Plan {
    Op op;
    unsigned a, b;
  };

  unsigned below(unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(random_); }

  std::vector<Plan> random_stage() {
    std::vector<Plan> stage;
    for (unsigned p = 0; p < states_ + 2 + below(6); ++p)
      stage.push_back(
          {std::array{Op::add, Op::sub, Op::mul, Op::neg}[below(4)], below(states_ + 3 + p), below(states_ + 3 + p)});
    return stage;
  }

  void pass(std::vector<NodeId> &state, std::uint32_t stage) {
    std::vector<NodeId> values = state;
    for (std::uint32_t array = 0; array < 2; ++array) values.push_back(make_.input(array * 100 + stage));
    values.push_back(make_.number(stage % numbers_ == 0 ? -0.5 : 0.25 + stage % numbers_));
    for (auto const &[op, a, b] : stages_[stage % period_])
      values.push_back(op == Op::neg ? make_(op, values[a]) : make_(op, values[a], values[b]));
    // Values stay of a size, and each new state needs the old one.
    for (std::size_t s = 0; s < state.size(); ++s)
      state[s] = make_(Op::add, make_(Op::mul, state[s], values[state.size()]), values[values.size() - 1 - s]);
    between_.push_back(state.front());
    if (keeps_all_) results_.push_back(state.back());
  }

  std::mt19937 &random_;
  test::GraphBuilder make_;
  unsigned const states_ = 1 + below(3), period_ = 1 + below(3), numbers_ = 1 + below(4);
  bool const keeps_all_ = below(2) != 0, looks_back_ = below(4) == 0;
  std::vector<std::vector<Plan>> stages_;
  std::vector<NodeId> results_, between_;
};

bool has_rows(LoopFunction const &function) {
  return std::ranges::any_of(function.steps, [](LoopStep const &step) { return step.nest.has_value(); });
}

TEST(Rows, OfRandomChainsComputeTheResults) {
  std::mt19937 random(11);
  unsigned in_rows = 0, otherwise = 0, compared = 0;
  for (unsigned sample = 0; sample < 150; ++sample) {
    Graph const graph = RandomChains(random).graph();
    std::vector<double> inputs(graph.input_count());
    for (double &input : inputs) input = std::uniform_real_distribution<double>(-0.5, 0.5)(random);
    std::vector<double> const values = evaluate(graph, inputs, {});
    for (FloatingPoint const mode : {FloatingPoint::strict, FloatingPoint::finite}) {
      std::optional<LoopFunction> const compute =
          test::loops_of_compute(rerolled(schedule(graph), mode)); // with its proof
      if (!compute) continue;
      ++(has_rows(*compute) ? in_rows : otherwise);
      std::vector<double> const results = test::run(*compute, {}, inputs, graph.results.size());
      for (std::size_t k = 0; k < results.size(); ++k) {
        double const value = values[graph.results[k]];
        if (std::isfinite(value)) ++compared;
        if (std::isfinite(value)) ASSERT_EQ(results[k], value) << sample;
      }
    }
  }
  EXPECT_GT(compared, 10000); // the others have no finite value
  EXPECT_GT(in_rows, 100);
  EXPECT_GT(otherwise, 20);
}

} // namespace
} // namespace symreal
