// Long functions: what crosses their parts, and where results are stored.
#include "compiled_graph.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace symreal {
namespace {

constexpr std::size_t outputs = 1200;

// Each result is a product of its own and used nowhere else; the last ones read the first inputs again.
Graph many_results() {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [3]\noutput \"y\" [" + std::to_string(outputs) +
                     "]\n%0 = input 0\n%1 = input 1\n%2 = input 2\n%3 = sin %1\n",
              results;
  std::size_t node = 4, running = 3;
  for (std::size_t k = 0; k < outputs; ++k) {
    std::string const other = k + 3 < outputs ? "%3" : "%0";
    text += "%" + std::to_string(node) + " = add %" + std::to_string(running) + " " + other + "\n";
    running = node++;
    text += "%" + std::to_string(node) + " = mul %" + std::to_string(running) + " %" + std::to_string(running) + "\n";
    results += "result " + std::to_string(k) + " %" + std::to_string(node++) + "\n";
  }
  return read_graph(text + results, "test");
}

std::size_t count(std::string const &text, std::string const &pattern) {
  std::regex const regex(pattern);
  return static_cast<std::size_t>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

TEST(Chunks, PartsStoreTheirResultsAndLittleCrosses) {
  Graph const graph = many_results();
  std::string const source = emit(schedule(graph), *find_language("c"), {.base_name = "k"})[0].text;
  EXPECT_GT(count(source, "SYMREAL_APART static void compute_"), 4u);
  EXPECT_EQ(count(source, "output\\[[0-9]+\\] = "), outputs);
  std::string const last = source.substr(source.find("\nvoid compute("));
  EXPECT_EQ(count(last, "output\\[[0-9]+\\] = "), 0u);
  EXPECT_LT(count(source, "  v\\[[0-9]+\\] = "), 20u); // the sine, the running sum, a copy
  std::smatch slots;
  ASSERT_TRUE(std::regex_search(source, slots, std::regex("double v\\[([0-9]+)\\]")));
  EXPECT_LT(std::stoul(slots[1]), 6u);
}

// As the header says: all inputs are read before an output is written.
TEST(Chunks, ResultsMayBeStoredOverTheInputs) {
  Graph const graph = many_results();
  Compiled const compiled(graph, "gcc");
  std::vector<double> const input = {0.25, 0.5, -3};
  std::vector<double> const expected = compiled.run(input, outputs), values = evaluate(graph, input, {});
  for (std::size_t k = 0; k < outputs; ++k) EXPECT_EQ(expected[k], values[graph.results[k]]);
  std::vector<double> both(outputs);
  for (std::size_t const at : {std::size_t{0}, std::size_t{1}, outputs / 2}) {
    std::ranges::copy(input, both.begin() + static_cast<std::ptrdiff_t>(at));
    compiled.run(both.data() + at, both.data());
    EXPECT_EQ(both, expected) << at;
  }
}

// The outputs are as they were where a guard does not hold, be it the last statement's.
TEST(Chunks, NothingIsStoredBeforeTheLastGuard) {
  Graph const graph = many_results();
  std::ostringstream written;
  write_graph(written, graph);
  std::string const text = written.str();
  std::size_t const nodes = graph.nodes.size();
  std::string const guard = "%" + std::to_string(nodes) + " = lt %" + std::to_string(nodes - 1) + " 1e6\n";
  std::string changed = text;
  changed.insert(text.find("result 0 "), guard);
  changed += "guard 0 %" + std::to_string(nodes) + " \"small\"\n";
  Graph const guarded = read_graph(changed, "test");
  Compiled const compiled(guarded, "gcc");
  std::vector<double> output(outputs, 7);
  EXPECT_EQ(compiled.run({1e9, 0.5, 0}, output), 1);
  EXPECT_EQ(output, std::vector<double>(outputs, 7));
  EXPECT_EQ(compiled.run({0.25, 0.5, 0}, output), 0);
}

} // namespace
} // namespace symreal
