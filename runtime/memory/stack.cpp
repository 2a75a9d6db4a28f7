#include "runtime/memory/stack.h"

#include <pthread.h>

namespace symreal::memory {

Stack Stack::of_this_thread() {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
  void *begin = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &begin, &size);
  pthread_attr_destroy(&attributes);
  char *const first = static_cast<char *>(begin);
  return {first, first + size};
}

} // namespace symreal::memory
