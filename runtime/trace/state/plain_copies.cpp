// Numbers that a function kernel returns or keeps, once it has ended.
#include "runtime/trace/nodes/pool.h"

#include <symreal/annotate.h>

namespace symreal {

void FunctionKernel::make_plain(void *object, std::size_t size) noexcept {
  if (trace::Pool const &pool = trace::Pool::current(); pool.is_recording()) pool.make_plain(object, size);
}

} // namespace symreal
