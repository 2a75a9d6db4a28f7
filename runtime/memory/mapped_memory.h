// Record of memory that the program maps past the heap; the runtime cannot tell which part of it is in use.
#pragma once

namespace symreal::memory {

// Whether the program has a writable mapping.
bool has_mapped_memory();
void note_mapped_memory();

} // namespace symreal::memory
