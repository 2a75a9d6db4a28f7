// Runtime interface of the pragmas: an annotated object is walked down to its numbers, and each number is handed to the
// recorder (a RealNumber, in symbolic programs) or to the replay (a double). Both share the kernel's lifecycle.
#pragma once

#include <symreal/extents.h>
#include <symreal/numbers.h>

#include <cstddef>
#include <exception>
#include <initializer_list>
#include <type_traits>

namespace symreal {

enum class Kind { input, parameter, constant, scratch, output };

struct SourcePlace {
  char const *file;
  unsigned line, column;
  void const *frame = nullptr; // frame of the enclosing function
};

namespace detail {

// The number type of a program: RealNumber and double have the same size, so one interface serves all. The
// original has its annotations from <symreal/original.h>.
enum class CompiledAs { symbolic, replay, original };

// True if an annotation executed now takes effect: a kernel is open or may begin.
bool begin_object(CompiledAs, Kind, char const *label, SourcePlace) noexcept;
// The numbers come row by row. A temporary is not written back.
void element(void *number, bool is_temporary) noexcept;
// An object whose elements are annotated; if it is an output, its own bytes may change too.
void holder(void const volatile *object, std::size_t size) noexcept;
// A returned object as a whole: its storage in the caller may change.
void handed_over(void const volatile *object, std::size_t size) noexcept;
void end_object(std::size_t const *extents, std::size_t rank) noexcept;
// Declares these bytes constant: they are baked in without a diagnostic.
void constant_bytes(void const *object, std::size_t size) noexcept;
// Counts are fixed in the result, so a variable that is one need not be declared constant as well.
void constant_counts(Extents const &shape) noexcept;
void note_read(RealNumber const *number, char const *name, char const *place) noexcept;
void note_scalar_read(ScalarObject scalar, char const *name, char const *place) noexcept;
using Visit = void (*)(void const *object, Numbers &numbers);
template <class T> void visit(void const *object, Numbers &numbers) { numbers.visit(*static_cast<T const *>(object)); }
// Declares these bytes, and the numbers that the object owns when the kernel ends, dead after the kernel.
void scratch(void const *object, std::size_t size, Visit visit) noexcept;

// As scratch(), for all objects of static storage duration that a file defines.
void scratch_file(char const *file) noexcept;

// Ends the program if an item's index is out of range. `object`: spelling of the indexed object.
void check_index(std::ptrdiff_t index, std::ptrdiff_t count, char const *object) noexcept;

bool begin_function(CompiledAs, char const *name, SourcePlace, unsigned call) noexcept;
void end_function() noexcept;
void end_region(CompiledAs, char const *file_name, SourcePlace) noexcept;
// The numbers that follow were found by a solver, or, the second time, are the residual that is 0 there. Whether they
// count: a kernel is recorded.
bool begin_implicit(char const *label, SourcePlace) noexcept;
void end_implicit() noexcept;
void *private_copy(void const *original, std::size_t low, std::size_t count) noexcept;
void const *in_private_copy(void const *pointer) noexcept;

template <class> inline constexpr bool always_false = false;

#ifdef MBD_REPLAY
inline constexpr CompiledAs compiled_as = CompiledAs::replay;
template <class T> inline constexpr bool is_number = std::is_same_v<T, double>;
using ProgramNumber = double;
#else
inline constexpr CompiledAs compiled_as = CompiledAs::symbolic;
template <class T> inline constexpr bool is_number = std::is_same_v<T, RealNumber>;
using ProgramNumber = RealNumber;
#endif
// Type of a returned expression after the conversion of `return`: arithmetic types become the program's number, and so
// do integers and truth values that are symbolic.
template <class T> inline constexpr bool becomes_number =
    std::is_arithmetic_v<T> || is_symbolic_int<T> || std::is_same_v<T, SymbolicBool>;
template <class T> inline constexpr bool is_float = std::is_same_v<std::remove_cv_t<T>, float>;
template <class T> using Returned =
    std::conditional_t<becomes_number<std::decay_t<T>> && !is_float<std::decay_t<T>>, ProgramNumber, std::decay_t<T>>;

// Whether an object, or what it leads to, consists of floats: in an instantiation of a template that is no kernel.
template <class T> constexpr bool is_of_floats() {
  if constexpr (std::is_reference_v<T>)
    return is_of_floats<std::remove_reference_t<T>>();
  else if constexpr (std::is_pointer_v<T>)
    return is_of_floats<std::remove_pointer_t<T>>();
  else if constexpr (std::is_array_v<T>)
    return is_of_floats<std::remove_all_extents_t<T>>();
  else if constexpr (is_class<T> && requires { typename T::value_type; })
    return is_of_floats<typename T::value_type>();
  else
    return is_float<T>;
}
// In the place of such an object.
struct OfFloats {};

// An integer of type T as a number.
template <class T, class Value> ProgramNumber integer_number(Value const &value) {
  if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
    return static_cast<double>(static_cast<T>(value));
  else if constexpr (std::is_same_v<Value, SymbolicBool>)
    return ProgramNumber(value);
  else if constexpr (std::is_same_v<T, bool>)
    return ProgramNumber(SymbolicBool(value != 0));
  else
    return SymbolicInt<T>(value).number();
}

// Number of elements of the object from index 0 on; -1 if unknown: a pointer, or a class with another kind of index.
// An array of one element may be the last member of a structure that goes on behind its end.
template <class T> std::ptrdiff_t element_count(T &object) {
  if constexpr (std::is_bounded_array_v<T>)
    return std::extent_v<T> > 1 ? static_cast<std::ptrdiff_t>(std::extent_v<T>) : -1;
  else if constexpr (requires { object.derived().size(); }) // of Eigen
    return static_cast<std::ptrdiff_t>(object.size());
  else if constexpr (requires { object.index_bases(); }) // of Boost
    return -1;
  else if constexpr (
      requires { object.size(), object.end() - object.begin(); } ||
      requires { object.size(), object.cshift(0); }) // the latter: std::valarray
    return static_cast<std::ptrdiff_t>(object.size());
  else
    return -1;
}

// Visits the numbers of an object; the extents of the outermost visit are appended to `extents`.
template <class T> void walk(T &object, bool is_temporary, Extents *extents) {
  using Plain = std::remove_cv_t<T>;
  Extents *inner = extents;
  auto visit = [&](auto &&part) {
    walk(part, is_temporary || !std::is_lvalue_reference_v<decltype(part)>, inner);
    inner = nullptr; // the first part tells the shape of all
  };
  if constexpr (is_number<Plain>) {
    element(const_cast<Plain *>(&object), is_temporary);
  } else if constexpr (std::is_same_v<Plain, OfFloats>) { // it is not met
  } else if constexpr (std::is_array_v<Plain>) {
    if (extents) extents->push_back(std::extent_v<Plain>);
    for (auto &part : object) visit(part);
  } else if constexpr (is_matrix<T>::value) {
    holder(__builtin_addressof(object), sizeof object);
    auto rows = object.rows(), columns = object.cols();
    bool vector = columns == 1 || rows == 1;
    if (extents && !vector) extents->push_back(static_cast<std::size_t>(rows));
    if (extents) extents->push_back(static_cast<std::size_t>(vector ? rows * columns : columns));
    for (decltype(rows) i = 0; i < rows; ++i)
      for (decltype(columns) j = 0; j < columns; ++j) visit(object(i, j));
  } else if constexpr (is_sequence<T>::value) {
    holder(__builtin_addressof(object), sizeof object);
    if (extents) extents->push_back(static_cast<std::size_t>(object.size()));
    for (decltype(object.size()) i = 0; i < object.size(); ++i) visit(object[i]);
  } else if constexpr (is_complex<Plain>::value) {
    using Number = typename Plain::value_type; // the standard lays a complex number out as an array of two
    if (extents) extents->push_back(2);
    for (int part : {0, 1}) visit(reinterpret_cast<Number *>(const_cast<Plain *>(&object))[part]);
  } else {
    static_assert(always_false<T>, "symreal: this object cannot be annotated: name its numbers, or an array section");
  }
}

} // namespace detail

// An index of an item, of which there are `count`; the object in words.
template <class Index> Index symreal_index(std::ptrdiff_t count, char const *object, Index index) noexcept {
  detail::check_index(static_cast<std::ptrdiff_t>(index), count, object);
  return index;
}

// An element of an object that may tell how many it has.
template <class Index, class T> decltype(auto) symreal_element(char const *name, Index &&index, T &&object) {
  if constexpr (requires { static_cast<std::ptrdiff_t>(index); })
    if (std::ptrdiff_t const count = detail::element_count(object); count >= 0)
      detail::check_index(static_cast<std::ptrdiff_t>(index), count, name);
  return static_cast<T &&>(object)[static_cast<Index &&>(index)];
}

// The call of a template's instantiation that is the kernel; none, where objects of these types would be annotated.
template <class... T> constexpr unsigned symreal_call_of(unsigned call) noexcept {
  return (detail::is_of_floats<T>() || ...) ? 0 : call;
}
template <class T> decltype(auto) symreal_instance(T &&object) noexcept {
  if constexpr (detail::is_of_floats<T>())
    return detail::OfFloats();
  else
    return static_cast<T &&>(object);
}

template <class T> void symreal_annotate(Kind kind, char const *label, SourcePlace place, T &&object) {
  if (!detail::begin_object(detail::compiled_as, kind, label, place)) return;
  Extents shape;
  detail::walk(object, !std::is_lvalue_reference_v<T &&>, &shape);
  detail::end_object(shape.data(), shape.size());
}

// `element` takes the indices of a section and yields one element, which may again be an object.
template <class Element>
void symreal_annotate_section(Kind kind, char const *label, SourcePlace place, Extents shape, Element element) {
  if (!detail::begin_object(detail::compiled_as, kind, label, place)) return;
  if constexpr (detail::compiled_as == detail::CompiledAs::symbolic) detail::constant_counts(shape);
  Extents inner, *wanted = &inner;
  shape.each_index([&](std::size_t const *index) {
    decltype(auto) part = element(index);
    detail::walk(part, !std::is_lvalue_reference_v<decltype(element(index))>, wanted);
    wanted = nullptr;
  });
  shape.append(inner);
  detail::end_object(shape.data(), shape.size());
}

template <class T> void symreal_implicit(char const *label, SourcePlace place, T &&object) {
  if (!detail::begin_implicit(label, place)) return;
  detail::walk(object, !std::is_lvalue_reference_v<T &&>, nullptr);
  detail::end_implicit();
}

template <class Element>
void symreal_implicit_section(char const *label, SourcePlace place, Extents const &shape, Element element) {
  if (!detail::begin_implicit(label, place)) return;
  detail::constant_counts(shape);
  shape.each_index([&](std::size_t const *index) {
    decltype(auto) part = element(index);
    detail::walk(part, !std::is_lvalue_reference_v<decltype(element(index))>, nullptr);
  });
  detail::end_implicit();
}

// constant: the bytes of the object, and the numbers in the storage that it owns, are known to be baked in.
// scratch: they are dead after the kernel.
template <Kind kind, class T> void declare_object(T const &object) {
  if constexpr (kind == Kind::scratch) {
    detail::scratch(&object, sizeof object, detail::visit<T>);
  } else {
    detail::constant_bytes(&object, sizeof object);
    struct {
      void operator()(RealNumber const *number) const { detail::constant_bytes(number, sizeof *number); }
      void operator()(ScalarObject scalar) const { detail::constant_bytes(scalar.address, scalar.size); }
    } declare;
    Numbers(declare).visit(object);
  }
}

template <Kind kind, class T> void symreal_declare(char const *label, SourcePlace place, T const &object) {
  if (!detail::begin_object(detail::compiled_as, kind, label, place)) return;
  if constexpr (detail::compiled_as == detail::CompiledAs::symbolic) declare_object<kind>(object);
  detail::end_object(nullptr, 0);
}

inline void symreal_declare_file(char const *label, SourcePlace place) {
  if (!detail::begin_object(detail::compiled_as, Kind::scratch, label, place)) return;
  detail::scratch_file(place.file);
  detail::end_object(nullptr, 0);
}

template <Kind kind, class Element>
void symreal_declare_section(char const *label, SourcePlace place, Extents const &shape, Element element) {
  if (!detail::begin_object(detail::compiled_as, kind, label, place)) return;
  if constexpr (detail::compiled_as == detail::CompiledAs::symbolic) {
    detail::constant_counts(shape);
    shape.each_index([&](std::size_t const *index) { declare_object<kind>(element(index)); });
  }
  detail::end_object(nullptr, 0);
}

// The carried value of an input without a given value.
double missing_value() noexcept;

// Sets the range of the inputs of the last executed pragma.
void symreal_set_range(double low, double high) noexcept;

// Pairs an input with the output that is its time derivative, by their labels.
void symreal_set_state(char const *state, char const *derivative, SourcePlace place) noexcept;

// Adds derivatives of outputs by inputs as further outputs: "jacobian(tau, [q, qd])".
void symreal_differentiate(char const *wish, SourcePlace place) noexcept;

// Ends a region kernel: its outputs become ordinary numbers.
inline void symreal_generate(char const *file_name, SourcePlace place) noexcept {
  detail::end_region(detail::compiled_as, file_name, place);
}

// The pointer itself; if it points to read-only memory, a private copy of pointer[0 .. low+count).
// Memory behind the copy is inaccessible, so an access beyond the annotated range is caught.
template <class T> T const *symreal_rebind(T const *pointer, std::size_t low, std::size_t count) noexcept {
  if constexpr (std::is_trivially_copyable_v<T>)
    return static_cast<T const *>(detail::private_copy(pointer, low * sizeof(T), count * sizeof(T)));
  return pointer;
}

// Redirects a pointer into the copied range (its end included) to the copy; leaves any other unchanged.
template <class T> void symreal_rebind_end(T const *&pointer) noexcept {
  pointer = static_cast<T const *>(detail::in_private_copy(pointer));
}
template <class T> void symreal_rebind_end(T const &) noexcept {}

// The kernel of a function with a pragma: recorded during the chosen outermost call, inert in every other.
class FunctionKernel {
public:
  FunctionKernel(char const *name, SourcePlace place, unsigned call = 1) noexcept
      : active_(detail::begin_function(detail::compiled_as, name, place, call)) {}
  FunctionKernel(FunctionKernel const &) = delete;
  FunctionKernel &operator=(FunctionKernel const &) = delete;
  ~FunctionKernel() {
    if (active_) detail::end_function();
  }

