// Attempts at joins that fail are bounded by what the paths take, whatever the program does.
#include "program/record/explore.h"

#include "engine/graph/node_table.h"

#include <algorithm>
#include <charconv>
#include <gtest/gtest.h>

namespace symreal::program {
namespace {

// Decides whether each of so many inputs is positive, and never comes together. Each attempt takes all that it may.
class Apart {
public:
  explicit Apart(std::size_t inputs) : inputs_(inputs) {}

  PathRun run(std::string const &variable) {
    std::size_t const first = variable.find(':') + 1, second = variable.find(':', first);
    Outcomes outcomes = variable.substr(first, second - first);
    std::string_view const allowed = std::string_view(variable).substr(variable.rfind(':') + 1);
    std::size_t pieces = 0;
    std::from_chars(allowed.data(), allowed.data() + allowed.size(), pieces);
    if (outcomes.size() == inputs_) pieces = 0; // all is prescribed
    outcomes.resize(inputs_, 'f');
    PathRun run;
    run.events.in_vain = pieces;
    most_allowed = std::max(most_allowed, pieces);
    least_allowed = std::min(least_allowed, pieces);
    NodeTable table;
    std::vector<NodeId> x;
    for (std::size_t k = 0; k < inputs_; ++k) x.push_back(table.intern(Node::input(static_cast<std::uint32_t>(k))));
    NodeId const zero = table.constant(0);
    for (std::size_t k = 0; k < inputs_; ++k)
      run.events.decided.push_back(
          {table.intern(table.operation(Op::gt, x[k], zero)), outcomes[k] == 't', false, false, false, "", {}});
    Graph graph;
    graph.kernel = "apart";
    graph.inputs = {{"x", {inputs_}, 0, static_cast<std::uint32_t>(inputs_)}};
    graph.outputs = {{"y", {}}};
    graph.results = {x[static_cast<std::size_t>(std::ranges::count(outcomes, 't')) % inputs_]};
    graph.nodes = table.release();
    run.graph = std::move(graph);
    return run;
  }

  std::size_t most_allowed = 0, least_allowed = ~std::size_t{0};

private:
  std::size_t inputs_;
};

Exploration explored(Apart &program, ExploreBounds const &bounds) {
  Exploration exploration;
  auto const run = [&](std::string const &variable) { return std::optional(program.run(variable)); };
  (void)explore(0, {}, bounds, run, [](Graph const &) { return std::optional<MetPaths>(); }, exploration);
  return exploration;
}

TEST(Explore, WorkInVainIsBoundedByThatOfThePaths) {
  for (std::size_t const inputs : {2U, 5U, 8U}) {
    Apart program(inputs);
    Exploration const exploration = explored(program, {.paths = 1000});
    EXPECT_EQ(exploration.paths, std::size_t{1} << inputs);
    EXPECT_EQ(exploration.decided, inputs << inputs);
    EXPECT_GE(exploration.in_vain, first_pieces_in_vain);
    EXPECT_LE(exploration.in_vain, first_pieces_in_vain + exploration.decided);
    EXPECT_EQ(program.most_allowed, first_pieces_in_vain);
    EXPECT_LE(program.least_allowed, inputs); // what a path has added
  }
}

TEST(Explore, NothingIsTriedWhereWaysAreToStayApart) {
  Apart program(4);
  EXPECT_EQ(explored(program, {.joins = false}).in_vain, 0U);
  EXPECT_EQ(program.most_allowed, 0U);
}

} // namespace
} // namespace symreal::program
