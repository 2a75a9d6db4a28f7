// The enumeration of operations, from the table. The leaves come first; they are not operations and stand in no table.
#pragma once

#include <cstdint>

namespace symreal {

enum class Op : std::uint8_t {
  constant,
  input,
  parameter,
#define OPERATION(id, ...) id,
#include <symreal/operations.def>
#undef OPERATION
  count
};

} // namespace symreal
