// Extents of an annotated object or section, one per dimension. Functions that are not templates are in the library, so
// that no source has to compile a standard container for them.
#pragma once

#include <symreal/numbers.h>

#include <cstddef>
#include <type_traits>

namespace symreal {

class Extents {
public:
  Extents();
  Extents(Extents &&other) noexcept : parts_(other.parts_) { other.parts_ = nullptr; }
  Extents &operator=(Extents &&) = delete;
  ~Extents();

  void push_back(std::size_t extent) noexcept;
  void append(Extents const &inner) noexcept;
  std::size_t const *data() const noexcept;
  std::size_t size() const noexcept;

  template <class T> void add(T &&count) {
    push_back(static_cast<std::size_t>(count));
    if constexpr (std::is_lvalue_reference_v<T> && detail::is_integer<std::remove_cvref_t<T>>)
      add_variable(ScalarObject::of(count));
  }
  // The variables among the counts.
  ScalarObject const *begin_variables() const noexcept;
  ScalarObject const *end_variables() const noexcept;

  // Calls `visit` with the indices of each element, row by row.
  template <class Visit> void each_index(Visit visit) const {
    each(&visit, [](void *context, std::size_t const *index) { (*static_cast<Visit *>(context))(index); });
  }

private:
  void add_variable(ScalarObject variable) noexcept;
  void each(void *context, void (*visit)(void *context, std::size_t const *index)) const;

  struct Parts;
  Parts *parts_;
};

template <class... Count> Extents symreal_extents(Count &&...count) {
  Extents result;
  (result.add(static_cast<Count &&>(count)), ...);
  return result;
}

} // namespace symreal
