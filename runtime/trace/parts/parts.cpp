#include "runtime/trace/parts/parts.h"

namespace symreal::trace {

constinit thread_local Parts *parts_of_thread = nullptr;

} // namespace symreal::trace
