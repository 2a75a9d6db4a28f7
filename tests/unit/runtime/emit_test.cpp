#include "engine/emit/emit.h"

#include "compiled_graph.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/graph_text.h"
#include "engine/support/number.h"
#include "operation_samples.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

// Every operation of the table, each with inputs of its own.
Graph graph_of_all() {
  std::string nodes, results;
  std::size_t node = 0, slot = 0, input = 0;
  for (OperationInfo const &operation : operations()) {
    if (operation.has(flag::OPAQUE)) continue;
    for (unsigned i = 0; i < operation.arity; ++i)
      nodes += "%" + std::to_string(node++) + " = input " + std::to_string(input++) + "\n";
    nodes += test::lines_on_numbers(operation, node - operation.arity, node);
    results += "result " + std::to_string(slot++) + " %" + std::to_string(node - 1) + "\n";
  }
  return read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [" + std::to_string(input) + "]\noutput \"y\" [" +
                        std::to_string(slot) + "]\n" + nodes + results,
                    "test");
}

// A compiler of C, and the language of which its family compiles what is emitted.
class Emit : public testing::TestWithParam<std::tuple<char const *, char const *>> {
protected:
  void SetUp() override {
    if (std::get<1>(GetParam()) == std::string("rust") && !Compiled::has_rust()) GTEST_SKIP() << "there is no rustc";
  }
  Compiled compile(Graph const &graph) const { return {graph, std::get<0>(GetParam()), std::get<1>(GetParam())}; }
};
using Way = std::tuple<char const *, char const *>;
INSTANTIATE_TEST_SUITE_P(Languages, Emit,
                         testing::Values(Way("gcc", "c"), Way("clang-19", "c"), Way("gcc", "cpp"),
                                         Way("clang-19", "cpp"), Way("rustc", "rust")),
                         [](auto const &info) {
                           return std::string(std::get<0>(info.param)).substr(0, 3) + "_" + std::get<1>(info.param);
                         });

// Nodes for several chunks, from `begin` to `end`, each of the one before.
std::string chain(std::size_t begin, std::size_t end) {
  std::string text;
  for (std::size_t k = begin; k < end; ++k)
    text += "%" + std::to_string(k) + " = hypot %" + std::to_string(k - 1) + " %" + std::to_string(k % 2) + "\n";
  return text;
}

TEST_P(Emit, EveryOperationComputesTheReference) {
  Graph const graph = graph_of_all();
  Compiled const compiled = compile(graph);
  for (std::size_t k = 0; k < 25; ++k) {
    std::vector<double> input, expected;
    for (OperationInfo const &operation : operations()) {
      if (operation.has(flag::OPAQUE)) continue; // they are the table's last rows
      auto x = test::samples(operation, 25)[k];
      input.insert(input.end(), x.begin(), x.begin() + operation.arity);
      expected.push_back(test::on_numbers(operation, x));
    }
    std::vector<double> const output = compiled.run(input, expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(output[i]), std::bit_cast<std::uint64_t>(expected[i]))
          << operations()[i].name << " at " << k;
  }
}

// The results of a call that other chunks read, and tables at every kind of index.
TEST_P(Emit, CallsAndLookupsComputeTheSameAcrossChunks) {
  if (std::get<1>(GetParam()) == std::string("rust")) GTEST_SKIP() << "Rust has no external functions";
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [2]\noutput \"y\" [5]\n"
                     "table 0 \"t\" [3] = 1 2.5 -4\ntable 1 \"u\" [2] [2] = 1 2 3 4\n"
                     "external 0 \"modf\" pure returns number takes number output 1\n"
                     "%0 = input 0\n%1 = input 1\n%2 = argument 0 %0\n%3 = call %2 0\n"
                     "%4 = lookup 0 %0\n%5 = lookup2 1 %0 %1\n%6 = sin %0\n";
  text += chain(7, 2000);
  text += "%2000 = returned %3 0\n%2001 = returned %3 1\nresult 0 %2000\nresult 1 %2001\nresult 2 %4\nresult 3 %5\n"
          "result 4 %1999\n";
  Graph const graph = read_graph(text, "test");
  CallExternal const call = [](std::size_t, std::span<double const> arguments, std::span<double> results) {
    results[0] = std::modf(arguments[0], &results[1]);
  };
  Compiled const compiled = compile(graph);
  for (double x : {-1e300, -1.0, 0.0, 0.5, 1.0, 2.75, 3.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> const input = {x, -x}, output = compiled.run(input, 5);
    std::vector<double> const expected = evaluate_sample(graph, input, {}, call).outputs;
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(output[i] == expected[i] || (std::isnan(output[i]) && std::isnan(expected[i]))) << i << " at " << x;
  }
}

// Integers of 64 bits that other chunks read are kept by their bits, among them such as are no number.
TEST_P(Emit, IntegersOf64BitsCrossChunks) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [2]\noutput \"y\" [4]\n%0 = input 0\n%1 = input 1\n"
                     "%2 = wide_int %0\n%3 = wide 1481765933 1284865837\n%4 = wide_mul %2 %3\n%5 = wide_less %4 %2\n"
                     "%6 = sin %0\n%7 = wide_value %4\n";
  text += chain(8, 6000);
  text += "%6000 = wide_add %4 %2\n%6001 = wide_low %6000\n%6002 = wide_select %5 %4 %2\n%6003 = wide_value %6002\n"
          "result 0 %6001\nresult 1 %6003\nresult 2 %5999\nresult 3 %7\n";
  Graph const graph = read_graph(text, "test");
  EXPECT_NE(emit(schedule(graph), *find_language("c"), {.base_name = "k"})[0].text.find("keep_integer(&v["),
            std::string::npos);
  Compiled const compiled = compile(graph);
  for (double x : {-1.0, 0.0, 1.0, 2.0, 12345.0, -98765.0, 0x1p62, 4503599627370495.0}) {
    std::vector<double> const input = {x, 1 - x}, output = compiled.run(input, 4);
    std::vector<double> const expected = evaluate_sample(graph, input, {}).outputs;
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(output[i], expected[i]) << i << " at " << x;
  }
}

