#include <symreal/annotate.h>
#include <symreal/symbolic.h>

#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/nodes/pool.h"

#include <symreal/decisions.h>

#include <bit>
#include <cmath>
#include <complex>
#include <cstring>
#include <gtest/gtest.h>
#include <sstream>

namespace symreal {
namespace {

using trace::Pool;

class Recording : public testing::Test {
protected:
  void SetUp() override {
    trace::session().pool.begin();
    x = trace::session().pool.leaf(Node::input(0), 0.5);
    y = trace::session().pool.leaf(Node::input(1), 2.0);
    p = trace::session().pool.leaf(Node::parameter(0), 3.0);
  }
  void TearDown() override { trace::session().pool.end(); }

  RealNumber x, y, p;
};

TEST(RealNumberLayout, IsADouble) {
  EXPECT_EQ(sizeof(RealNumber[5]), sizeof(double[5]));
  RealNumber numbers[3];
  std::memset(numbers, 0, sizeof numbers);
  EXPECT_EQ(numbers[1].plain(), 0.0);
  EXPECT_FALSE(numbers[1].is_node());
  constexpr RealNumber folded = RealNumber(2) * RealNumber(3.0f) - RealNumber(1u);
  static_assert(folded.plain() == 5.0);
  EXPECT_EQ(static_cast<int>(folded), 5);
  enum class Gear { neutral, first, fifth = 5 };
  EXPECT_TRUE(static_cast<Gear>(folded) == Gear::fifth);
}

TEST_F(Recording, NodesSurviveBytewiseCopies) {
  RealNumber sum = x + y, copy;
  std::memcpy(&copy, &sum, sizeof copy);
  EXPECT_TRUE(copy.is_node());
  EXPECT_EQ(copy.to_bits(), sum.to_bits());
  EXPECT_EQ(symreal_value(copy), 2.5);
}

TEST_F(Recording, EqualComputationsAreOneNode) {
  std::size_t const before = SymbolicExprPool::size();
  RealNumber a = sin(x) * y, b = sin(x) * y;
  EXPECT_EQ(a.to_bits(), b.to_bits());
  EXPECT_EQ(SymbolicExprPool::size(), before + 2);
}

TEST_F(Recording, ConstantsAreOrdinaryNumbers) {
  RealNumber a = 2.0;
  EXPECT_FALSE((a * 3 + 1).is_node());
  EXPECT_EQ((a * 3 + 1).plain(), 7.0);
  EXPECT_FALSE(sin(a).is_node());
}

TEST_F(Recording, AttributesSpread) {
  EXPECT_TRUE(SymbolicExpr(RealNumber(1.0)).is_constant());
  EXPECT_TRUE(SymbolicExpr(p * 2.0).is_parametric());
  EXPECT_TRUE(SymbolicExpr(p * x).is_variable());
  EXPECT_TRUE(SymbolicExpr(-x).is_negative());
  EXPECT_EQ(SymbolicExpr(sin(x)).name(), "sin");
}

// Every overload that the table gives: the carried value is the reference's.
TEST_F(Recording, FunctionsCarryTheirValues) {
#define SYMREAL_SAME(id, real, reference)                                                                              \
  EXPECT_TRUE((real).is_node());                                                                                       \
  EXPECT_TRUE(std::isnan(reference) || symreal_value(real) == (reference)) << #id
#define SYMREAL_CHECK_1(id) SYMREAL_SAME(id, std::id(x), evaluate(Op::id, 0.5, 0, 0));
#define SYMREAL_CHECK_2(id)                                                                                            \
  SYMREAL_SAME(id, std::id(x, y), evaluate(Op::id, 0.5, 2.0, 0));                                                      \
  SYMREAL_SAME(id, id(x, 2), evaluate(Op::id, 0.5, 2.0, 0));                                                           \
  SYMREAL_SAME(id, id(0.25, x), evaluate(Op::id, 0.25, 0.5, 0));
#define SYMREAL_CHECK_3(id) SYMREAL_SAME(id, std::id(x, y, p), evaluate(Op::id, 0.5, 2.0, 3.0));
#define MATH_OPERATION(id, arity, evaluate) SYMREAL_CHECK_##arity(id)
#include <symreal/math_functions.def>
#undef MATH_OPERATION
}

TEST_F(Recording, MixedArithmeticAndAssignment) {
  RealNumber sum = 1 + x;
  sum += 2;
  sum -= y;
  sum *= 4.0f;
  sum /= 2L;
  ++sum;
  EXPECT_EQ(symreal_value(sum), (1 + 0.5 + 2 - 2.0) * 4 / 2 + 1);
  EXPECT_EQ(symreal_value(-sum), -symreal_value(sum));
  EXPECT_EQ(symreal_value(max(x, y)), 2.0);
  EXPECT_EQ(symreal_value(std::min(x, RealNumber(0.1))), 0.1);
  RealNumber integer;
  EXPECT_EQ(symreal_value(modf(sum, &integer)), 0.0);
}

TEST_F(Recording, ComplexNumbersAreTraced) {
  std::complex<RealNumber> z(x, y), w = z * z + std::complex<RealNumber>(1.0, 0.0);
  EXPECT_EQ(symreal_value(w.real()), 0.25 - 4.0 + 1.0);
  EXPECT_EQ(symreal_value(w.imag()), 2.0);
  EXPECT_TRUE(w.real().is_node());
}

TEST_F(Recording, PrintsTheCarriedValue) {
  std::ostringstream out;
  out << x + y << ' ' << std::to_string(x);
  EXPECT_EQ(out.str(), "2.5 0.500000");
  std::istringstream in("4.5");
  in >> x;
  EXPECT_EQ(x.plain(), 4.5);
}

TEST(RealNumberLimits, AreDoubles) {
  EXPECT_EQ(std::numeric_limits<RealNumber>::epsilon().plain(), std::numeric_limits<double>::epsilon());
  EXPECT_EQ(std::numeric_limits<RealNumber>::max().plain(), std::numeric_limits<double>::max());
  EXPECT_TRUE(std::numeric_limits<RealNumber>::is_specialized);
}

// Conditions combine without deciding; a side that is no node disappears.
TEST_F(Recording, ConditionsAreNodes) {
  SymbolicBool const both = (x < y) & (y < 3.0);
  ASSERT_TRUE(both.is_symbolic());
  Node const &node = trace::session().pool.nodes()[trace::session().pool.node(both.condition())];
  EXPECT_EQ(node.op, Op::logical_and);
  EXPECT_EQ((SymbolicBool(true) & (x < y)).condition().to_bits(), (x < y).condition().to_bits());
  EXPECT_FALSE((SymbolicBool(true) | (x < y)).is_symbolic());
  EXPECT_EQ(trace::session().pool.nodes()[trace::session().pool.node((!both).condition())].op, Op::logical_not);
}

// The premise that every value is finite settles these.
TEST_F(Recording, FiniteTestsAreSettled) {
  EXPECT_FALSE(isnan(x).is_symbolic());
  EXPECT_FALSE(isnan(x));
  EXPECT_TRUE(isfinite(x));
  EXPECT_FALSE(isinf(x * y));
  EXPECT_TRUE(x == x);
  EXPECT_FALSE((x == x).is_symbolic());
  EXPECT_TRUE((x == y).is_symbolic());
}

TEST_F(Recording, GuardPolicyRecordsThePath) {
  trace::Guards &guards = trace::session().guards;
  guards.begin();
  {
    DecisionScope const scope(Decisions::guard);
    EXPECT_EQ(static_cast<bool>(x < y), symreal_value(x) < symreal_value(y));
    EXPECT_EQ(static_cast<bool>(x < y), symreal_value(x) < symreal_value(y)); // again: nothing new
    EXPECT_EQ(static_cast<int>(y), static_cast<int>(symreal_value(y)));
    PathScope const path(x < 100.0);
    EXPECT_TRUE(y < 50.0);
  }
  Graph graph;
  guards.end(graph);
  ASSERT_EQ(graph.guards.size(), 3u);
  auto op = [&](std::size_t guard) { return trace::session().pool.nodes()[graph.guards[guard].condition].op; };
  EXPECT_EQ(op(1), Op::eq);
  EXPECT_EQ(op(2), Op::logical_or); // where the path is not taken, it need not hold
  EXPECT_EQ(graph.locations.size(), 3u);
  EXPECT_FALSE(graph.locations[0].addresses.empty());
}

TEST(Columns, CostNothingWhenUnused) {
  Pool &pool = trace::session().pool;
  pool.begin({.values = true, .places = false});
  RealNumber const x = pool.leaf(Node::input(0), 2.0);
  (void)(x * x);
  EXPECT_TRUE(pool.take_places().empty());
  pool.begin({.values = false, .places = true});
  RealNumber const y = pool.leaf(Node::input(0), 2.0);
  RealNumber const square = y * y;
  LongArray<std::uint32_t> const places = pool.take_places();
  ASSERT_EQ(places.size(), pool.nodes().size());
  EXPECT_NE(places.back(), 0u);
  EXPECT_TRUE(trace::is_missing(pool.carried_value(square)));
  pool.end();
}

using RecordingDeathTest = Recording;

// Arithmetic that is not instrumented quiets the NaN, an uninstrumented fabs clears its sign: both are leaks.
TEST_F(RecordingDeathTest, LeaksAreCaught) {
  EXPECT_EXIT(
      {
        double bits = x.plain();
        double volatile leaked = bits + 1.0;
        (void)(y * RealNumber(leaked));
      },
      testing::ExitedWithCode(1), "came back from code that was not rewritten.*\\[SYM055\\]");
  EXPECT_EXIT(
      {
        std::uint64_t const cleared = x.to_bits() & ~(std::uint64_t{1} << 63);
        (void)(y * RealNumber::from_bits(cleared));
      },
      testing::ExitedWithCode(1), "came back from code that was not rewritten.*\\[SYM055\\]");
}

TEST_F(RecordingDeathTest, StaleNodesAreCaught) {
  RealNumber const old = x;
  trace::session().pool.end();
  trace::session().pool.begin();
  RealNumber const fresh = trace::session().pool.leaf(Node::input(0), 1.0);
  EXPECT_EXIT((void)(fresh + old), testing::ExitedWithCode(1), "another kernel or thread.*\\[SYM054\\]");
}

TEST_F(RecordingDeathTest, AMissingValueIsNeeded) {
  RealNumber const unknown = trace::session().pool.leaf(Node::input(2), missing_value());
  EXPECT_TRUE((unknown * y + x).is_node());
  EXPECT_EXIT((void)symreal_value(unknown * y), testing::ExitedWithCode(1), "has no value.*\\[SYM056\\]");
  EXPECT_EXIT((void)static_cast<bool>(unknown < x), testing::ExitedWithCode(1), "has no value.*\\[SYM056\\]");
}

} // namespace
} // namespace symreal
