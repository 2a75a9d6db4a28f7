#include "memory/object_end.h"

#include "memory/heap_blocks.h"
#include "memory/static_objects.h"

#include <algorithm>
#include <pthread.h>

namespace symreal::memory {
namespace {

// The last one that begins at or before the address, if it reaches it.
template <class Object> char const *end_among(std::vector<Object> const &objects, char const *address) {
  auto const behind = std::upper_bound(objects.begin(), objects.end(), address,
                                       [](char const *at, Object const &one) { return at < one.begin; });
  if (behind == objects.begin()) return nullptr;
  char const *const end = (behind - 1)->begin + (behind - 1)->size;
  return address < end ? end : nullptr;
}

char const *end_of_stack(char const *address) {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return nullptr;
  void *begin = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &begin, &size);
  pthread_attr_destroy(&attributes);
  char const *const first = static_cast<char const *>(begin);
  return first <= address && address < first + size ? first + size : nullptr;
}

} // namespace

char const *object_end(void const *address) {
  char const *const at = static_cast<char const *>(address);
  static std::vector<StaticObject> const statics = find_static_objects();
  if (char const *end = end_of_stack(at)) return end;
  if (char const *end = end_among(heap_blocks(), at)) return end;
  if (char const *end = end_among(statics, at)) return end;
  return at + 1;
}

} // namespace symreal::memory
