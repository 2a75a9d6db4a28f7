// Tables of constants and external functions, which opaque operations refer to by number; functions of complex numbers
// among them.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <symreal/complex_function.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Constants that `lookup` and `lookup2` read, row by row. Each index is truncated and clamped to its extent, so every
// access is in bounds.
struct Table {
  std::string name;
  std::vector<std::size_t> extents; // one or two
  std::vector<double> values;
  Place place = {};
};

// Index into a table: truncated and clamped to the extent. A NaN counts as 0.
std::size_t table_index(double index, std::size_t extent);
double look_up(Table const &table, double row, double column);

// One parameter of an external function, or its return value. `count`: number of doubles in an object, flattened over
// its arrays and structs.
struct ExternalValue {
  enum class Kind {
    none,    // return value only: void
    number,  // a double
    integer, // `type` is its C type
    input,   // behind a pointer, read
    output,  // behind a pointer, written
    updated, // behind a pointer, read and written
    object   // a struct by value
  };
  Kind kind = Kind::none;
  std::uint32_t count = 1;
  std::string type = {};

  bool operator==(ExternalValue const &) const = default;
  bool is_given() const { return kind != Kind::none && kind != Kind::output; }
  bool is_pointer() const { return kind == Kind::input || kind == Kind::output || kind == Kind::updated; }
};

// Another function of the program, which gives the partial derivatives of one. It takes the parameters of that
// function, except for output parameters, and returns the only partial derivative, or writes all into an array, its
// last parameter: for each numeric argument in turn, all results.
struct DerivativeFunction {
  std::string name;
  bool is_returned = false;

  bool operator==(DerivativeFunction const &) const = default;
};

// A function with C linkage. A call takes a flat list of arguments, the numbers of each parameter except outputs in
// order, and has a flat list of results: the return value, then the written numbers, in order.
struct External {
  std::string name;
  bool pure = false; // deterministic and without side effects
  ExternalValue returned;
  std::vector<ExternalValue> parameters;
  Place place = {};
  std::vector<DerivativeFunction> derivatives = {}; // the first derivative, its derivative, ...

  std::size_t argument_count() const;
  std::size_t returned_count() const { return returned.kind == ExternalValue::Kind::none ? 0 : returned.count; }
  std::size_t result_count() const;
  // Whether this argument of the flat list is a parameter of integer type.
  bool takes_integer(std::size_t argument) const;
  // Arguments of the flat list that are numbers, and thus differentiable.
  std::vector<std::size_t> number_arguments() const;
  // The first derivative function, with the higher ones as its derivatives; nullopt if it is unknown.
  std::optional<External> derivative() const;
};

// Functions of complex numbers (include/symreal/complex_functions.def) as external functions of a graph. Arguments and
// results are lists of real and imaginary parts; every evaluator can call them.

struct ComplexFunctionInfo {
  std::string_view name; // in a graph
  unsigned arity;
  bool is_infix;
  std::string_view c;
  bool has_cut;
};

ComplexFunctionInfo const &info(ComplexFunction function);

External external_of(ComplexFunction function);
std::optional<ComplexFunction> find_complex_function(External const &external);

// Reference semantics: the C library's functions and the compiler's operators.
void evaluate(ComplexFunction function, std::span<double const> arguments, std::span<double> results);

} // namespace symreal