  // An argument that is passed by value is baked in where it is not annotated.
  template <class T> void symreal_argument(char const *name, char const *place, T const &object) const noexcept {
    if constexpr (detail::compiled_as == detail::CompiledAs::symbolic) {
      if (!active_) return;
      struct {
        char const *name, *place;
        void operator()(RealNumber const *number) const { detail::note_read(number, name, place); }
        void operator()(ScalarObject scalar) const { detail::note_scalar_read(scalar, name, place); }
      } judge{name, place};
      Numbers(judge).visit(object);
    }
  }

  // Runs the output annotations when the function returns.
  template <class Outputs> class OnReturn {
  public:
    OnReturn(bool active, Outputs outputs)
        : active_(active),
          exceptions_(std::uncaught_exceptions()),
          outputs_(std::move(outputs)) {}
    OnReturn(OnReturn const &) = delete;
    OnReturn &operator=(OnReturn const &) = delete;
    ~OnReturn() {
      // An exception that leaves the kernel is its only result.
      if (!active_ || std::uncaught_exceptions() > exceptions_) return;
      begin_outputs();
      outputs_();
    }

  private:
    bool active_;
    int exceptions_; // that are on their way already
    Outputs outputs_;
  };
  template <class Outputs> OnReturn<Outputs> symreal_on_return(Outputs outputs) {
    accept_annotations();
    return OnReturn<Outputs>(active_, std::move(outputs));
  }

