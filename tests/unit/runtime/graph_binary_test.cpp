// The binary form of a graph keeps all that the text form keeps, and says so where it cannot be read.
#include "engine/graph/graph_binary.h"

#include "engine/graph/graph_text.h"
#include "engine/support/files.h"
#include "own_file.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>

using namespace symreal;

namespace {

char const *const everything = R"(symreal-graph 1
kernel "arm"
decisions guard
input "q[0:2]" [2] at "arm.cpp" 12 9 range -3.14 3.14 = 0.5 0.25
input "s" [2] { "mass" "com" [3] "joint" { "a" "d" } }
input "r" [3]
parameter "m" at "arm.cpp" 12 20 = 2
output "tau" [3] at "arm.cpp" 14 9
state "r" "tau" at "arm.cpp" 12 30
frozen "g" at "arm.cpp" 3 1 = 9.81
frozen "p" at "arm.cpp" 9 3 around = 2
table 0 "drag" [3] at "arm.cpp" 4 8 = 0.1 0.4 0.2
external 0 "force" returns number takes number integer "long" input 3 output 3 object 2 at "arm.cpp" 2 8
location 0 at "arm.cpp" 13 9 at "LLT.h" 300 7
location 1 stack 4711 815
executed mul 36
%0 = input 0
%1 = parameter 0
%2 = sin %0 @0
%3 = mul %2 10 @1 "lever"
%4 = lt %3 %1 @0
%5 = lookup 0 %2
result 0 %3
result 1 %5
result 2 -0
guard 0 %4 @0 "10*sin(q[0]) < m"
precomputed 0 %1
)";

std::string text_of(Graph const &graph) {
  std::ostringstream text;
  write_graph(text, graph);
  return text.str();
}

class BinaryGraph : public testing::Test {
protected:
  std::string const path = test::own_file("symreal-graph-binary-test");
  void SetUp() override { write_binary_graph(path, read_graph(everything, "arm.graph")); }
  void TearDown() override { std::filesystem::remove(path); }

  std::string refusal() const {
    try {
      read_binary_graph(path);
    } catch (DiagnosticError const &error) {
      EXPECT_EQ(error.diagnostic().id, DiagnosticId::graph_syntax);
      return error.diagnostic().message;
    }
    return "nothing was refused";
  }
};

TEST_F(BinaryGraph, KeepsAll) {
  Graph const graph = read_graph(everything, "arm.graph"), read = read_binary_graph(path);
  EXPECT_EQ(text_of(read), text_of(graph));
  EXPECT_EQ(read.nodes, graph.nodes);
}

// Of a recording that is not resolved yet.
TEST_F(BinaryGraph, KeepsWhatTheTextLeavesOut) {
  Graph graph = read_graph(everything, "arm.graph");
  graph.frozen[0].stack = {1, 2};
  write_binary_graph(path, graph);
  EXPECT_EQ(read_binary_graph(path).frozen[0].stack, graph.frozen[0].stack);
}

TEST_F(BinaryGraph, RefusesPartOfAFile) {
  std::string const whole = read_file(path);
  for (std::size_t const size : {whole.size() - 1, whole.size() / 2, std::size_t{40}}) {
    std::filesystem::resize_file(path, size);
    EXPECT_NE(refusal().find("not whole"), std::string::npos) << size;
  }
}

TEST_F(BinaryGraph, RefusesAnotherVersion) {
  write_if_changed(path, "symreal-binary-graph 0.0\n");
  EXPECT_NE(refusal().find("not of this version"), std::string::npos);
}

TEST_F(BinaryGraph, RefusesWhatIsNoGraph) {
  Graph graph = read_graph(everything, "arm.graph");
  graph.results[0] = 99;
  write_binary_graph(path, graph);
  EXPECT_FALSE(refusal().empty());
}

TEST_F(BinaryGraph, SaysWhereItCannotWrite) {
  EXPECT_THROW(write_binary_graph("/dev/full", read_binary_graph(path)), DiagnosticError);
  EXPECT_THROW(write_binary_graph("/nowhere/graph", read_binary_graph(path)), DiagnosticError);
}

} // namespace
