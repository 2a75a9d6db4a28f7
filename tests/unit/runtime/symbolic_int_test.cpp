// Every operator on every pair of integer types: what is recorded, what the passes make of it, and what the generated C
// computes must be what the compiler makes of plain integers.
#include <symreal/symbolic.h>

#include "compiled_graph.h"
#include "engine/graph/evaluate.h"
#include "engine/graph/validate.h"
#include "engine/optimise/passes/pass.h"
#include "runtime/trace/nodes/pool.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>

// The comparisons of plain integers below are meant.
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"

namespace symreal {
namespace {

using trace::Pool;
using Bits = std::uint64_t;
using Results = std::vector<std::optional<Bits>>; // by sample; nothing where the language leaves it open

template <class... Types> struct List {
  template <class Visit> static void each(Visit visit) { (visit(Types()), ...); }
};
using All = List<char, signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long, long long,
                 unsigned long long>;
using Widths = List<signed char, unsigned char, short, unsigned short, int, unsigned, long, unsigned long>;

// Corners of every type, among them what a double cannot hold.
std::vector<Bits> const corners = {0,
                                   1,
                                   2,
                                   3,
                                   7,
                                   31,
                                   63,
                                   0x7F,
                                   0x80,
                                   0xFF,
                                   0x7FFF,
                                   0x8000,
                                   0xFFFF,
                                   1664525,
                                   0x7FFFFFFF,
                                   0x80000000,
                                   0xFFFFFFFF,
                                   0x100000001,
                                   (1ull << 53) - 1,
                                   (1ull << 53) + 1,
                                   6364136223846793005u,
                                   0x7FFFFFFFFFFFFFFF,
                                   1ull << 63,
                                   0xFFFFFFFF80000000,
                                   0xFFFFFFFFFFFFFFF9,
                                   0xFFFFFFFFFFFFFFFE,
                                   0xFFFFFFFFFFFFFFFF};
std::vector<Bits> const constants = {0, 1, 5, 0xFFFF, 0x80000000, (1ull << 53) + 1, 0xFFFFFFFFFFFFFFFF};

template <class T> std::string name() { return (std::is_signed_v<T> ? "int" : "uint") + std::to_string(8 * sizeof(T)); }

// Records computations on integers, each made of two inputs, its halves.
class Schedule {
public:
  explicit Schedule(unsigned operands) {
    trace::session().pool.begin();
    for (unsigned k = 0; k < 2 * operands; ++k) inputs_.push_back(trace::session().pool.leaf(Node::input(k), 1.0));
  }

  template <class T> SymbolicInt<T> operand(unsigned k) const {
    SymbolicInt<unsigned long> const high(inputs_[2 * k]), low(inputs_[2 * k + 1]);
    if constexpr (sizeof(T) == 8)
      return SymbolicInt<T>(high << 32 | low);
    else
      return SymbolicInt<T>(SymbolicInt<long>(inputs_[2 * k + 1])); // of a real number
  }

  template <class R> void result(std::string name, SymbolicInt<R> value, Results expected) {
    SymbolicInt<unsigned long> const bits(value);
    results_.push_back((bits >> 32).number());
    results_.push_back((bits & 0xFFFFFFFFu).number());
    expected_.push_back({std::move(name), std::move(expected)});
  }
  void result(std::string name, SymbolicBool value, Results expected) {
    result(std::move(name), SymbolicInt<int>::from_held(select(value, 1.0, 0.0)), std::move(expected));
  }

  // Compares with the graph as it is, with that of the passes, and with its C. The samples are the operands' bits.
  void check(std::vector<std::vector<Bits>> const &samples) {
    Graph const graph = end();
    EXPECT_EQ(find_violation(graph), "");
    Graph const finite = run_passes(graph, default_passes(), FloatingPoint::finite);
    Graph const strict = run_passes(graph, default_passes(), FloatingPoint::strict);
    Compiled const gcc(finite, "gcc"), clang(strict, "clang-19");
    compared_ = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::vector<double> inputs;
      for (Bits bits : samples[k]) {
        inputs.push_back(static_cast<double>(bits >> 32));
        inputs.push_back(static_cast<double>(bits & 0xFFFFFFFFu));
      }
      expect(samples[k], k, evaluate_sample(graph, inputs, {}).outputs, "as recorded");
      expect(samples[k], k, evaluate_sample(finite, inputs, {}).outputs, "in mode finite");
      expect(samples[k], k, evaluate_sample(strict, inputs, {}).outputs, "in mode strict");
      expect(samples[k], k, gcc.run(inputs, results_.size()), "by gcc");
      expect(samples[k], k, clang.run(inputs, results_.size()), "by clang");
    }
    EXPECT_GT(compared_, 3 * expected_.size() * samples.size());
  }

private:
  Graph end() {
    Graph graph;
    graph.kernel = "k";
    auto const object = [](std::string label, std::size_t count) {
      return Object{.label = std::move(label), .extents = {count}, .count = static_cast<std::uint32_t>(count)};
    };
    graph.inputs = {object("x", inputs_.size())};
    graph.outputs = {object("y", results_.size())};
    graph.input_values.assign(inputs_.size(), 1.0);
    for (RealNumber result : results_) graph.results.push_back(trace::session().pool.node(result));
    graph.nodes = trace::session().pool.end();
    return graph;
  }

