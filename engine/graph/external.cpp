#include "engine/graph/external.h"

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
constexpr std::array complex_functions = {
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

std::size_t table_index(double index, std::size_t extent) {
  if (!(index > 0)) return 0;
  return index < static_cast<double>(extent) ? static_cast<std::size_t>(index) : extent - 1;
}

double look_up(Table const &table, double row, double column) {
  std::size_t at = table_index(row, table.extents[0]);
  if (table.extents.size() == 2) at = at * table.extents[1] + table_index(column, table.extents[1]);
  return table.values[at];
}

std::size_t External::argument_count() const {
  std::size_t count = 0;
  for (ExternalValue const &parameter : parameters)
    if (parameter.is_given()) count += parameter.count;
  return count;
}

std::size_t External::result_count() const {
  std::size_t count = returned_count();
  for (ExternalValue const &parameter : parameters)
    if (parameter.kind == ExternalValue::Kind::output || parameter.kind == ExternalValue::Kind::updated)
      count += parameter.count;
  return count;
}

bool External::takes_integer(std::size_t argument) const {
  for (ExternalValue const &parameter : parameters) {
    if (!parameter.is_given()) continue;
    if (argument < parameter.count) return parameter.kind == ExternalValue::Kind::integer;
    argument -= parameter.count;
  }
  return false;
}

std::vector<std::size_t> External::number_arguments() const {
  std::vector<std::size_t> numbers;
  std::size_t const count = argument_count();
  for (std::size_t argument = 0; argument < count; ++argument)
    if (!takes_integer(argument)) numbers.push_back(argument);
  return numbers;
}

std::optional<External> External::derivative() const {
  using Kind = ExternalValue::Kind;
  if (derivatives.empty()) return std::nullopt;
  External result{derivatives.front().name, pure, {}, {}, place, {derivatives.begin() + 1, derivatives.end()}};
  for (ExternalValue parameter : parameters) {
    if (!parameter.is_given()) continue;
    if (parameter.kind == Kind::updated) parameter.kind = Kind::input;
    result.parameters.push_back(parameter);
  }
  auto const partials = static_cast<std::uint32_t>(result_count() * number_arguments().size());
  if (derivatives.front().is_returned)
    result.returned.kind = Kind::number;
  else
    result.parameters.push_back({Kind::output, partials});
  return result;
}

ComplexFunctionInfo const &info(ComplexFunction function) {
  return complex_functions[static_cast<std::size_t>(function)];
}

External external_of(ComplexFunction function) {
  External external{std::string(info(function).name), true, {}, {}, {}};
  external.parameters.assign(std::size_t{2} * info(function).arity, {ExternalValue::Kind::number, 1, {}});
  external.parameters.push_back({ExternalValue::Kind::output, 2, {}});
  return external;
}

std::optional<ComplexFunction> find_complex_function(External const &external) {
  auto const found = std::find_if(complex_functions.begin(), complex_functions.end(),
                                  [&](ComplexFunctionInfo const &known) { return known.name == external.name; });
  if (found == complex_functions.end()) return std::nullopt;
  auto const function = static_cast<ComplexFunction>(found - complex_functions.begin());
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
