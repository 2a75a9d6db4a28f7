#include "runtime/memory/mapped_memory.h"

#include <atomic>

namespace symreal::memory {

static std::atomic<bool> is_mapped = false;

bool has_mapped_memory() { return is_mapped; }
void note_mapped_memory() { is_mapped = true; }

} // namespace symreal::memory
