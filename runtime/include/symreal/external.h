// Calls of functions that are not recorded: the runtime of `#pragma symreal external(f)`.
//
// The function itself is called, with the carried values in private copies of its arguments, so that the program goes
// on. If an argument is symbolic, or the function has effects, the call is recorded.
#pragma once

#include <symreal/real_number.h>
#include <symreal/symbolic_int.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace symreal {

// The rewriter's description of an external function. `shape` is as in the line `external` of a graph's text, from
// `returns` on. `sizes` is empty, or has for each parameter a 0, or, where its size is known at a call only, a product
// such as 3*$0, where $0 is the value of the first parameter.
struct ExternalDescription {
  char const *name;
  bool pure;
  char const *shape;
  char const *sizes;
  char const *file;
  unsigned line, column;
};

namespace detail {

// The return address of the caller: the call's place in the program.
[[gnu::noinline]] void const *here() noexcept;

// One call under way: the arguments in order, then the call, then its results in order.
class ExternalCall {
public:
  explicit ExternalCall(ExternalDescription const &description, void const *caller) noexcept;
  ExternalCall(ExternalCall const &) = delete;
  ExternalCall &operator=(ExternalCall const &) = delete;
  ~ExternalCall();

  // First, for all parameters: the value, if it is an integer.
  void note(double integer) noexcept;

  double number(RealNumber argument) noexcept;
  void integer(double argument) noexcept;
  // Copies the numbers behind a pointer, with their carried values.
  void *pointer(void *numbers) noexcept;
  // Replaces the numbers of a struct by their carried values, in place.
  void object(void *numbers, std::size_t count) noexcept;

  // Ends the call with the returned value; values that the function wrote are taken from the copies.
  RealNumber returned(double value) noexcept;
  void returned(void *numbers, std::size_t count) noexcept;
  void returned() noexcept;

private:
  struct State;
  State *state_;
};

// A type of the function's declaration, which keeps double, as the program spells it.
template <class T> struct AsTraced {
  using Type = T;
};
template <> struct AsTraced<double> {
  using Type = RealNumber;
};
template <> struct AsTraced<double const> {
  using Type = RealNumber const;
};
template <class T> struct AsTraced<T *> {
  using Type = typename AsTraced<T>::Type *;
};
template <class T, std::size_t n> struct AsTraced<T[n]> {
  using Type = typename AsTraced<T>::Type[n];
};
template <class T> using Traced = typename AsTraced<T>::Type;

template <class T> double integer_in(T const &argument) {
  if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) return static_cast<double>(argument);
  return 0;
}

template <class T> T pass(ExternalCall &call, Traced<T> argument) {
  if constexpr (std::is_same_v<T, double>) {
    return call.number(argument);
  } else if constexpr (std::is_pointer_v<T>) {
    return static_cast<T>(call.pointer(const_cast<void *>(static_cast<void const *>(argument))));
  } else if constexpr (detail::is_class<T>) {
    call.object(&argument, sizeof argument / sizeof(double));
    return argument;
  } else {
    call.integer(static_cast<double>(argument));
    return argument;
  }
}

// A call whose arguments are computed in order, since they stand in braces.
template <class Result> struct Called {
  template <class Function, class... Passed> explicit Called(Function *function, Passed... passed)
      : result(function(passed...)) {}
  Result result;
};
template <> struct Called<void> {
  template <class Function, class... Passed> explicit Called(Function *function, Passed... passed) {
    function(passed...);
  }
};

} // namespace detail

template <class Result, class... Parameters> class ExternalFunction {
public:
  ExternalFunction(Result (*function)(Parameters...), ExternalDescription const &description) noexcept
      : function_(function),
        description_(description) {}

  [[gnu::always_inline]] auto operator()(detail::Traced<Parameters>... arguments) const {
    detail::ExternalCall call(description_, detail::here());
    (call.note(detail::integer_in(arguments)), ...);
    detail::Called<Result> called{function_, detail::pass<Parameters>(call, arguments)...};
    if constexpr (std::is_void_v<Result>) {
      call.returned();
    } else if constexpr (detail::is_class<Result>) {
      call.returned(&called.result, sizeof called.result / sizeof(double));
      return called.result;
    } else if constexpr (std::is_same_v<Result, double>) {
      return call.returned(called.result);
    } else {
      RealNumber const returned = call.returned(static_cast<double>(called.result));
      return returned.is_node() ? SymbolicInt<Result>::from_number(returned) : SymbolicInt<Result>(called.result);
    }
  }

private:
  Result (*function_)(Parameters...);
  ExternalDescription description_;
};

template <class Result, class... Parameters> ExternalFunction<Result, Parameters...>
symreal_external(Result (*function)(Parameters...), ExternalDescription const &description) noexcept {
  return {function, description};
}
template <class Result, class... Parameters> ExternalFunction<Result, Parameters...>
symreal_external(Result (*function)(Parameters...) noexcept, ExternalDescription const &description) noexcept {
  return {function, description};
}

} // namespace symreal
