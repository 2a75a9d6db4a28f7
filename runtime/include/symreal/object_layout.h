// Annotations of structures by their layout, which covers private members, packed ones, and structures of C. The
// rewriter emits the layout as text, the same for symbolic, replay and original programs, which lay them out alike.
//
//   shape  := { "[" count "]" } what
//   what   := "d"                           a number
//           | ("i" | "u") size              an integer with or without sign; sizes in bytes
//           | ("f" | "p" | "t" | "o") size  a float or long double, a pointer to a function or to an object, an object
//                                           of a library
//           | "{" { member } "}" size
//           | "@" k "," size ":" shape      the k-th of the types that stand beside the text: a container of such
//   member := name "+" offset ":" shape ";"
#pragma once

#include <symreal/annotate.h>

namespace symreal {

namespace detail {

// Calls `each` for every element of a container, row by row; returns how many extents it has, which it writes.
using EachElement = void (*)(void *context, void const volatile *element);
using VisitElements = std::size_t (*)(void const volatile *container, EachElement each, void *context,
                                      std::size_t *extents);

template <class T>
std::size_t visit_elements(void const volatile *address, EachElement each, void *context, std::size_t *extents) {
  T &object = *static_cast<T *>(const_cast<void *>(address));
  auto const visit = [=](auto &element) { each(context, &reinterpret_cast<char const volatile &>(element)); };
  if constexpr (is_matrix<T>::value) {
    auto const rows = object.rows(), columns = object.cols();
    for (auto i = rows * 0; i < rows; ++i)
      for (auto j = columns * 0; j < columns; ++j) visit(object(i, j));
    bool const is_vector = rows == 1 || columns == 1;
    extents[0] = static_cast<std::size_t>(is_vector ? rows * columns : rows);
    extents[1] = static_cast<std::size_t>(columns);
    return is_vector ? 1 : 2;
  } else {
    for (decltype(object.size()) i = 0; i < object.size(); ++i) visit(object[i]);
    extents[0] = static_cast<std::size_t>(object.size());
    return 1;
  }
}

template <class... Containers> inline constexpr VisitElements containers[] = {visit_elements<Containers>..., nullptr};

// Hands each number and integer over, with the names of the members; the extents of the object are appended.
void walk_layout(void const volatile *object, char const *layout, VisitElements const *containers, bool is_temporary,
                 Extents *extents) noexcept;

// An object of a class that overloads `&`, and a member that no reference can be bound to, have an address as well.
template <class... Containers> void symreal_annotate_layout(Kind kind, char const *label, SourcePlace place,
                                                            char const *layout, void const volatile *object) {
  if (!begin_object(compiled_as, kind, label, place)) return;
  Extents shape;
  walk_layout(object, layout, containers<Containers...>, false, &shape);
  end_object(shape.data(), shape.size());
}

template <class... Containers, class Address>
void symreal_annotate_layout_section(Kind kind, char const *label, SourcePlace place, Extents shape, char const *layout,
                                     Address address) {
  if (!begin_object(compiled_as, kind, label, place)) return;
  if constexpr (compiled_as == CompiledAs::symbolic) constant_counts(shape);
  Extents inner, *wanted = &inner;
  shape.each_index([&](std::size_t const *index) {
    walk_layout(address(index), layout, containers<Containers...>, false, wanted);
    wanted = nullptr;
  });
  shape.append(inner);
  end_object(shape.data(), shape.size());
}

} // namespace detail
using detail::symreal_annotate_layout;
using detail::symreal_annotate_layout_section;

// A structure with its layout, as an argument.
struct LaidOut {
  char const *layout;
  void const volatile *object;
  detail::VisitElements const *containers;

  void annotate(Kind kind, char const *label, SourcePlace place) const {
    if (!detail::begin_object(detail::compiled_as, kind, label, place)) return;
    Extents shape;
    detail::walk_layout(object, layout, containers, false, &shape);
    detail::end_object(shape.data(), shape.size());
  }
};
template <class... Containers> LaidOut symreal_laid_out(char const *layout, void const volatile *object) {
  return {layout, object, detail::containers<Containers...>};
}

// A returned structure, as an output.
template <class... Containers, class T>
auto FunctionKernel::symreal_returned_layout(char const *label, SourcePlace place, char const *layout, T &&result) {
  std::decay_t<T> copy = std::forward<T>(result);
  if (active_) {
    begin_outputs();
    if (detail::begin_object(detail::compiled_as, Kind::output, label, place)) {
      Extents shape;
      detail::holder(__builtin_addressof(copy), sizeof copy);
      detail::walk_layout(__builtin_addressof(copy), layout, detail::containers<Containers...>, true, &shape);
      detail::end_object(shape.data(), shape.size());
    }
    make_plain(&copy, sizeof copy);
  }
  return copy;
}

} // namespace symreal