// Long enough for many chunks, with values that live in one, cross some, and are truth values.
TEST(EmittedC, ALongFunctionIsCutAndComputesTheSame) {
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
  std::string const source = emit(schedule(graph), *find_language("c"), {.base_name = "k"})[0].text;
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

TEST(EmittedC, ConstantsReadBackToTheSameBits) {
  for (double value : {0.0, -0.0, 1.0, 0.1, -1e300, 5e-324, 1.7976931348623157e308, 123456789012345680.0, 1e22}) {
    std::string const text = constant(*find_language("c"), value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)), std::bit_cast<std::uint64_t>(value))
        << text;
    EXPECT_NE(text.find_first_of(".e"), std::string::npos) << text << " is an integer in C";
    EXPECT_EQ(parse_number(shortest(value)), value);
  }
  EXPECT_EQ(constant(*find_language("c"), INFINITY), "INFINITY");
  EXPECT_EQ(constant(*find_language("c"), -INFINITY), "-INFINITY");
  EXPECT_EQ(constant(*find_language("c"), NAN), "NAN");
  EXPECT_EQ(constant(*find_language("c"), -NAN), "-NAN");
}

// Arms of arms that are computed in turns, so that blocks alternate and nest.
TEST(EmittedC, ArmsComputedInTurnsCompileAndComputeTheSame) {
  std::mt19937 random(1);
  auto below = [&random](std::size_t end) { return random() % end; };
  for (int program = 0; program < 25; ++program) {
    std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\" [4]\noutput \"y\" [3]\n", results;
    std::size_t count = 0;
    auto add = [&](std::string const &operation) {
      text += "%" + std::to_string(count) + " = " + operation + "\n";
      return " %" + std::to_string(count++);
    };
    std::vector<std::vector<std::string>> arms;
    for (int k = 0; k < 4; ++k) arms.push_back({add("input " + std::to_string(k))});
    std::string const c = add("gt" + arms[0][0] + " 0"), d = add("lt" + arms[1][0] + arms[2][0]),
                      e = program % 2 ? add("logical_and" + c + d) : d;
    for (int step = 0; step < 40; ++step) {
      std::vector<std::string> &arm = arms[below(arms.size())];
      auto number = [&] { return arm[below(arm.size())]; };
      char const *const calls[] = {"sqrt", "exp", "log"}, *const operators[] = {"mul", "sub", "div"};
      arm.push_back(below(2) ? add(calls[below(3)] + number()) : add(operators[below(3)] + number() + number()));
    }
    for (int k = 0; k < 3; ++k) {
      std::string all[4];
      for (int i = 0; i < 4; ++i)
        all[i] = arms[i][arms[i].size() - 1 - below(std::min<std::size_t>(arms[i].size(), 3))];
      std::string const yes = add("select" + e + all[0] + all[1]), no = add("select" + d + all[2] + all[3]);
      results += "result " + std::to_string(k) + add("select" + c + yes + no) + "\n";
    }
    Graph const graph = read_graph(text + results, "test");
    Compiled const compiled(graph, "gcc");
    for (int sample = 0; sample < 16; ++sample) {
      std::vector<double> input;
      for (int k = 0; k < 4; ++k) input.push_back(static_cast<double>(below(9)) - 4);
      std::vector<double> const values = evaluate(graph, input, {}), output = compiled.run(input, 3);
      for (std::size_t k = 0; k < 3; ++k) {
        double const expected = values[graph.results[k]];
        EXPECT_TRUE(output[k] == expected || (std::isnan(output[k]) && std::isnan(expected))) << text;
      }
    }
  }
}

TEST(EmittedC, ADeepChainNeedsNoDeepStackAndNoLongLines) {
  std::string text = "symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n%0 = input 0\n";
  std::size_t const depth = 200000;
  for (std::size_t k = 1; k <= depth; ++k) text += "%" + std::to_string(k) + " = sin %" + std::to_string(k - 1) + "\n";
  Graph const graph = read_graph(text + "result 0 %" + std::to_string(depth) + "\n", "test");
  std::string const source = emit(schedule(graph), *find_language("c"), {})[0].text;
  EXPECT_NE(source.find("sin(sin("), std::string::npos);
  for (std::size_t at = 0; at < source.size();) {
    std::size_t const end = std::min(source.find('\n', at), source.size());
    EXPECT_LT(end - at, 200u);
    at = end + 1;
  }
}

} // namespace
} // namespace symreal
