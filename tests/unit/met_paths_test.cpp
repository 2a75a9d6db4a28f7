// Which paths given samples take.
#include "program/record/met_paths.h"

#include "tests/unit/runtime/own_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace symreal;
using program::MetPaths;
using program::Outcomes;
using program::RecordedPath;

namespace {

// x > 0, recorded at x = 1, and where that holds x > 5.
RecordedPath path(Outcomes const &outcomes) {
  NodeTable table;
  NodeId const x = table.intern(Node::input(0));
  NodeId const positive = table.intern(table.operation(Op::gt, x, table.constant(0)));
  NodeId const large = table.intern(table.operation(Op::gt, x, table.constant(5)));
  RecordedPath path;
  path.graph.kernel = "f";
  path.graph.inputs = {{"x", {}, 0}};
  path.graph.input_values = {1};
  path.graph.outputs = {{"y", {}}};
  path.graph.results = {x};
  path.graph.nodes = table.release();
  path.steps = {{positive, outcomes[0] == 't', false, outcomes[0] == 'j', "x > 0"}};
  if (outcomes.size() > 1) path.steps.push_back({large, outcomes[1] == 't', false, outcomes[1] == 'j', "x > 5"});
  return path;
}

std::optional<Outcomes> corrected(Outcomes const &outcomes, std::string const &table) {
  std::string const file = test::own_file("met_paths.csv");
  std::ofstream(file) << table;
  RecordedPath one = path(outcomes);
  MetPaths const met(file, one.graph);
  std::filesystem::remove(file);
  met.note(one);
  return MetPaths::correction(one);
}

} // namespace

TEST(MetPaths, SamplesGoWhereTheyGo) {
  EXPECT_EQ(corrected("tf", "x\n2\n3\n"), std::nullopt);
  EXPECT_EQ(corrected("tf", "x\n7\n"), std::nullopt); // the recorded value takes this path, another sample the other
}

TEST(MetPaths, APathThatNoSampleTakesIsLeft) { EXPECT_EQ(corrected("tt", "x\n2\n"), Outcomes("tf")); }

TEST(MetPaths, WaysComeTogetherWhereSamplesTakeBoth) {
  EXPECT_EQ(corrected("jf", "x\n-2\n3\n"), std::nullopt);
  EXPECT_EQ(corrected("jj", "x\n-2\n3\n"), Outcomes("jf"));
  EXPECT_EQ(corrected("j", "x\n2\n"), Outcomes("t"));
}
