#include "engine/graph/complex_function.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <array>

namespace symreal {

namespace {

using Complex = __complex__ double;

// Declarations as in C's <complex.h>, which that of C++ replaces.
namespace c_library {
#define SYMREAL_FORM_infix(arity, c)
#define SYMREAL_FORM_call(arity, c) SYMREAL_CALL_##arity(c)
#define SYMREAL_CALL_1(c) extern "C" Complex c(Complex);
#define SYMREAL_CALL_2(c) extern "C" Complex c(Complex, Complex);
#define COMPLEX_FUNCTION(id, arity, form, c, has_cut) SYMREAL_FORM_##form(arity, c)
#include <symreal/complex_functions.def>
#undef COMPLEX_FUNCTION
#undef SYMREAL_FORM_infix
#undef SYMREAL_FORM_call
#undef SYMREAL_CALL_1
#undef SYMREAL_CALL_2
} // namespace c_library

constexpr bool infix = true, call = false;
constexpr std::array table = {
#define COMPLEX_FUNCTION(id, arity, form, c, has_cut)                                                                  \
  ComplexFunctionInfo{"symreal_complex_" #id, arity, form, #c, has_cut},
#include <symreal/complex_functions.def>
#undef COMPLEX_FUNCTION
};

Complex number(std::span<double const> parts) {
  Complex result;
  __real__ result = parts[0];
  __imag__ result = parts[1];
  return result;
}

Complex evaluate(ComplexFunction function, Complex x, [[maybe_unused]] Complex y) {
  switch (function) {
#define SYMREAL_FORM_infix(arity, c) x c y
#define SYMREAL_FORM_call(arity, c) SYMREAL_CALL_##arity(c)
#define SYMREAL_CALL_1(c) c_library::c(x)
#define SYMREAL_CALL_2(c) c_library::c(x, y)
#define COMPLEX_FUNCTION(id, arity, form, c, has_cut)                                                                  \
  case ComplexFunction::id: return SYMREAL_FORM_##form(arity, c);
#include <symreal/complex_functions.def>
#undef COMPLEX_FUNCTION
#undef SYMREAL_FORM_infix
#undef SYMREAL_FORM_call
#undef SYMREAL_CALL_1
#undef SYMREAL_CALL_2
  }
  internal_failure("no function of complex numbers", __FILE__, __LINE__);
}

} // namespace

ComplexFunctionInfo const &info(ComplexFunction function) { return table[static_cast<std::size_t>(function)]; }

External external_of(ComplexFunction function) {
  External external{std::string(info(function).name), true, {}, {}, {}};
  external.parameters.assign(std::size_t{2} * info(function).arity, {ExternalValue::Kind::number, 1, {}});
  external.parameters.push_back({ExternalValue::Kind::output, 2, {}});
  return external;
}

std::optional<ComplexFunction> find_complex_function(External const &external) {
  auto const found = std::find_if(table.begin(), table.end(),
                                  [&](ComplexFunctionInfo const &known) { return known.name == external.name; });
  if (found == table.end()) return std::nullopt;
  auto const function = static_cast<ComplexFunction>(found - table.begin());
  bool const is_as_known = external.pure && external.returned == ExternalValue{ExternalValue::Kind::none, 1, {}} &&
                           external.parameters == external_of(function).parameters;
  return is_as_known ? std::optional(function) : std::nullopt;
}

void evaluate(ComplexFunction function, std::span<double const> arguments, std::span<double> results) {
  Complex const x = number(arguments), y = info(function).arity == 2 ? number(arguments.subspan(2)) : x;
  Complex const result = evaluate(function, x, y);
  results[0] = __real__ result;
  results[1] = __imag__ result;
}

} // namespace symreal
