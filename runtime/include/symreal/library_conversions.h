// Conversions that the standard library makes by itself, in text that is not rewritten: of the elements of a
// vector<float>, of a sum in an int, of the result of a callable. Most precede their operand,
// `SymrealReturning<int>() ->* f`, since the operator takes the rest of the expression unchanged.
#pragma once

#include <symreal/standard_templates.h>
#ifdef MBD_SYMBOLIC
#include <symreal/state.h>
#endif

#include <cstddef>
#include <type_traits>

namespace symreal {

// Adapts a callable: converts its result to `To`.
template <class To> struct SymrealReturning {
  template <class Function> constexpr auto operator->*(Function function) const {
    return [function](auto &&...arguments) mutable -> To {
      return static_cast<To>(function(static_cast<decltype(arguments) &&>(arguments)...));
    };
  }
};

// An iterator that reads its elements as another type.
template <class To, class Iterator> struct ReadingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = To;
  using difference_type = std::ptrdiff_t;
  using pointer = To const *;
  using reference = To;

  Iterator at;
  To operator*() const { return static_cast<To>(*at); }
  ReadingIterator &operator++() {
    ++at;
    return *this;
  }
  ReadingIterator operator++(int) { return {at++}; }
  // It stands before the first word of `x + n`.
  friend ReadingIterator operator+(ReadingIterator i, difference_type n) { return {i.at + n}; }
  friend ReadingIterator operator-(ReadingIterator i, difference_type n) { return {i.at - n}; }
  friend bool operator==(ReadingIterator const &a, ReadingIterator const &b) { return a.at == b.at; }
};
template <class To> struct SymrealReading {
  template <class Iterator> constexpr ReadingIterator<To, Iterator> operator->*(Iterator at) const { return {at}; }
};
#ifdef MBD_SYMBOLIC
template <class To, class T> ReadingIterator<To, T *>
symreal_range_begin(ReadingIterator<To, T *> begin, char const *name, char const *place) noexcept {
  return {symreal_range_begin(begin.at, name, place)};
}
template <class To, class T>
ReadingIterator<To, T *> symreal_range_end(ReadingIterator<To, T *> end, char const *name, char const *place) noexcept {
  return {symreal_range_end(end.at, name, place)};
}
#endif

// An iterator whose elements convert what they are assigned.
template <class Iterator> struct WritingIterator {
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = void;
  struct Element {
    Iterator at;
    template <class T> void operator=(T const &x) const { *at = static_cast<std::remove_cvref_t<decltype(*at)>>(x); }
  };

  Iterator at;
  Element operator*() const { return {at}; }
  WritingIterator &operator++() {
    ++at;
    return *this;
  }
  WritingIterator operator++(int) { return {at++}; }
  friend WritingIterator operator+(WritingIterator i, difference_type n) { return {i.at + n}; }
  friend WritingIterator operator-(WritingIterator i, difference_type n) { return {i.at - n}; }
  operator Iterator() const { return at; }
};
struct SymrealWriting {
  template <class Iterator> constexpr WritingIterator<Iterator> operator->*(Iterator at) const { return {at}; }
};

// A sum that is rounded to an integer or a float with each element.
template <class To> class SymrealTotal {
public:
  explicit constexpr SymrealTotal(To total) noexcept : total_(total) {}
  template <class T> constexpr SymrealTotal &operator=(T const &x) {
    total_ = static_cast<To>(x);
    return *this;
  }
  constexpr operator To() const noexcept { return total_; }
  template <class T, class = std::enable_if_t<!std::is_same_v<T, To>>> constexpr operator T() const noexcept {
    return static_cast<T>(total_);
  }
  template <class T> friend constexpr T operator+(SymrealTotal total, T x) noexcept {
    return static_cast<T>(total.total_) + x;
  }

private:
  To total_;
};

} // namespace symreal
