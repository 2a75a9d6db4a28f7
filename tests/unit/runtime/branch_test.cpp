// The macros of decisions, as the rewriter writes them, recorded once and evaluated on both sides.
#pragma GCC diagnostic ignored "-Wparentheses" // rewritten programs are compiled without warnings
#pragma GCC diagnostic ignored "-Wshadow"
#define MBD_SYMBOLIC
#include <symreal/real.h>

#include "engine/graph/evaluate.h"
#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/nodes/pool.h"

#include <array>
#include <gtest/gtest.h>

namespace symreal {
namespace {

using trace::Guards;
using trace::Pool;

class Decided : public testing::Test {
protected:
  void SetUp() override {
    trace::session().pool.begin();
    trace::session().guards.begin();
    x = trace::session().pool.leaf(Node::input(0), 0.5);
    y = trace::session().pool.leaf(Node::input(1), 2.0);
  }
  void TearDown() override { trace::session().pool.end(); }

  static std::vector<double> values(double x_value, double y_value) {
    Graph graph;
    for (NodeId id = 0; id < trace::session().pool.nodes().size(); ++id)
      graph.nodes.push_back(trace::session().pool.nodes()[id]);
    double const inputs[] = {x_value, y_value};
    return evaluate(graph, inputs, {});
  }
  static double at(RealNumber result, double x_value, double y_value) {
    NodeId id = trace::session().pool.node(result);
    return values(x_value, y_value)[id];
  }
  static std::vector<Guard> guards() {
    Graph graph;
    trace::session().guards.end(graph);
    return graph.guards;
  }

