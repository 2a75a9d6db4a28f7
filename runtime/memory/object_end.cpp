#include "runtime/memory/object_end.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/stack.h"
#include "runtime/memory/static_objects.h"

#include <algorithm>
#include <cstdint>

namespace symreal::memory {
namespace {

// The first that begins behind the address.
template <class Object> auto find_behind(std::vector<Object> const &objects, char const *address) {
  return std::upper_bound(objects.begin(), objects.end(), address,
                          [](char const *at, Object const &one) { return at < one.begin; });
}

// The last one that begins at or before the address, if it reaches it.
template <class Object> char const *end_among(std::vector<Object> const &objects, char const *address) {
  auto const behind = find_behind(objects, address);
  if (behind == objects.begin()) return nullptr;
  char const *const end = (behind - 1)->begin + (behind - 1)->size;
  return address < end ? end : nullptr;
}

char const *end_of_stack(char const *address) {
  Stack const stack = Stack::of_this_thread();
  return stack.begin <= address && address < stack.end ? stack.end : nullptr;
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

Constant constant_around(void const *address) {
  char const *const at = static_cast<char const *>(address);
  static std::vector<StaticObject> const constants = find_constants();
  auto const behind = find_behind(constants, at);
  char const *const next = behind == constants.end() ? reinterpret_cast<char const *>(UINTPTR_MAX) : behind->begin;
  if (behind == constants.begin()) return {nullptr, next};
  StaticObject const &before = *(behind - 1);
  char const *const end = before.begin + before.size;
  return at < end ? Constant{before.begin, end} : Constant{end, next};
}

} // namespace symreal::memory
