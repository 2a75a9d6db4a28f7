// Table lookups: the rewritten form of a subscript whose index may depend on an input.
#pragma once

#include <symreal/state.h>
#include <symreal/symbolic_int.h>

#include <cstddef>

namespace symreal {

namespace detail {

// A table's name in the source, and the place of the access.
struct TableName {
  char const *name, *place;
};

// One element of `rows` times `columns` contiguous numbers; `column` is ignored if `columns` is 0.
[[gnu::noinline]] RealNumber const look_up(TableName name, void const *numbers, std::size_t rows, std::size_t columns,
                                           RealNumber row, RealNumber column) noexcept;
// Number of elements that a pragma declares behind the pointer; 0 without such a pragma.
std::size_t declared_extent(void const *pointer) noexcept;

template <class T> RealNumber index_number(T index) noexcept { return static_cast<double>(index); }
template <class T> RealNumber index_number(SymbolicInt<T> index) noexcept { return index.number(); }

// The index as an integer: a decision if it is symbolic, since no table is known.
inline std::ptrdiff_t plain_index(RealNumber index) noexcept { return static_cast<std::ptrdiff_t>(index); }

// One element of a table. Notes a read of it if the extent is unknown; otherwise the array was read as a whole.
template <class T> RealNumber const element(T const &element, TableName name, std::size_t extent) noexcept {
  return extent == 0 ? symreal_read(element, name.name, name.place) : element;
}

template <class T> struct RowOf {
  static constexpr std::size_t columns = 0; // a number
};
template <class T, std::size_t n> struct RowOf<T[n]> {
  static constexpr std::size_t columns = n;
};
template <template <class, std::size_t> class Array, class T, std::size_t n> struct RowOf<Array<T, n>> {
  static constexpr std::size_t columns = n;
};

// A row of a table, selected by the first index.
template <class Row> class TableRow {
public:
  TableRow(TableName name, Row const *rows, std::size_t extent, RealNumber row) noexcept
      : name_(name),
        rows_(rows),
        extent_(extent),
        row_(row) {}

  template <class Index> RealNumber const operator[](Index index) const noexcept {
    RealNumber const column = index_number(index);
    if (extent_ != 0 && (row_.is_node() || column.is_node()))
      return look_up(name_, rows_, extent_, RowOf<Row>::columns, row_, column);
    return element(rows_[plain_index(row_)][static_cast<std::size_t>(plain_index(column))], name_, extent_);
  }

private:
  TableName name_;
  Row const *rows_;
  std::size_t extent_;
  RealNumber row_;
};

} // namespace detail

// An array under its name, with elements side by side: numbers, or rows of numbers.
template <class Element> class TableView {
public:
  TableView(detail::TableName name, Element const *elements, std::size_t extent) noexcept
      : name_(name),
        elements_(elements),
        extent_(extent) {}

  // A row, or a number as an rvalue.
  template <class Index> decltype(auto) operator[](Index index) const noexcept {
    RealNumber const number = detail::index_number(index);
    if constexpr (detail::RowOf<Element>::columns != 0) {
      return detail::TableRow<Element>(name_, elements_, extent_, number);
    } else {
      if (extent_ != 0 && number.is_node()) return detail::look_up(name_, elements_, extent_, 0, number, 0.0);
      return detail::element(elements_[detail::plain_index(number)], name_, extent_);
    }
  }

private:
  detail::TableName name_;
  Element const *elements_;
  std::size_t extent_; // 0: unknown
};

template <class T, std::size_t n>
TableView<T> symreal_table(T const (&array)[n], char const *name, char const *place) noexcept {
  return {{name, place}, array, n};
}
// std::array, std::vector.
template <class Container> auto symreal_table(Container const &container, char const *name, char const *place) noexcept
    -> TableView<std::remove_cv_t<std::remove_reference_t<decltype(*container.data())>>> {
  return {{name, place}, container.data(), container.size()};
}
template <class T> TableView<T> pointed_table(T const *pointer, char const *name, char const *place) noexcept {
  return {{name, place}, pointer, detail::declared_extent(pointer)};
}
template <class Pointer, class = std::enable_if_t<std::is_pointer_v<Pointer>>>
auto symreal_table(Pointer const &pointer, char const *name, char const *place) noexcept {
  return pointed_table(pointer, name, place);
}

// `#pragma symreal table(pointer[0:count])`: until the kernel ends.
void symreal_declare_table(void const *pointer, std::size_t count) noexcept;

} // namespace symreal