  // The returned value as an output; the caller gets an ordinary number. Stands before the other outputs: it is met
  // first.
  template <class T> detail::Returned<T> symreal_returned(char const *label, SourcePlace place, T &&result) {
    detail::Returned<T> copy = std::forward<T>(result);
    if (is_deferred_) {
      label_ = label;
      place_ = place;
    } else if (active_) {
      begin_outputs();
      if constexpr (detail::is_float<detail::Returned<T>>) {
        detail::ProgramNumber number(copy);
        symreal_annotate(Kind::output, label, place, number);
      } else
        symreal_annotate(Kind::output, label, place, copy);
      make_plain(&copy, sizeof copy);
    }
    return copy;
  }

  // As above, for a function that returns an integer of type T: no decision.
  template <class T, class Value>
  std::decay_t<Value> symreal_returned_integer(char const *label, SourcePlace place, Value &&result) {
    std::decay_t<Value> copy = std::forward<Value>(result);
    if (active_) {
      begin_outputs();
      detail::ProgramNumber number = detail::integer_number<T>(copy);
      symreal_annotate(Kind::output, label, place, number);
      make_plain(&copy, sizeof copy);
    }
    return copy;
  }

  // A returned object that is not an output.
  template <class T> T symreal_handed_over(T &&result) {
    T copy = std::forward<T>(result);
    if (active_) detail::handed_over(__builtin_addressof(copy), sizeof copy);
    return copy;
  }

  // As above, for a structure (<symreal/object_layout.h>).
  template <class... Containers, class T>
  auto symreal_returned_layout(char const *label, SourcePlace place, char const *layout, T &&result);

  // A function with selects among its `return`s knows what it returns at the last of them: until then each only says
  // what the output is called.
  void defer_returned(bool is_deferred) noexcept { is_deferred_ = is_deferred; }
  template <class T> detail::Returned<T> deferred(T &&result) {
    return label_ ? symreal_returned(label_, place_, std::forward<T>(result))
                  : detail::Returned<T>(std::forward<T>(result));
  }

private:
  // The annotations of an inert call were passed over; from here on others count again.
  static void accept_annotations() noexcept;
  static void begin_outputs() noexcept;
  static void make_plain(void *object, std::size_t size) noexcept;

  bool active_;
  bool is_deferred_ = false;
  char const *label_ = nullptr;
  SourcePlace place_{};
};

} // namespace symreal
