// Eigen's NumTraits of RealNumber. A forward declaration of the template suffices, so every source may include this.
//
// The costs are exactly double's: they decide unrolling, and unrolling decides in which order a sum is taken.
#pragma once

#include <symreal/standard_library.h>

namespace Eigen {

template <typename T> struct NumTraits;

template <> struct NumTraits<symreal::RealNumber> {
  using Real = symreal::RealNumber;
  using NonInteger = symreal::RealNumber;
  using Nested = symreal::RealNumber;
  using Literal = symreal::RealNumber;
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static constexpr Real epsilon() { return std::numeric_limits<double>::epsilon(); }
  static constexpr Real dummy_precision() { return 1e-12; }
  static constexpr Real highest() { return std::numeric_limits<double>::max(); }
  static constexpr Real lowest() { return std::numeric_limits<double>::lowest(); }
  static constexpr Real infinity() { return std::numeric_limits<double>::infinity(); }
  static constexpr Real quiet_NaN() { return std::numeric_limits<double>::quiet_NaN(); }
  static constexpr int digits10() { return std::numeric_limits<double>::digits10; }
  static constexpr int digits() { return std::numeric_limits<double>::digits; }
  static constexpr int min_exponent() { return std::numeric_limits<double>::min_exponent; }
  static constexpr int max_exponent() { return std::numeric_limits<double>::max_exponent; }
};

} // namespace Eigen
