// Watch on accesses to given memory: bytes that a piece of a program reads before it writes them, and bytes that it
// writes, by any instruction: compiled code of others, atomic operations, inline assembly, the C library.
//
// The pages of that memory are protected. An access raises SIGSEGV; the handler notes its address, opens the page, and
// lets the processor carry out the one instruction (SIGTRAP), behind which the page is closed again. An access is known
// by its first byte in a page alone. A system call on such memory fails with EFAULT, so the watched process should be a
// fork.
//
// Linux on x86-64 only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace symreal::memory {

struct WatchedBytes {
  char *begin;
  std::size_t size;
};

struct Access {
  char *address;
  bool is_read_first, is_written;
  bool is_named;              // met while names were looked up
  std::uintptr_t instruction; // of the first access, relative to where the program is loaded
};

void const *code_at(Access const &access);

// False where this machine or program cannot be watched: nothing has begun then. `bytes`: by address, disjoint.
bool begin_watching_accesses(std::vector<WatchedBytes> const &bytes);
// Reads from now on look up the meaning of a name, such as the length of a section; or no longer do.
void watch_names(bool are_looked_up);
struct Accesses {
  std::vector<Access> all; // by address
  bool are_complete;       // else there are too many, or a page was met so often that it was watched no further
};
Accesses end_watching_accesses();

} // namespace symreal::memory
