// A growing array, for what the runtime keeps in the frames of a program. It stands in for <vector>, which each program
// would have to compile.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

namespace symreal {

template <class T> class List {
  static_assert(std::is_trivially_destructible_v<T>);

public:
  List() = default;
  List(std::size_t size, T const &value) {
    reserve(size);
    while (size_ < size) push_back(value);
  }
  List(List &&other) noexcept : first_(other.first_), size_(other.size_), capacity_(other.capacity_) {
    other.first_ = nullptr;
    other.size_ = other.capacity_ = 0;
  }
  List &operator=(List &&other) noexcept {
    if (this == &other) return *this;
    this->~List();
    return *new (this) List(static_cast<List &&>(other));
  }
  ~List() { ::operator delete(first_); }

  std::size_t size() const noexcept { return size_; }
  bool empty() const noexcept { return size_ == 0; }
  T &operator[](std::size_t index) noexcept { return first_[index]; }
  T const &operator[](std::size_t index) const noexcept { return first_[index]; }
  T *begin() noexcept { return first_; }
  T *end() noexcept { return first_ + size_; }
  T const *begin() const noexcept { return first_; }
  T const *end() const noexcept { return first_ + size_; }
  T &back() noexcept { return first_[size_ - 1]; }

  void reserve(std::size_t capacity) {
    if (capacity <= capacity_) return;
    T *const moved = static_cast<T *>(::operator new(capacity * sizeof(T)));
    for (std::size_t k = 0; k < size_; ++k) new (moved + k) T(first_[k]);
    ::operator delete(first_);
    first_ = moved;
    capacity_ = capacity;
  }
  void push_back(T const &value) {
    T const copy(value); // which may be an element
    if (size_ == capacity_) reserve(size_ == 0 ? 1 : 2 * size_);
    new (first_ + size_++) T(copy);
  }
  void pop_back() noexcept { --size_; }

private:
  T *first_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

} // namespace symreal
