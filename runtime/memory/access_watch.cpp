#include "runtime/memory/access_watch.h"

#include "runtime/memory/heap_blocks.h"

#include <algorithm>

#if defined(__linux__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

#include <csignal>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

extern "C" char const __ehdr_start; // the linker's name for where this executable is loaded

namespace symreal::memory {
namespace {

constexpr std::uintptr_t page_size = 4096;
constexpr std::uint32_t most_of_page = 10000, most_faults = 40000; // then a page stays open
constexpr std::size_t most_open = 64;                              // pages that one instruction touches
constexpr std::size_t most_accesses = 1 << 14, table_size = 4 * most_accesses;

struct Page {
  std::uintptr_t begin;
  std::uint32_t faults;
};
struct Met {
  std::uintptr_t address, instruction;
  bool is_read_first, is_written, is_named;
};

// State of the handlers, in pages of its own: none of them may be a protected one.
struct alignas(page_size) Watch {
  Page *pages;
  std::size_t page_count;
  WatchedBytes *bytes;
  std::size_t byte_count;
  Met *met; // a hash table, by address
  std::size_t met_count;
  std::uintptr_t open[most_open];
  std::size_t open_count;
  std::uint32_t faults; // on all pages
  bool are_names;
  struct sigaction previous_fault, previous_step;
  stack_t previous_stack;
};
Watch watch;

// The functions of the C library are called through a table that may lie in a protected page.
long system_call(long number, long a, long b, long c) {
  long result = number;
  asm volatile("syscall" : "+a"(result) : "D"(a), "S"(b), "d"(c) : "rcx", "r11", "memory");
  return result;
}
void protect(std::uintptr_t page, int protection) {
  system_call(SYS_mprotect, static_cast<long>(page), page_size, protection);
}

template <class T> T *own_memory(std::size_t count) {
  void *memory = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : static_cast<T *>(memory);
}

std::uintptr_t begin_of(Page const &page) { return page.begin; }
std::uintptr_t begin_of(WatchedBytes const &bytes) { return reinterpret_cast<std::uintptr_t>(bytes.begin); }

// The last element that begins at the address or before it, or null. Instantiated in this file alone, so that it is
// called directly.
template <class T> T *last_before(T *all, std::size_t count, std::uintptr_t address) {
  std::size_t low = 0, high = count;
  while (low < high) {
    std::size_t const middle = low + (high - low) / 2;
    (begin_of(all[middle]) <= address ? low = middle + 1 : high = middle);
  }
  return low == 0 ? nullptr : &all[low - 1];
}

Page *page_of(std::uintptr_t address) {
  Page *page = last_before(watch.pages, watch.page_count, address);
  return page && address - page->begin < page_size ? page : nullptr;
}

bool is_watched(std::uintptr_t address) {
  WatchedBytes const *bytes = last_before(watch.bytes, watch.byte_count, address);
  return bytes && address - begin_of(*bytes) < bytes->size;
}

void note(std::uintptr_t address, bool is_write, std::uintptr_t instruction) {
  std::size_t at = address * 0x9E3779B97F4A7C15u >> 48 & (table_size - 1);
  while (watch.met[at].address != 0 && watch.met[at].address != address) at = (at + 1) & (table_size - 1);
  Met &met = watch.met[at];
  if (met.address == 0) {
    if (watch.met_count == most_accesses) return;
    ++watch.met_count;
    met = {address, instruction, !is_write, is_write, false};
  }
  met.is_named |= watch.are_names;
  met.is_written |= is_write;
}

void close_pages() {
  while (watch.open_count != 0) protect(watch.open[--watch.open_count], PROT_NONE);
}

void on_fault(int, siginfo_t *info, void *context) {
  auto &registers = static_cast<ucontext_t *>(context)->uc_mcontext.gregs;
  auto const address = reinterpret_cast<std::uintptr_t>(info->si_addr);
  Page *page = page_of(address);
  if (watch.open_count == most_open) close_pages();
  if (!page) { // the program's own
    struct sigaction action = {};
    action.sa_handler = SIG_DFL;
    sigaction(SIGSEGV, &action, nullptr);
    return;
  }
  constexpr greg_t writes = 2, single_step = 0x100;
  protect(page->begin, PROT_READ | PROT_WRITE);
  if (OwnWork::is_going_on()) return void(watch.open[watch.open_count++] = page->begin); // until it ends
  if (is_watched(address))
    note(address, (registers[REG_ERR] & writes) != 0, static_cast<std::uintptr_t>(registers[REG_RIP]));
  ++watch.faults;
  if (++page->faults > most_of_page || watch.faults > most_faults) return;
  watch.open[watch.open_count++] = page->begin;
  registers[REG_EFL] |= single_step;
}

void on_step(int, siginfo_t *, void *context) {
  constexpr greg_t single_step = 0x100;
  static_cast<ucontext_t *>(context)->uc_mcontext.gregs[REG_EFL] &= ~single_step;
  close_pages();
}

bool catch_signals() {
  constexpr std::size_t stack_size = 1 << 16;
  auto *memory = own_memory<char>(stack_size);
  if (!memory) return false;
  stack_t const stack = {.ss_sp = memory, .ss_flags = 0, .ss_size = stack_size};
  struct sigaction action = {};
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  action.sa_sigaction = on_fault;
  if (sigaltstack(&stack, &watch.previous_stack) != 0 || sigaction(SIGSEGV, &action, &watch.previous_fault) != 0)
    return false;
  action.sa_sigaction = on_step;
  return sigaction(SIGTRAP, &action, &watch.previous_step) == 0;
}

// The pages of the bytes, but for those of the thread's own variables, which the handlers use as well.
std::vector<std::uintptr_t> pages_of(std::vector<WatchedBytes> const &bytes) {
  constexpr std::uintptr_t around_thread = 4;
  auto const thread = reinterpret_cast<std::uintptr_t>(__builtin_thread_pointer()) / page_size;
  std::vector<std::uintptr_t> pages;
  for (WatchedBytes const &one : bytes) {
    auto const begin = reinterpret_cast<std::uintptr_t>(one.begin);
    for (std::uintptr_t page = begin / page_size; page * page_size < begin + one.size; ++page)
      if ((pages.empty() || pages.back() != page) && (page + around_thread < thread || thread + around_thread < page))
        pages.push_back(page);
  }
  return pages;
}

} // namespace

bool begin_watching_accesses(std::vector<WatchedBytes> const &bytes) {
  OwnWork const own;
  std::vector<std::uintptr_t> const pages = pages_of(bytes);
  if (sysconf(_SC_PAGESIZE) != static_cast<long>(page_size) || pages.empty()) return false;
  watch = {};
  watch.pages = own_memory<Page>(pages.size());
  watch.bytes = own_memory<WatchedBytes>(bytes.size());
  watch.met = own_memory<Met>(table_size);
  if (!watch.pages || !watch.bytes || !watch.met || !catch_signals()) return false;
  for (std::uintptr_t const page : pages) watch.pages[watch.page_count++] = {page * page_size, 0};
  for (WatchedBytes const &one : bytes) watch.bytes[watch.byte_count++] = one;
  for (std::size_t k = 0; k < watch.page_count; ++k) protect(watch.pages[k].begin, PROT_NONE);
  OwnWork::call_at_end(close_pages);
  return true;
}

void watch_names(bool are_looked_up) { watch.are_names = are_looked_up; }

Accesses end_watching_accesses() {
  OwnWork::call_at_end(nullptr);
  for (std::size_t k = 0; k < watch.page_count; ++k) protect(watch.pages[k].begin, PROT_READ | PROT_WRITE);
  OwnWork const own;
  sigaction(SIGSEGV, &watch.previous_fault, nullptr);
  sigaction(SIGTRAP, &watch.previous_step, nullptr);
  sigaltstack(&watch.previous_stack, nullptr);
  Accesses accesses{{}, watch.met_count < most_accesses && watch.faults <= most_faults};
  auto const base = reinterpret_cast<std::uintptr_t>(&__ehdr_start);
  for (std::size_t k = 0; k < table_size; ++k)
    if (Met const &met = watch.met[k]; met.address != 0)
      accesses.all.push_back({reinterpret_cast<char *>(met.address), met.is_read_first, met.is_written, met.is_named,
                              met.instruction - base});
  for (std::size_t k = 0; k < watch.page_count; ++k) accesses.are_complete &= watch.pages[k].faults <= most_of_page;
  std::ranges::sort(accesses.all, {}, &Access::address);
  munmap(watch.pages, watch.page_count * sizeof(Page));
  munmap(watch.bytes, watch.byte_count * sizeof(WatchedBytes));
  munmap(watch.met, table_size * sizeof(Met));
  return accesses;
}

void const *code_at(Access const &access) { return &__ehdr_start + access.instruction; }

} // namespace symreal::memory

#else

namespace symreal::memory {

bool begin_watching_accesses(std::vector<WatchedBytes> const &) { return false; }
void watch_names(bool) {}
void const *code_at(Access const &) { return nullptr; }
Accesses end_watching_accesses() { return {{}, true}; }

} // namespace symreal::memory

#endif
