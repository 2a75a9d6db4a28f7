// The functions of <cmath> on RealNumber (symreal/real_math.h) that are rows of the operation table.
#include "runtime/trace/nodes/pool.h"

#include <symreal/library_formulas.h>
#include <symreal/real_math.h>

#include <cmath>
#include <numeric>

namespace symreal {

double detail::midpoint(double a, double b) noexcept { return std::midpoint(a, b); }

#define SYMREAL_CALL_1(id, evaluate)                                                                                   \
  RealNumber id(RealNumber real_x) noexcept {                                                                          \
    ++detail::executed[static_cast<unsigned>(Op::id)];                                                                 \
    if (real_x.is_node()) return trace::record_call(Op::id, real_x, 0.0, 0.0, __builtin_return_address(0));            \
    double x = real_x.plain();                                                                                         \
    return evaluate;                                                                                                   \
  }
#define SYMREAL_CALL_2(id, evaluate)                                                                                   \
  RealNumber id(RealNumber real_x, RealNumber real_y) noexcept {                                                       \
    ++detail::executed[static_cast<unsigned>(Op::id)];                                                                 \
    if (real_x.is_node() || real_y.is_node())                                                                          \
      return trace::record_call(Op::id, real_x, real_y, 0.0, __builtin_return_address(0));                             \
    double x = real_x.plain(), y = real_y.plain();                                                                     \
    return evaluate;                                                                                                   \
  }
#define SYMREAL_CALL_3(id, evaluate)                                                                                   \
  RealNumber id(RealNumber real_x, RealNumber real_y, RealNumber real_z) noexcept {                                    \
    ++detail::executed[static_cast<unsigned>(Op::id)];                                                                 \
    if (real_x.is_node() || real_y.is_node() || real_z.is_node())                                                      \
      return trace::record_call(Op::id, real_x, real_y, real_z, __builtin_return_address(0));                          \
    double x = real_x.plain(), y = real_y.plain(), z = real_z.plain();                                                 \
    return evaluate;                                                                                                   \
  }
#define MATH_OPERATION(id, arity, evaluate) SYMREAL_CALL_##arity(id, evaluate)
#include <symreal/math_functions.def>

} // namespace symreal
