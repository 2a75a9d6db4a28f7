#include "emit/emit.h"

#include "compiled_graph.h"
#include "emit/expression.h"
#include "graph/evaluate.h"
#include "graph/graph_text.h"
#include "operation_samples.h"
#include "support/number.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>

namespace symreal {
namespace {

// Every operation of the table, each with inputs of its own.
Graph graph_of_all() {
  std::string nodes, results;
  std::size_t node = 0, slot = 0, input = 0;
  for (OperationInfo const &operation : operations()) {
    for (unsigned i = 0; i < operation.arity; ++i)
      nodes += "%" + std::to_string(node++) + " = input " + std::to_string(input++) + "\n";
    nodes += "%" + std::to_string(node) + " = " + std::string(operation.name);
    for (unsigned i = 0; i < operation.arity; ++i) nodes += " %" + std::to_string(node - operation.arity + i);
    nodes += "\n";
    results += "result " + std::to_string(slot++) + " %" + std::to_string(node++) + "\n";
  }
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [" + std::to_string(input) + "]\noutput \"y\" [" +
                        std::to_string(slot) + "]\n" + nodes + results,
                    "test");
}

TEST(Emit, EveryOperationComputesTheReferenceInC) {
  Graph const graph = graph_of_all();
  for (std::string const compiler : {"gcc", "clang-19"}) {
    Compiled const compiled(graph, compiler);
    for (std::size_t k = 0; k < 25; ++k) {
      std::vector<double> input, expected;
      for (OperationInfo const &operation : operations()) {
        auto x = test::samples(operation, 25)[k];
        input.insert(input.end(), x.begin(), x.begin() + operation.arity);
        expected.push_back(evaluate(operation.op, x[0], x[1], x[2]));
      }
      std::vector<double> const output = compiled.run(input, expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(output[i]), std::bit_cast<std::uint64_t>(expected[i]))
            << operations()[i].name << " with " << compiler;
    }
  }
}

// Long enough for many chunks, with values that live in one, cross some, and are truth values.
TEST(Emit, ALongFunctionIsCutAndComputesTheSame) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [2]\noutput \"y\" [200]\n%0 = input 0\n%1 = input 1\n";
  std::mt19937_64 random(5);
  std::size_t const count = 6000;
  for (std::size_t k = 2; k < count; ++k) {
    auto recent = [&] { return " %" + std::to_string(k - 1 - random() % std::min<std::size_t>(k - 1, 20)); };
    auto any = [&] { return " %" + std::to_string(random() % k); };
    std::string const line = k % 97 == 0   ? "lt" + recent() + any()
                             : k % 89 == 0 ? "select" + any() + recent() + recent()
                             : k % 7 == 0  ? "sin" + recent()
                             : k % 2       ? "add" + recent() + any()
                                           : "mul 0.5" + recent();
    text += "%" + std::to_string(k) + " = " + line + "\n";
  }
  for (std::size_t k = 0; k < 200; ++k)
    text += "result " + std::to_string(k) + " %" + std::to_string(count - 1 - 29 * k) + "\n";
  Graph const graph = read_graph(text, "test");
  std::string const source = emit_c(graph, {.base_name = "k"})[0].text;
  EXPECT_NE(source.find("void compute_2("), std::string::npos);
  for (std::string const compiler : {"gcc", "clang-19"}) {
    Compiled const compiled(graph, compiler);
    for (double x : {0.25, -1.5, 3.0}) {
      std::vector<double> const input = {x, 1 - x}, values = evaluate(graph, input, {});
      std::vector<double> const output = compiled.run(input, 200);
      for (std::size_t k = 0; k < 200; ++k) EXPECT_EQ(output[k], values[graph.results[k]]);
    }
  }
}

TEST(Emit, ConstantsReadBackToTheSameBits) {
  for (double value : {0.0, -0.0, 1.0, 0.1, -1e300, 5e-324, 1.7976931348623157e308, 123456789012345680.0, 1e22}) {
    std::string const text = c_constant(value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)), std::bit_cast<std::uint64_t>(value))
        << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << " is an integer in C";
    EXPECT_EQ(parse_number(shortest(value)), value);
  }
  EXPECT_EQ(c_constant(INFINITY), "INFINITY");
  EXPECT_EQ(c_constant(-INFINITY), "-INFINITY");
  EXPECT_EQ(c_constant(NAN), "NAN");
}

TEST(Emit, ADeepChainNeedsNoDeepStackAndNoLongLines) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n";
  std::size_t const depth = 200000;
  for (std::size_t k = 1; k <= depth; ++k) text += "%" + std::to_string(k) + " = sin %" + std::to_string(k - 1) + "\n";
  Graph const graph = read_graph(text + "result 0 %" + std::to_string(depth) + "\n", "test");
  std::string const source = emit_c(graph, {})[0].text;
  EXPECT_NE(source.find("sin(sin("), std::string::npos);
  for (std::size_t at = 0; at < source.size();) {
    std::size_t const end = std::min(source.find('\n', at), source.size());
    EXPECT_LT(end - at, 200u);
    at = end + 1;
  }
}

} // namespace
} // namespace symreal
