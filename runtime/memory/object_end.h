// End of the object at an address.
#pragma once

namespace symreal::memory {

// The byte behind the static object or heap block around the address; on the stack, the end of the callers' frames; for
// an unknown address, the end of its word.
char const *object_end(void const *address);

// The constant that the address lies in. One without a symbol, a literal, has all that lies between its neighbours.
struct Constant {
  char const *begin, *end;
};
Constant constant_around(void const *address);

} // namespace symreal::memory
