#include "runtime/memory/rollback.h"

#if defined(__linux__) && defined(__x86_64__) && defined(__GLIBC__)

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

// The place that the system writes to a thread at any time; null in an older library.
extern "C" {
[[gnu::weak]] extern std::ptrdiff_t const symreal_rseq_offset __asm__("__rseq_offset");
}

namespace symreal::memory {
namespace {

constexpr std::size_t page_size = 4096, rseq_size = 32;

void copy_pages(char *to, char const *from, std::size_t size) {
  for (std::size_t k = 0; k < size; k += page_size) {
    std::size_t const part = std::min(page_size, size - k);
    if (std::memcmp(to + k, from + k, part) != 0) std::memcpy(to + k, from + k, part);
  }
}

} // namespace

struct Rollback::State {
  Rollback const *owner;
  ucontext_t kept, away; // `away`: on a stack that no return changes
  unsigned long flags;   // of the processor
  bool is_back;
  alignas(16) char stack[1 << 14];
  char *bytes() { return reinterpret_cast<char *>(this + 1); }
};

void Rollback::add(char *begin, char *end) {
  if (begin >= end) return;
  regions_.push_back({begin, static_cast<std::size_t>(end - begin), size_});
  size_ += regions_.back().size;
}

// Whether all of it can be kept.
bool Rollback::list() {
  regions_.clear();
  size_ = 0;
  heap_end_ = sbrk(0);
  std::FILE *file = std::fopen("/proc/self/maps", "r");
  if (!file) return false;
  char line[512], rights[5];
  std::uintptr_t first = 0, last = 0;
  auto *const thread = static_cast<char *>(__builtin_thread_pointer());
  char *const rseq = &symreal_rseq_offset ? thread + symreal_rseq_offset : nullptr;
  bool is_whole = true;
  while (std::fgets(line, sizeof line, file)) {
    if (std::sscanf(line, "%zx-%zx %4s", &first, &last, rights) != 3 || rights[1] != 'w' || rights[3] != 'p') continue;
    is_whole &= rights[0] == 'r';
    auto *const begin = reinterpret_cast<char *>(first), *const end = reinterpret_cast<char *>(last);
    bool const is_stack = begin <= line && line < end;
    if (is_stack && std::string_view(line).find("[stack]") != std::string_view::npos) stack_ = begin;
    bool const has_rseq = begin <= rseq && rseq < end;
    add(begin, has_rseq ? rseq : end);
    if (has_rseq) add(rseq + rseq_size, end);
  }
  std::fclose(file);
  return is_whole && stack_ && sbrk(0) == heap_end_;
}

Rollback::Rollback(std::size_t most) {
  bool const is_listed = list() || list(); // the list itself takes memory
  if (!is_listed || size_ > most) return;
  long const memory = syscall(SYS_mmap, nullptr, sizeof(State) + size_, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, -1, 0); // mmap() would count as the program's
  if (memory != -1) state_ = reinterpret_cast<State *>(memory);
}

void Rollback::keep() {
  State &state = *state_;
  state.owner = this;
  state.flags = __builtin_ia32_readeflags_u64();
  state.is_back = false;
  getcontext(&state.kept);
  if (state.is_back) return;
  state.is_back = true;
  is_kept_ = sbrk(0) == heap_end_;
  for (Region const &one : regions_) copy_pages(state.bytes() + one.kept, one.begin, one.size);
}

void Rollback::go_back() {
  unsigned char is_resident = 0;
  bool const has_grown = syscall(SYS_mincore, stack_ - page_size, page_size, &is_resident) == 0;
  if (has_grown || !is_kept_) return;
  static State *state; // handed to the other stack
  state = state_;
  getcontext(&state->away);
  state->away.uc_stack.ss_sp = state->stack;
  state->away.uc_stack.ss_size = sizeof state->stack;
  state->away.uc_link = nullptr;
  auto *const enter = +[] { restore(*state); };
  makecontext(&state->away, enter, 0);
  setcontext(&state->away);
}

// Runs on a stack of its own: the other one is restored, too.
void Rollback::restore(State &state) {
  void *const heap_end = state.owner->heap_end_;
  if (sbrk(0) != heap_end) (void)syscall(SYS_brk, heap_end);
  for (Region const &one : state.owner->regions_) copy_pages(one.begin, state.bytes() + one.kept, one.size);
  __builtin_ia32_writeeflags_u64(state.flags);
  setcontext(&state.kept);
}

} // namespace symreal::memory

#else

symreal::memory::Rollback::Rollback(std::size_t) {}
void symreal::memory::Rollback::add(char *, char *) {}
void symreal::memory::Rollback::keep() {}
void symreal::memory::Rollback::go_back() {}

#endif