  void expect(std::vector<Bits> const &operands, std::size_t sample, std::vector<double> const &outputs,
              char const *how) {
    for (std::size_t k = 0; k < expected_.size(); ++k) {
      std::optional<Bits> const expected = expected_[k].second[sample];
      if (!expected) continue;
      ++compared_;
      Bits const computed = static_cast<Bits>(outputs[2 * k]) << 32 | static_cast<Bits>(outputs[2 * k + 1]);
      if (computed == *expected) continue;
      std::string text = expected_[k].first + " " + how + " at";
      for (Bits bits : operands) text += " " + std::to_string(static_cast<std::int64_t>(bits));
      ADD_FAILURE() << text << " is " << static_cast<std::int64_t>(computed) << ", not "
                    << static_cast<std::int64_t>(*expected);
    }
  }

  std::vector<RealNumber> inputs_, results_;
  std::vector<std::pair<std::string, Results>> expected_;
  std::size_t compared_ = 0;
};

template <class C> bool divides(C a, C b) {
  return b != 0 && !(std::is_signed_v<C> && a == std::numeric_limits<C>::min() && b == C(-1));
}
template <class T, class U> bool shifts(U n) { return n >= 0 && static_cast<Bits>(n) < 8 * sizeof(+T()); }
#define WITHOUT_OVERFLOW(name) (std::is_unsigned_v<C> || !__builtin_##name##_overflow(C(a), C(b), &unused))

// `statement` says what becomes of r for operands a and b.
#define COMPARE(text, symbolic, plain, defined)                                                                        \
  {                                                                                                                    \
    Results expected;                                                                                                  \
    for (Bits p : corners)                                                                                             \
      for (Bits q : seconds) {                                                                                         \
        T a = T(p);                                                                                                    \
        U const b = U(q);                                                                                              \
        [[maybe_unused]] C unused;                                                                                     \
        expected.push_back(defined ? std::optional(static_cast<Bits>(plain)) : std::nullopt);                          \
      }                                                                                                                \
    T a(1);                                                                                                            \
    static_assert(std::is_same_v<decltype(symbolic), SymbolicInt<std::decay_t<decltype(plain)>>> ||                    \
                  (std::is_same_v<decltype(symbolic), SymbolicBool> && std::is_same_v<decltype(plain), bool>));        \
    program.result(pair + text, symbolic, std::move(expected));                                                        \
  }
#define BINARY(op, defined) COMPARE(#op, x op y, a op b, defined)
#define ASSIGNED(op, defined) COMPARE(#op, SymbolicInt<T>(SymbolicInt<T>(x) op y), (a op b), defined)

template <class T, class U, class Y>
void record_pair(Schedule &program, SymbolicInt<T> x, Y y, std::vector<Bits> const &seconds, U b = U(1)) {
  using C = detail::Common<T, U>;
  std::string const pair = name<T>() + " " + name<U>() + " ";
  BINARY(+, WITHOUT_OVERFLOW(add))
  BINARY(-, WITHOUT_OVERFLOW(sub))
  BINARY(*, WITHOUT_OVERFLOW(mul))
  BINARY(/, divides<C>(a, b))
  BINARY(%, divides<C>(a, b))
  BINARY(&, true)
  BINARY(|, true)
  BINARY(^, true)
  BINARY(<<, shifts<T>(b))
  BINARY(>>, shifts<T>(b))
  BINARY(<, true)
  BINARY(<=, true)
  BINARY(>, true)
  BINARY(>=, true)
  BINARY(==, true)
  BINARY(!=, true)
  ASSIGNED(+=, WITHOUT_OVERFLOW(add))
  ASSIGNED(-=, WITHOUT_OVERFLOW(sub))
  ASSIGNED(*=, WITHOUT_OVERFLOW(mul))
}

TEST(SymbolicInts, ComputeAsEveryPairOfTypes) {
  std::vector<std::vector<Bits>> samples;
  for (Bits a : corners)
    for (Bits b : corners) samples.push_back({a, b});
  Widths::each([&]<class T>(T) {
    Schedule program(2);
    Widths::each(
        [&]<class U>(U) { record_pair<T, U>(program, program.operand<T>(0), program.operand<U>(1), corners); });
    program.check(samples);
  });
}

TEST(SymbolicInts, ComputeWithConstants) {
  std::vector<std::vector<Bits>> samples;
  for (Bits a : corners) samples.push_back({a});
  List<short, int, unsigned, long, unsigned long>::each([&]<class T>(T) {
    Schedule program(1);
    List<int, unsigned, long, unsigned long>::each([&]<class U>(U) {
      for (Bits constant : constants)
        record_pair<T, U>(program, program.operand<T>(0), static_cast<U>(constant), {constant});
    });
    program.check(samples);
  });
}

// The type of a result is that of the language, for types that only differ in name, too.
TEST(SymbolicInts, HaveTheLanguagesTypes) {
  All::each([]<class T>(T) {
    All::each([]<class U>(U) {
      static_assert(std::is_same_v<decltype(SymbolicInt<T>() + SymbolicInt<U>()), SymbolicInt<decltype(T() + U())>>);
      static_assert(std::is_same_v<decltype(T() - SymbolicInt<U>()), SymbolicInt<decltype(T() - U())>>);
      static_assert(std::is_same_v<decltype(SymbolicInt<T>() % U(1)), SymbolicInt<decltype(T() % U(1))>>);
      static_assert(std::is_same_v<decltype(SymbolicInt<T>() << U(1)), SymbolicInt<decltype(T() << U(1))>>);
    });
    static_assert(std::is_same_v<decltype(-SymbolicInt<T>()), SymbolicInt<decltype(-T())>>);
  });
}

#define ALONE(text, symbolic, plain, defined)                                                                          \
  {                                                                                                                    \
    Results expected;                                                                                                  \
    for (Bits p : corners) {                                                                                           \
      T a = T(p);                                                                                                      \
      expected.push_back(defined ? std::optional(static_cast<Bits>(plain)) : std::nullopt);                            \
    }                                                                                                                  \
    SymbolicInt<T> a = x;                                                                                              \
    program.result(name<T>() + " " text, symbolic, std::move(expected));                                               \
  }
#define UNARY(expression, defined) ALONE(#expression, expression, expression, defined)

// Conversions to every type and to double, signs, counting.
template <class T> void record_alone(Schedule &program, SymbolicInt<T> x) {
  All::each([&]<class R>(R) { ALONE("converted", SymbolicInt<R>(a), R(a), true) });
  constexpr bool wraps = std::is_unsigned_v<T> || sizeof(T) < sizeof(int);
  [[maybe_unused]] constexpr T least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
  UNARY(-a, wraps || a != least)
  UNARY(+a, true)
  UNARY(~a, true)
  UNARY(++a, wraps || a != most)
  UNARY(--a, wraps || a != least)
  UNARY((a++, a), wraps || a != most)
  ALONE("as double", SymbolicInt<long>(a * 0.25), long(a * 0.25), true)
  ALONE("as float", SymbolicInt<long>(a * 0.1f), long(a * 0.1f), true)
}

TEST(SymbolicInts, ConvertAndCount) {
  std::vector<std::vector<Bits>> samples;
  for (Bits a : corners) samples.push_back({a});
  All::each([&]<class T>(T) {
    Schedule program(1);
    record_alone<T>(program, program.operand<T>(0));
    program.check(samples);
  });
}

// A conversion of a real number gives what the host's instruction gives, in its range and beyond, and no -0.
// The conversion of x86-64. What the language leaves open is that of gcc: Clang has another answer from 2^64 on.
template <class R> __attribute__((no_sanitize("float-cast-overflow"))) R converted_by_host(double value) {
  if (std::is_unsigned_v<R> && sizeof(R) == 8 && value >= 0x1p64) return 0;
  return static_cast<R>(value);
}

TEST(SymbolicInts, ConvertRealNumbersAsTheHost) {
  std::vector<double> const values = {0.0,
                                      -0.0,
                                      0.5,
                                      -0.5,
                                      -0.99,
                                      1.0,
                                      -1.0,
                                      -2.7,
                                      127.9,
                                      128.0,
                                      255.5,
                                      270.0,
                                      -129.0,
                                      32767.5,
                                      54000.0,
                                      65535.9,
                                      70000.0,
                                      -40000.0,
                                      2147483647.5,
                                      2147483648.0,
                                      -2147483648.9,
                                      -2147483649.0,
                                      4294967295.5,
                                      4294967296.0,
                                      1e10,
                                      -1e10,
                                      9007199254740993.0,
                                      0x1p62,
                                      0x1p63,
                                      -0x1p63,
                                      0x1.8p63,
                                      0x1p64,
                                      1e300,
                                      -1e300,
                                      INFINITY,
                                      -INFINITY,
                                      NAN};
  All::each([&]<class R>(R) {
    trace::session().pool.begin();
    SymbolicInt<R> const converted(trace::session().pool.leaf(Node::input(0), 1.0));
    NodeId const result = trace::session().pool.node(converted.number());
    Graph graph;
    graph.kernel = "k";
    graph.inputs = {Object{.label = "x", .extents = {}}};
    graph.outputs = {Object{.label = "y", .extents = {}}};
    graph.input_values = {1.0};
    graph.results = {result};
    graph.nodes = trace::session().pool.end();
    graph = run_passes(graph, default_passes(), FloatingPoint::strict);
    Compiled const clang(graph, "clang-19");
    for (double volatile value : values) {
      Bits const expected = std::bit_cast<Bits>(static_cast<double>(converted_by_host<R>(value)));
      EXPECT_EQ(std::bit_cast<Bits>(evaluate_sample(graph, std::vector<double>{value}, {}).outputs[0]), expected)
          << name<R>() << " of " << value;
      EXPECT_EQ(std::bit_cast<Bits>(clang.run({value}, 1)[0]), expected) << name<R>() << " of " << value << " in C";
    }
  });
}

} // namespace
} // namespace symreal
