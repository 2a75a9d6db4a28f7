#include "engine/optimise/algebra/value.h"

#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace symreal::algebra {
namespace {

TEST(PrimeField, ComputesAsWideIntegersDo) {
  __extension__ using Wide = unsigned __int128;
  std::mt19937_64 random(1);
  for (int k = 0; k < 10000; ++k) {
    Residue const a = k == 0 ? prime - 1 : random() % prime, b = k < 2 ? prime - 1 : random() % prime;
    EXPECT_EQ(multiply(a, b), static_cast<Residue>(static_cast<Wide>(a) * b % prime));
    EXPECT_EQ(add(a, b), static_cast<Residue>((static_cast<Wide>(a) + b) % prime));
    EXPECT_EQ(add(subtract(a, b), b), a);
    if (a != 0) EXPECT_EQ(multiply(a, inverse(a)), 1u);
  }
  EXPECT_EQ(inverse(Residue{0}), 0u);
}

TEST(PrimeField, InvertsSeveralAsEachByItself) {
  std::vector<Residue> all = {0, 1, 2, prime - 1, 0, random_residue(5), random_residue(6), 0};
  std::vector<Residue> expected;
  for (Residue const a : all) expected.push_back(inverse(a));
  invert(all);
  EXPECT_EQ(all, expected);
  invert({});
}

// So that no power of 2 that a double can hold is another one.
TEST(PrimeField, TwoGeneratesTheGroup) {
  EXPECT_EQ(power(2, (prime - 1) / 2), prime - 1);
  EXPECT_NE(power(2, 2), 1u);
  EXPECT_NE(residue_of(0x1p61), residue_of(1.0));
}

TEST(PrimeField, ADoubleIsItsRational) {
  EXPECT_EQ(multiply(residue_of(0.1), residue_of(0x1p55)), residue_of(0.1 * 0x1p55));
  EXPECT_EQ(add(residue_of(0.5), residue_of(-0.25)), residue_of(0.25));
  EXPECT_EQ(multiply(residue_of(-3.0), residue_of(7.0)), residue_of(-21.0));
  EXPECT_EQ(multiply(residue_of(0x1p-1074), residue_of(0x1p1023)), residue_of(0x1p-51));
}

TEST(Values, SquaresOfSineAndCosineAddUpToOne) {
  Value const angle = random_value(3), s = sine(angle), c = cosine(angle);
  EXPECT_TRUE(equal_in_field(s * s + c * c, value_of(1)));
  EXPECT_TRUE(confirmed(s * s + c * c, value_of(1), 1));
  EXPECT_TRUE(equal_in_field(sine(-angle), -s));
  EXPECT_TRUE(equal_in_field(cosine(-angle), c));
  EXPECT_TRUE(equal_in_field(cosine(value_of(0)), value_of(1)));
  EXPECT_FALSE(equal_in_field(sine(random_value(4)), s));
}

TEST(Values, ParametersStayWhereInputsChange) {
  Value const x = random_value(1), p = random_parameter(1);
  EXPECT_NE(x.field[0], x.field[1]);
  EXPECT_EQ(p.field[0], p.field[1]);
  EXPECT_NE(p.field[0], p.field[2]);
  EXPECT_TRUE(is_number(value_of(0.3) * value_of(7)));
  EXPECT_FALSE(is_number(p));
}

} // namespace
} // namespace symreal::algebra
