// How far the object reaches that an address lies in.
#pragma once

namespace symreal::memory {

// Behind the last byte of the static object or heap block around the address; of the stack, the end of what its
// callers have there. Where nothing is known of the address, the word there is all.
char const *object_end(void const *address);

// The constant that the address lies in. One without a symbol, a literal, has all that lies between its neighbours.
struct Constant {
  char const *begin, *end;
};
Constant constant_around(void const *address);

} // namespace symreal::memory
