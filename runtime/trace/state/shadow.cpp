#include "runtime/trace/state/shadow.h"

#include "engine/diagnostics/diagnostic.h"
#include "runtime/memory/own_memory.h"

namespace symreal::trace {

Shadow::Page &Shadow::find(std::uintptr_t number) {
  internal_check(!detail::recording);
  return pages_[number];
}

std::vector<Marks> Shadow::copy(void const *begin, std::size_t size) {
  std::vector<Marks> marks;
  each(begin, size, [&marks](Marks here) { marks.push_back(here); });
  return marks;
}

void Shadow::paste(void const *begin, std::vector<Marks> const &marks) {
  std::size_t next = 0;
  each(begin, marks.size() * 8, [&](Marks &here) { here = marks[next++]; });
}

void Shadow::clear() {
  pages_.clear();
  last_ = nullptr;
}

} // namespace symreal::trace
