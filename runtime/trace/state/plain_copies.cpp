// Numbers that a function kernel returns or keeps, once it has ended.
#include "trace/nodes/pool.h"

#include <symreal/annotate.h>

namespace symreal {

void FunctionKernel::make_plain(void *object, std::size_t size) noexcept {
  trace::Pool &pool = trace::Pool::current();
  if (!pool.is_recording()) return;
  auto *numbers = static_cast<RealNumber *>(object);
  for (std::size_t k = 0; k < size / sizeof(RealNumber); ++k)
    if (pool.owns(numbers[k])) numbers[k] = pool.final_value(numbers[k]);
}

} // namespace symreal
