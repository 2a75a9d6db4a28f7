// A stack that allocates memory only beyond its first few elements.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace symreal {

template <class T, std::size_t few = 16> class SmallStack {
public:
  bool empty() const { return count_ == 0 && more_.empty(); }
  void push(T const &value) {
    if (count_ < few)
      some_[count_++] = value;
    else
      more_.push_back(value);
  }
  T pop() {
    if (more_.empty()) return some_[--count_];
    T const value = more_.back();
    more_.pop_back();
    return value;
  }

private:
  std::array<T, few> some_; // the first elements
  std::size_t count_ = 0;
  std::vector<T> more_;
};

} // namespace symreal
