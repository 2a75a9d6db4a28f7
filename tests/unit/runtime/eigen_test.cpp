// Eigen on RealNumber associates sums exactly as Eigen on double does: its traits have double's costs, which decide
// unrolling. Bit for bit, sizes 2 to 8, fixed and dynamic.
#define EIGEN_DONT_VECTORIZE
#include <symreal/symbolic.h>

#include <Eigen/Dense>

#include "runtime/trace/nodes/pool.h"

#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

using trace::Pool;

std::uint32_t slots = 0;
template <class Real> Real number(double value) {
  if constexpr (std::is_same_v<Real, double>)
    return value;
  else
    return trace::session().pool.leaf(Node::input(slots++), value);
}

template <class Real, int Size, int Declared> std::vector<double> results() {
  using Matrix = Eigen::Matrix<Real, Declared, Declared>;
  using Vector = Eigen::Matrix<Real, Declared, 1>;
  std::mt19937_64 random(Size);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix a(Size, Size), b(Size, Size);
  Vector v(Size), w(Size);
  for (int i = 0; i < Size; ++i) {
    v(i) = number<Real>(uniform(random)), w(i) = number<Real>(uniform(random));
    for (int j = 0; j < Size; ++j) {
      a(i, j) = number<Real>(uniform(random) + (i == j ? 3 : 0));
      b(i, j) = number<Real>(uniform(random));
    }
  }
  std::vector<double> values = {symreal_value(v.dot(w)), symreal_value(v.sum()), symreal_value(a.norm()),
                                symreal_value(v.squaredNorm()), symreal_value(a.trace())};
  Matrix const product = a * b, inverse = a.inverse(), scaled = 0.5 * a + b * 2.0;
  Vector const image = a * v, difference = a.transpose() * w - v / 3.0;
  for (int i = 0; i < Size; ++i) {
    values.insert(values.end(), {symreal_value(image(i)), symreal_value(difference(i))});
    for (int j = 0; j < Size; ++j)
      values.insert(values.end(),
                    {symreal_value(product(i, j)), symreal_value(inverse(i, j)), symreal_value(scaled(i, j))});
  }
  return values;
}

template <int Size> void compare() {
  EXPECT_EQ((results<RealNumber, Size, Size>()), (results<double, Size, Size>())) << "fixed " << Size;
  EXPECT_EQ((results<RealNumber, Size, Eigen::Dynamic>()), (results<double, Size, Eigen::Dynamic>()))
      << "dynamic " << Size;
}

TEST(Eigen, AssociatesAsOnDouble) {
  trace::session().pool.begin();
  compare<2>(), compare<3>(), compare<4>(), compare<5>(), compare<6>(), compare<7>(), compare<8>();
  trace::session().pool.end();
}

} // namespace
} // namespace symreal
