// Selects in generated code: the arm that is not taken is not computed, however deep they nest.
#include "compiled_graph.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"

#include <cfenv>
#include <cmath>
#include <random>

namespace symreal {
namespace {

constexpr int exceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;

// Graph text, line by line.
class Writer {
public:
  Writer(unsigned inputs, unsigned outputs)
      : text_("symreal-graph 1\nkernel \"k\"\ninput \"x\" [" + std::to_string(inputs) + "]\noutput \"y\" [" +
              std::to_string(outputs) + "]\n") {
    for (unsigned k = 0; k < inputs; ++k) add("input " + std::to_string(k));
  }
  std::string add(std::string const &operation) {
    text_ += "%" + std::to_string(next_) + " = " + operation + "\n";
    return " %" + std::to_string(next_++);
  }
  void result(std::string const &node) { text_ += "result " + std::to_string(results_++) + node + "\n"; }
  void guard(std::string const &node) { text_ += "guard " + std::to_string(guards_++) + node + " \"\"\n"; }
  Graph graph() const { return read_graph(text_, "test"); }

private:
  std::string text_;
  unsigned next_ = 0, results_ = 0, guards_ = 0;
};

// if (x < 0) ... else if (x < 1) ... else if ..., each arm defined only where it is taken.
Graph cascade(unsigned length) {
  Writer writer(1, 1);
  std::vector<std::string> conditions, arms;
  for (unsigned k = 0; k < length; ++k) {
    std::string const number = std::to_string(k);
    conditions.push_back(writer.add("lt %0 " + number));
    std::string const root = writer.add("sqrt" + writer.add("sub %0 " + std::to_string(int(k) - 1)));
    arms.push_back(writer.add("mul" + root + root));
  }
  std::string value = " %0";
  for (unsigned k = length; k-- > 0;) value = writer.add("select" + conditions[k] + arms[k] + value);
  writer.result(value);
  return writer.graph();
}

// y = x > k ? sqrt(y) * sqrt(y) : 2, again and again: the first roots stand under all conditions.
Graph chain(unsigned length) {
  Writer writer(1, 1);
  std::string value = " %0";
  for (unsigned k = 0; k < length; ++k) {
    std::string const condition = writer.add("gt %0 " + std::to_string(k));
    std::string const root = writer.add("sqrt" + value);
    value = writer.add("select" + condition + writer.add("mul" + root + root) + " 2");
  }
  writer.result(value);
  return writer.graph();
}

std::size_t deepest_indent(std::string const &source) {
  std::size_t deepest = 0;
  for (std::size_t at = 0; at < source.size(); at = source.find('\n', at) + 1)
    deepest = std::max(deepest, source.find_first_not_of(' ', at) - at);
  return deepest;
}

void expect_quiet_and_equal(Graph const &graph, std::vector<double> const &samples) {
  EXPECT_LT(deepest_indent(emit(schedule(graph), *find_language("c"), {})[0].text), 80u);
  for (std::string const compiler : {"gcc", "clang-19"}) {
    Compiled const compiled(graph, compiler);
    for (double x : samples) {
      std::vector<double> const values = evaluate(graph, {&x, 1}, {});
      std::feclearexcept(FE_ALL_EXCEPT);
      double const output = compiled.run({x}, 1)[0];
      EXPECT_EQ(std::fetestexcept(exceptions), 0) << x << " " << compiler;
      EXPECT_EQ(output, values[graph.results[0]]) << x << " " << compiler;
    }
  }
}

TEST(Select, ALongCascadeIsLazyInShallowBlocks) {
  expect_quiet_and_equal(cascade(150), {-1, -0.5, 0.5, 3.25, 20.5, 41.5, 99.5, 148.5, 150.5});
}

TEST(Select, ALongChainIsLazyInShallowBlocks) {
  expect_quiet_and_equal(chain(150), {-5, 0, 3.5, 60.5, 148.5, 149.5, 1000});
}

// Shared nodes, conditions on conditions, real numbers as conditions, guards, several chunks.
Graph random_graph(unsigned seed, unsigned count, unsigned guards) {
  std::mt19937_64 random(seed);
  Writer writer(5, 6);
  std::vector<std::string> numbers = {" %0", " %1", " %2", " %3", " %4"}, truths = {writer.add("lt %0 %1")};
  auto one_of = [&](std::vector<std::string> const &all) {
    return all[all.size() - 1 - std::min<std::size_t>(all.size() - 1, random() % 16)];
  };
  for (unsigned k = 0; k < count; ++k) switch (random() % 9) {
    case 0: truths.push_back(writer.add("gt" + one_of(numbers) + " " + std::to_string(int(random() % 3) - 1))); break;
    case 1: truths.push_back(writer.add("logical_and" + one_of(truths) + one_of(truths))); break;
    case 2:
      truths.push_back(writer.add("logical_or" + one_of(truths) + writer.add("logical_not" + one_of(truths))));
      break;
    case 3: numbers.push_back(writer.add("sqrt" + one_of(numbers))); break;
    case 4: numbers.push_back(writer.add("div" + one_of(numbers) + one_of(numbers))); break;
    case 5: numbers.push_back(writer.add("add" + one_of(numbers) + one_of(numbers))); break;
    case 6: numbers.push_back(writer.add("select" + one_of(numbers) + one_of(numbers) + one_of(numbers))); break;
    default: numbers.push_back(writer.add("select" + one_of(truths) + one_of(numbers) + one_of(numbers)));
    }
  for (int k = 0; k < 6; ++k) writer.result(one_of(numbers));
  for (unsigned k = 0; k < guards; ++k) writer.guard(one_of(truths));
  return writer.graph();
}

TEST(Select, BlocksComputeWhatTheGraphMeans) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Graph const graph = random_graph(seed, seed % 4 == 0 ? 1500 : 30 * seed, seed % 3);
    Compiled const compiled(graph, "gcc");
    std::mt19937_64 random(seed);
    for (int k = 0; k < 100; ++k) {
      std::vector<double> input(5), output(6);
      for (double &x : input) x = static_cast<double>(random() % 2001) / 500 - 2;
      std::vector<double> const values = evaluate(graph, input, {});
      std::size_t const failing = first_failing_guard(graph, values);
      int const expected = failing == graph.guards.size() ? 0 : static_cast<int>(failing) + 1;
      ASSERT_EQ(compiled.run(input, output), expected) << seed;
      for (std::size_t slot = 0; slot < 6 && expected == 0; ++slot) {
        double const wanted = values[graph.results[slot]];
        EXPECT_TRUE(output[slot] == wanted || (std::isnan(output[slot]) && std::isnan(wanted))) << seed;
      }
    }
  }
}

TEST(Select, ManyAreScheduledInLinearTime) {
  EXPECT_LT(emit(schedule(chain(30000)), *find_language("c"), {})[0].text.size(), 40'000'000u);
  EXPECT_LT(emit(schedule(cascade(30000)), *find_language("c"), {})[0].text.size(), 40'000'000u);
}

} // namespace
} // namespace symreal
