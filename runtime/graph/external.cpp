#include "graph/external.h"

namespace symreal {

std::size_t External::argument_count() const {
  std::size_t count = 0;
  for (ExternalValue const &parameter : parameters)
    if (parameter.is_given()) count += parameter.count;
  return count;
}

std::size_t External::result_count() const {
  std::size_t count = returned_count();
  for (ExternalValue const &parameter : parameters)
    if (parameter.kind == ExternalValue::Kind::output || parameter.kind == ExternalValue::Kind::updated)
      count += parameter.count;
  return count;
}

bool External::takes_integer(std::size_t argument) const {
  for (ExternalValue const &parameter : parameters) {
    if (!parameter.is_given()) continue;
    if (argument < parameter.count) return parameter.kind == ExternalValue::Kind::integer;
    argument -= parameter.count;
  }
  return false;
}

} // namespace symreal
