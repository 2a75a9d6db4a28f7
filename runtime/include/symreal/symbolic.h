// Everything that a symbolic program sees.
#pragma once

#include <symreal/branch.h>
#include <symreal/eigen_traits.h>
#include <symreal/external.h>
#include <symreal/standard_library.h>
#include <symreal/symbolic_expr.h>

namespace symreal {

namespace detail {
// Notes that a kernel touches an object that lives longer than itself. `is_numbers`: it consists of numbers only.
void note_state(void *object, std::size_t size, bool is_numbers, char const *name, char const *place) noexcept;
extern __thread bool recording;
} // namespace detail

// A reference to a non-const object of static storage duration. What it holds is baked in unless it is annotated.
template <class T> T &state(T &object, char const *name, char const *place) noexcept {
  using Number = std::remove_cv_t<std::remove_all_extents_t<T>>;
  if (detail::recording) detail::note_state(&object, sizeof object, std::is_same_v<Number, RealNumber>, name, place);
  return object;
}

} // namespace symreal
