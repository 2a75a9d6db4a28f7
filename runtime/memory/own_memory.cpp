#include "runtime/memory/own_memory.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <link.h>
#include <pthread.h>
#include <sys/mman.h>
#include <unistd.h>

namespace symreal {

__thread bool detail::recording = false;
__thread std::uintptr_t detail::own_stack = 0, detail::own_stack_size = 0;
__thread std::uintptr_t detail::around_begin = 0, detail::around_size = 0;

memory::Stack memory::Stack::of_this_thread() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
  void *begin = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &begin, &size);
  pthread_attr_destroy(&attributes);
  char *const first = static_cast<char *>(begin);
  return {first, first + size};
}

namespace trace {

void find_own_stack(void const *frame) {
  memory::Stack const stack = memory::Stack::of_this_thread();
  internal_check(stack.end != nullptr);
  detail::around_begin = detail::around_size = 0;
  auto const at = reinterpret_cast<std::uintptr_t>(frame);
  detail::own_stack = reinterpret_cast<std::uintptr_t>(stack.begin);
  detail::own_stack_size = std::min(at - detail::own_stack, stack.size());
}

void widen_around(void const *begin, std::size_t size) {
  auto const at = reinterpret_cast<std::uintptr_t>(begin), end = at + size;
  bool const is_first = detail::around_size == 0;
  std::uintptr_t const last = is_first ? end : std::max(end, detail::around_begin + detail::around_size);
  detail::around_begin = is_first ? at : std::min(at, detail::around_begin);
  detail::around_size = last - detail::around_begin;
}

namespace {

struct ConstantPart {
  MemoryRange range;
  bool has_code; // a linker may put constants and code side by side
};
std::vector<ConstantPart> find_constant_parts() {
  std::vector<ConstantPart> found;
  dl_iterate_phdr(
      [](dl_phdr_info *object, std::size_t, void *list) {
        for (int i = 0; i < object->dlpi_phnum; ++i) {
          auto const &part = object->dlpi_phdr[i];
          bool const constant = (part.p_type == PT_LOAD && (part.p_flags & PF_W) == 0) || part.p_type == PT_GNU_RELRO;
          std::uintptr_t const begin = object->dlpi_addr + part.p_vaddr;
          if (constant)
            static_cast<std::vector<ConstantPart> *>(list)->push_back(
                {{begin, begin + part.p_memsz}, (part.p_flags & PF_X) != 0});
        }
        return 0;
      },
      &found);
  return found;
}

} // namespace

std::vector<MemoryRange> find_constant_memory() {
  std::vector<MemoryRange> found;
  for (ConstantPart const &part : find_constant_parts()) found.push_back(part.range);
  return found;
}

bool make_writable(void const *begin, std::size_t size) {
  memory::OwnWork const own;
  static std::vector<ConstantPart> const constant = find_constant_parts();
  auto const part = std::find_if(constant.begin(), constant.end(),
                                 [begin](ConstantPart const &one) { return one.range.contains(begin); });
  if (part == constant.end()) return true;
  auto const page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  std::uintptr_t const at = reinterpret_cast<std::uintptr_t>(begin), first = at / page * page;
  int const protection = PROT_READ | PROT_WRITE | (part->has_code ? PROT_EXEC : 0);
  return mprotect(reinterpret_cast<void *>(first), at + size - first, protection) == 0;
}

} // namespace trace
} // namespace symreal
