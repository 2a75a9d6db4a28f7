// What opaque operations refer to by number: tables of constants, and functions of libraries that are not recorded.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace symreal {

// The constants that `lookup` and `lookup2` read, row by row. Each index is truncated and moved into its extent, so
// nothing outside is ever read.
struct Table {
  std::string name;
  std::vector<std::size_t> extents; // one or two
  std::vector<double> values;
  Place place = {};
};

// One parameter of an external function, or what it returns. Objects of doubles count theirs, whatever arrays and
// structs they form.
struct ExternalValue {
  enum class Kind {
    none,    // returned only: nothing
    number,  // a double
    integer, // `type` is its name in C
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

// Another function of the program, which gives the partial derivatives of one: it takes what that takes, without what
// that only writes, and returns the one partial derivative that there is, or writes all into an array, its last
// parameter: one result of that function behind the other, by each number that it takes.
struct DerivativeFunction {
  std::string name;
  bool is_returned = false;

  bool operator==(DerivativeFunction const &) const = default;
};

// A function with C linkage. A call takes a flat list of arguments, the numbers of each parameter that is given in
// order, and has a flat list of results: what is returned, then what is written, in order.
struct External {
  std::string name;
  bool pure = false; // equal arguments give equal results, and nothing else happens
  ExternalValue returned;
  std::vector<ExternalValue> parameters;
  Place place = {};
  std::vector<DerivativeFunction> derivatives = {}; // its first, the first of that, ...

  std::size_t argument_count() const;
  std::size_t returned_count() const { return returned.kind == ExternalValue::Kind::none ? 0 : returned.count; }
  std::size_t result_count() const;
  // Whether this one of the flat list of arguments is a parameter of integer type.
  bool takes_integer(std::size_t argument) const;
  // Of the flat list of arguments, those that it can have derivatives by.
  std::vector<std::size_t> number_arguments() const;
  // The first of its derivatives, which has the others.
  std::optional<External> derivative() const;
};

} // namespace symreal
