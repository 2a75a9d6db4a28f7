// Memory that a program gets from the system past the heap: nobody knows which part of it is in use.
#pragma once

namespace symreal::memory {

// Whether the program has some that can be written.
bool has_mapped_memory();
void note_mapped_memory();

} // namespace symreal::memory