  DecisionScope policy{Decisions::select};
  RealNumber x, y;
};

TEST_F(Decided, ChooseSelects) {
  RealNumber r = REAL_COND(x > y) REAL_THEN x - y REAL_ELSE 3 REAL_END;
  EXPECT_EQ(symreal_value(r), 3);
  EXPECT_EQ(at(r, 5, 1), 4);
  EXPECT_EQ(at(r, 1, 5), 3);
}

TEST_F(Decided, ChooseOnOrdinaryNumbersIsTheConditional) {
  RealNumber one = 1, two = 2;
  RealNumber r = REAL_COND(one < two) REAL_THEN one REAL_ELSE two REAL_END;
  EXPECT_FALSE(r.is_node());
  int k = REAL_COND(2 < 1) REAL_THEN 1 REAL_ELSE 2 REAL_END;
  EXPECT_EQ(k, 2);
  EXPECT_TRUE(guards().empty());
}

TEST_F(Decided, BothArmsBecomeOne) {
  struct Pair {
    RealNumber a, b;
  } pair = {1, 2};
  RealNumber row[3] = {1, 2, 3};
  std::array<RealNumber, 2> list = {5, 6};
  REAL_IF((pair)(row)(list), x > 0 REAL_AND y < 1) {
    pair.a = x;
    row[1] += y;
  }
  else list[0] = row[2] * pair.b;
  EXPECT_EQ(symreal_value(list[0]), 6); // the carried values are those of the arm that the program takes
  EXPECT_EQ(at(pair.a, 4, 0.5), 4);
  EXPECT_EQ(at(pair.a, -4, 0.5), 1);
  EXPECT_EQ(at(row[1], 4, 0.5), 2.5);
  EXPECT_EQ(at(list[0], 4, 0.5), 5);
  EXPECT_EQ(at(list[0], 4, 5), 6);
  EXPECT_FALSE(row[0].is_node());
}

TEST_F(Decided, OtherPoliciesTakeOneArm) {
  DecisionScope guard(Decisions::guard);
  RealNumber r = 1;
  REAL_IF((r), x > y) r = x;
  else r = y;
  EXPECT_EQ(r.to_bits(), y.to_bits());
  EXPECT_EQ(guards().size(), 1u);
}

TEST_F(Decided, AGuardInAnArmHoldsThereAlone) {
  RealNumber r = 1;
  REAL_IF((r), x > 0) { REAL_DECISIONS(guard) if (y > 1) r = 7; }
  std::vector<Guard> const found = guards();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(values(1, 0)[found[0].condition], 0);
  EXPECT_EQ(values(-1, 0)[found[0].condition], 1);
  EXPECT_EQ(values(1, 2)[found[0].condition], 1);
}

RealNumber staircase(RealNumber x, RealNumber y) {
  SYMREAL_RETURNS
  RealNumber s = 1;
  REAL_RETURN_IF((s), x > 0) {
    REAL_RETURN_IF(, y > 0) REAL_RETURN(x * y);
    s = y;
  }
  else REAL_RETURN_IF(, y > 1) REAL_RETURN(s + y);
  else s = 2;
  for (int k = 0; k < 2; ++k) REAL_RETURN_IF(, s < k) REAL_RETURN(10 + k);
  REAL_RETURN(s * x);
  SYMREAL_RETURNS_END
}

TEST_F(Decided, EarlyReturns) {
  RealNumber r = staircase(x, y);
  EXPECT_EQ(symreal_value(r), 1);
  EXPECT_EQ(at(r, 3, 4), 12);
  EXPECT_EQ(at(r, -3, 4), 5);
  EXPECT_EQ(at(r, -3, 0), -6);
  EXPECT_EQ(at(r, 3, -1), 10);
  EXPECT_EQ(at(r, 3, -0.0), 11);
}

TEST_F(Decided, ABoundedLoop) {
  RealNumber s = x;
  int k = 0;
  REAL_LOOP(4, (s))
  for (; REAL_TEST(s < y REAL_AND k < 100); ++k) {
    s += 1;
    REAL_BREAK(s > 3) break;
    s *= 2;
  }
  for (double start : {0.5, 1.5, 2.9, 7.0}) {
    double expected = start;
    while (expected < 2) {
      expected += 1;
      if (expected > 3) break;
      expected *= 2;
    }
    EXPECT_EQ(at(s, start, 2), expected) << start;
  }
  std::vector<Guard> const found = guards();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(values(0.5, 2)[found[0].condition], 1);
  EXPECT_EQ(values(-100, 2)[found[0].condition], 0);
}

TEST_F(Decided, TruthValuesAreNumbers) {
  RealNumber sign = (x > 0) - (x < 0), step = x * (y > 0), both = 2.0 * (x > 0) + 1;
  EXPECT_EQ(at(sign, -2, 0), -1);
  EXPECT_EQ(at(sign, 0, 0), 0);
  EXPECT_EQ(at(step, 3, 1), 3);
  EXPECT_EQ(at(step, 3, -1), 0);
  EXPECT_EQ(at(both, 3, -1), 3);
  EXPECT_EQ(at(select((x > 0) == (y > 0), 1, 0), -1, -2), 1);
  EXPECT_TRUE(guards().empty());
  DecisionScope guard(Decisions::guard);
  int whole = (x > 0) - (x < 0);
  EXPECT_EQ(whole, 1);
  EXPECT_FALSE(guards().empty());
}

TEST_F(Decided, ExtremesAreSelectsUnderEveryPolicy) {
  for (Decisions each : {Decisions::error, Decisions::guard, Decisions::select}) {
    DecisionScope scope(each);
    RealNumber larger = std::max(x, y), least = std::min({x, y, RealNumber(1)}), held = std::clamp(x, y, RealNumber(9));
    RealNumber written_out = std::max<RealNumber>(x, 0);
    EXPECT_EQ(at(larger, 3, 4), 4);
    EXPECT_EQ(at(least, 3, -4), -4);
    EXPECT_EQ(at(held, 30, 4), 9);
    EXPECT_EQ(at(written_out, -3, 4), 0);
  }
  EXPECT_TRUE(guards().empty());
}

} // namespace
} // namespace symreal
