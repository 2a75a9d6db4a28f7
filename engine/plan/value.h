// Values and arrays of a plan: kinds of values, arrays that functions read and fill, and the memory that these are in.
#pragma once

#include "engine/ops/operation.h"

#include <optional>
#include <string_view>

namespace symreal {

enum class ValueKind : std::uint8_t {
#define VALUE_KIND(kind, syntax) kind,
#include "engine/plan/value_kinds.def"
#undef VALUE_KIND
};
std::string_view name_of(ValueKind kind);
std::optional<ValueKind> find_value_kind(std::string_view name);

// Kind of an operation's value.
ValueKind kind_of(Op op);

// Memory that an array is in. A device adds its own, beside these of the host.
enum class Space : std::uint8_t {
  argument, // the caller's, read; results may overlap it
  result,   // the caller's, filled
  work,     // the function's own
  constant, // the file's own
};

// Arrays that functions read and fill. `memory` holds what the steps of loops store, `values` are tables of numbers.
enum class Array : std::uint8_t {
  parameters,
  input,
  constants,
  computed_angle,
  sine,
  cosine,
  output,
  memory,
  values,
};
std::optional<Array> find_array(std::string_view name);
std::string_view name_of(Array array);
Space space_of(Array array);
inline bool is_argument(Array array) { return space_of(array) == Space::argument; }

struct Element {
  Array array;
  std::size_t index;
};

} // namespace symreal
