/* The annotations of the original: what the rewriter makes of the pragmas, and of nothing else, in the program that
   `verify` runs as its reference. It is compiled in its own language and standard, so this is C89 and C++11; no header
   of a library is included, since that would change what the program sees.

   A kernel's inputs are written, its outputs read, at the places of the pragmas (verify/original.cpp). */
#ifndef SYMREAL_ORIGINAL_H
#define SYMREAL_ORIGINAL_H

#include "names_hide.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Begins an annotated object; returns whether it takes effect now. */
int symreal_original_object(char const *kind, char const *label, char const *file, unsigned line, unsigned column,
                            void const *frame);
/* Its numbers, row by row, of sizeof(double) bytes each; the bytes of a constant or scratch object. */
void symreal_original_bytes(void const volatile *begin, __SIZE_TYPE__ size, int is_temporary);
/* As above, for a structure with its layout (object_layout.h); `containers` visit the elements of its containers. */
typedef void (*symreal_original_each)(void *context, void const volatile *element);
typedef __SIZE_TYPE__ (*symreal_original_visit)(void const volatile *container, symreal_original_each each,
                                                void *context, __SIZE_TYPE__ *extents);
void symreal_original_layout(void const volatile *begin, char const *layout, symreal_original_visit const *containers,
                             int is_temporary);
/* All objects of static storage duration with these linker names, separated by blanks. */
void symreal_original_statics(char const *names);
/* An object that owns such numbers, in place or elsewhere; if it is an output, its own bytes may change too. */
void symreal_original_holder(void const volatile *begin, __SIZE_TYPE__ size);
void symreal_original_object_end(void);
/* A returned object as a whole: its storage in the caller may change. */
void symreal_original_handed_over(int active, void const volatile *begin, __SIZE_TYPE__ size);
/* Checks the index of an item against `count`; `object` is the spelling of the indexed object. */
void symreal_original_check_index(__PTRDIFF_TYPE__ index, __PTRDIFF_TYPE__ count, char const *object);
/* A parameter: the kernel's own memory, even if it lies in the caller's frame. */
void symreal_original_own(void const volatile *begin, __SIZE_TYPE__ size);
/* An argument that the caller chooses freely: text, or an object that a wrapper refuses. */
void symreal_original_chosen(void const volatile *begin, __SIZE_TYPE__ size);
/* Enters a function with a pragma; returns whether this call is the kernel. */
int symreal_original_function(char const *name, char const *file, unsigned line, unsigned column, unsigned call,
                              void const *frame);
/* All its inputs are annotated. */
int symreal_original_entered(int active);
/* Announces its outputs; returns whether they follow. */
int symreal_original_leaving(int active);
void symreal_original_function_end(int active);
/* Runs the generated code of the kernel; returns 0, or the violated guard. */
int symreal_original_compute(double const *input, double const *parameters, double *output);
/* The returned value as an output; `layout` describes a structure. */
void symreal_original_returned(int active, char const *label, char const *file, unsigned line, unsigned column,
                               void *value, __SIZE_TYPE__ size, char const *layout);
/* The returned object as a whole: its parts other than numbers are compared with the wrapper's result. */
void symreal_original_whole(int active, void const volatile *object);
/* Numbers returned in registers, beyond the reach of later annotations: makes them ordinary numbers again. */
void symreal_original_settle(void volatile *begin, __SIZE_TYPE__ size);
/* The other clauses of a kernel's pragma, for a recording. */
void symreal_original_range(double low, double high);
void symreal_original_state(char const *state, char const *derivative, char const *file, unsigned line,
                            unsigned column);
void symreal_original_differentiate(char const *wish, char const *file, unsigned line, unsigned column);
void symreal_original_generate(char const *name, char const *file, unsigned line, unsigned column);
/* Resolves output objects when the function is entered, and reads them when it returns. */
void symreal_original_later(int active);
void symreal_original_outputs(int *active);
#ifdef __x86_64__
/* The kernel is run several times in a row: from its end the program jumps back to here, with the function's frame as
   it was, and all that outlives the function as the kernel left it. */
void *symreal_original_point(void);
int symreal_original_set_jump(void *point) __asm__("_setjmp") __attribute__((returns_twice));
void symreal_original_keep(void const *frame);
#endif

#ifdef __cplusplus
}
#endif

#define SYMREAL_ORIGINAL_FRAME __builtin_frame_address(0)
/* Placeholder for the statements of a program that tests a wrapper. */
#define SYMREAL_ORIGINAL_WRAPPER(name, file, line, column)

#ifdef __x86_64__
#define SYMREAL_ORIGINAL_AGAIN(active)                                                                                 \
  if (active) {                                                                                                        \
    symreal_original_set_jump(symreal_original_point());                                                               \
    symreal_original_keep(SYMREAL_ORIGINAL_FRAME);                                                                     \
  }
#else
#define SYMREAL_ORIGINAL_AGAIN(active)
#endif

#define SYMREAL_INDEX(count, name, ...)                                                                                \
  (symreal_original_check_index((__PTRDIFF_TYPE__)(__VA_ARGS__), count, name), (__VA_ARGS__))
#define SYMREAL_WORDS(...) __VA_ARGS__
#define SYMREAL_ORIGINAL_TEXT(text) symreal_original_chosen(text, (text) ? __builtin_strlen(text) + 1 : 0);
/* An option or a pragma that changes arithmetic is one of the program's own flags. */
#ifdef SYMREAL_OWN_FLAGS
#define SYMREAL_ORIGINAL_EITHER(own, ...) SYMREAL_WORDS own
#else
#define SYMREAL_ORIGINAL_EITHER(own, ...) __VA_ARGS__
#endif
#define SYMREAL_ORIGINAL_STATICS(names) symreal_original_statics(names)
#define SYMREAL_REAL double

#ifndef __cplusplus

/* In C the rewriter alone determines the numbers of an object. */
#define SYMREAL_ELEMENT(name, index, ...) ((__VA_ARGS__)[index])
#define SYMREAL_ORIGINAL_IS_ACTIVE symreal_kernel
#define SYMREAL_ORIGINAL_OWN(object) symreal_original_own(&(object), sizeof(object));
#define SYMREAL_ORIGINAL_CHOSEN(object) symreal_original_chosen(&(object), sizeof(object));
#define SYMREAL_ORIGINAL_NUMBERS(...) symreal_original_bytes(&(__VA_ARGS__), sizeof(__VA_ARGS__), 0)
#define SYMREAL_ORIGINAL_BYTES SYMREAL_ORIGINAL_NUMBERS
#define SYMREAL_ORIGINAL_LAYOUT(layout, types, ...) symreal_original_layout(&(__VA_ARGS__), layout, 0, 0)
#define SYMREAL_ORIGINAL_FUNCTION(name, file, line, column, call)                                                      \
  int const symreal_kernel = symreal_original_function(name, file, line, column, call, SYMREAL_ORIGINAL_FRAME);        \
  SYMREAL_ORIGINAL_AGAIN(symreal_kernel)
#define SYMREAL_RETURN(label, file, line, column, ...)                                                                 \
  (__extension__({                                                                                                     \
    double symreal_value = (__VA_ARGS__);                                                                              \
    symreal_original_returned(symreal_kernel, label, file, line, column, &symreal_value, sizeof symreal_value, 0);     \
    symreal_value;                                                                                                     \
  }))
#define SYMREAL_RETURN_WHOLE(type, ...)                                                                                \
  (__extension__({                                                                                                     \
    __typeof__(__VA_ARGS__) symreal_value = (__VA_ARGS__);                                                             \
    symreal_original_handed_over(symreal_kernel, &symreal_value, sizeof symreal_value);                                \
    symreal_value;                                                                                                     \
  }))
#define SYMREAL_BOOL _Bool
#define SYMREAL_RETURN_INTEGER(label, file, line, column, type, ...)                                                   \
  (__extension__({                                                                                                     \
    SYMREAL_WORDS type symreal_value = (__VA_ARGS__);                                                                  \
    double symreal_number = symreal_value;                                                                             \
    symreal_original_returned(symreal_kernel, label, file, line, column, &symreal_number, sizeof symreal_number, 0);   \
    symreal_value;                                                                                                     \
  }))
#define SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, ...)                                           \
  (__extension__({                                                                                                     \
    __typeof__(__VA_ARGS__) symreal_value = (__VA_ARGS__);                                                             \
    symreal_original_returned(symreal_kernel, label, file, line, column, &symreal_value, sizeof symreal_value,         \
                              layout);                                                                                 \
    symreal_value;                                                                                                     \
  }))
#ifndef __clang__
/* Every exit of the function runs this, which sees the current values of the parameters. */
#define SYMREAL_ORIGINAL_OUTPUTS(...)                                                                                  \
  __extension__ void symreal_on_return(int *symreal_active) {                                                          \
    if (symreal_original_leaving(*symreal_active)) {                                                                   \
      __VA_ARGS__                                                                                                      \
    }                                                                                                                  \
    symreal_original_function_end(*symreal_active);                                                                    \
  }                                                                                                                    \
  int symreal_outputs __attribute__((__cleanup__(symreal_on_return), __unused__)) =                                    \
      symreal_original_entered(symreal_kernel);
#else
/* Without nested functions: the objects of the items are resolved at the function's entry. */
#define SYMREAL_ORIGINAL_OUTPUTS(...)                                                                                  \
  int symreal_outputs __attribute__((__cleanup__(symreal_original_outputs), __unused__)) =                             \
      symreal_original_entered(symreal_kernel);                                                                        \
  if (symreal_kernel) {                                                                                                \
    symreal_original_later(1);                                                                                         \
    __VA_ARGS__                                                                                                        \
    symreal_original_later(0);                                                                                         \
  }
#endif

#else

namespace symreal_original {

template <int n> struct Choice : Choice<n - 1> {};
template <> struct Choice<0> {};

template <class T> void walk(T &object, bool is_temporary);

inline void look(double const volatile &number, bool is_temporary, Choice<9>) {
  symreal_original_bytes(&number, sizeof number, is_temporary);
}
template <class T, __SIZE_TYPE__ size> void look(T (&array)[size], bool is_temporary, Choice<8>) {
  for (__SIZE_TYPE__ i = 0; i < size; ++i) walk(array[i], is_temporary);
}

template <class Reference> struct IsLvalue {
  enum { value = false };
};
template <class T> struct IsLvalue<T &> {
  enum { value = true };
};
template <class Reference, class T> void pass(T &&element, bool is_temporary) {
  walk(element, is_temporary || !IsLvalue<Reference>::value);
}

/* In the place of an object of floats, in an instantiation of a template that is no kernel: it is not met. */
struct OfFloats {};
inline void look(OfFloats const &, bool, Choice<9>) {}
template <class T> struct IsOfFloats {
  enum { value = false };
};
template <> struct IsOfFloats<float> {
  enum { value = true };
};
template <class T> struct IsOfFloats<T const> : IsOfFloats<T> {};
template <class T> struct IsOfFloats<T &> : IsOfFloats<T> {};
template <class T> struct IsOfFloats<T &&> : IsOfFloats<T> {};
template <class T> struct IsOfFloats<T *> : IsOfFloats<T> {};
template <class T> struct IsOfFloats<T *const> : IsOfFloats<T> {};
template <class T, __SIZE_TYPE__ size> struct IsOfFloats<T[size]> : IsOfFloats<T> {};
template <class T, __SIZE_TYPE__ size> struct IsOfFloats<T const[size]> : IsOfFloats<T> {};
template <class T, bool is_of_floats = IsOfFloats<T>::value> struct Instance {
  static T &&of(T &&object) { return static_cast<T &&>(object); }
};
template <class T> struct Instance<T, true> {
  static OfFloats of(T &&) { return OfFloats(); }
};
template <class T> auto symreal_instance(T &&object) -> decltype(Instance<T>::of(static_cast<T &&>(object))) {
  return Instance<T>::of(static_cast<T &&>(object));
}
template <class... T> unsigned symreal_call_of(unsigned call) {
  bool const are[] = {IsOfFloats<T>::value...};
  for (bool is : are)
    if (is) return 0;
  return call;
}

template <class T> auto look(T &object, bool is_temporary, Choice<7>)
    -> decltype(object.rows(), object.cols(), static_cast<void>(object(0, 0))) {
  for (decltype(object.rows() + 0) i = 0; i < object.rows(); ++i)
    for (decltype(object.cols() + 0) j = 0; j < object.cols(); ++j)
      pass<decltype(object(i, j))>(object(i, j), is_temporary);
}
template <class T> auto look(T &object, bool is_temporary, Choice<6>)
    -> decltype(object.size(), static_cast<void>(object[0])) {
  for (decltype(object.size() + 0) i = 0; i < object.size(); ++i) pass<decltype(object[i])>(object[i], is_temporary);
}
/* A complex number is an array of two. */
template <class T> auto look(T &object, bool is_temporary, Choice<5>)
    -> decltype(object.real(), static_cast<void>(object.imag())) {
  static_assert(sizeof(object) == 2 * sizeof(double), "symreal: this object cannot be annotated");
  symreal_original_bytes(&reinterpret_cast<char const volatile &>(object), sizeof object, is_temporary);
}

template <class T> void walk(T &object, bool is_temporary) {
  symreal_original_holder(&reinterpret_cast<char const volatile &>(object), sizeof object);
  look(object, is_temporary, Choice<9>());
}
template <class T> void symreal_numbers(T &&object) { walk(object, !IsLvalue<T &&>::value); }
/* Visitor of the elements of a container in a structure. */
template <class T> struct Elements {
  symreal_original_each each;
  void *context;
  template <class Element> void operator()(Element &element) const {
    each(context, &reinterpret_cast<char const volatile &>(element));
  }
};
template <class T> auto visit_elements(T &object, Elements<T> const &visit, Choice<1>)
    -> decltype(object.rows(), object.cols(), static_cast<void>(object(0, 0))) {
  for (decltype(object.rows() + 0) i = 0; i < object.rows(); ++i)
    for (decltype(object.cols() + 0) j = 0; j < object.cols(); ++j) visit(object(i, j));
}
template <class T> void visit_elements(T &object, Elements<T> const &visit, Choice<0>) {
  for (decltype(object.size() + 0) i = 0; i < object.size(); ++i) visit(object[i]);
}
template <class T> __SIZE_TYPE__ visit_container(void const volatile *container, symreal_original_each each,
                                                 void *context, __SIZE_TYPE__ *) {
  visit_elements(*static_cast<T *>(const_cast<void *>(container)), Elements<T>{each, context}, Choice<1>());
  return 0; /* the recording knows them */
}
template <class... Containers> struct Visits {
  static symreal_original_visit const *list() {
    static symreal_original_visit const visits[] = {visit_container<Containers>..., 0};
    return visits;
  }
};
template <class... Containers> symreal_original_visit const *symreal_visits() { return Visits<Containers...>::list(); }
/* Number of elements of an object from index 0 on; -1 if unknown (<symreal/annotate.h>). */
template <class T, __SIZE_TYPE__ size> __PTRDIFF_TYPE__ element_count(T (&)[size], Choice<4>) {
  return size > 1 ? static_cast<__PTRDIFF_TYPE__>(size) : -1;
}
template <class T> auto element_count(T &object, Choice<4>)
    -> decltype(static_cast<__PTRDIFF_TYPE__>(object.derived().size())) {
  return static_cast<__PTRDIFF_TYPE__>(object.size());
}
template <class T> auto element_count(T &object, Choice<3>)
    -> decltype(object.index_bases(), static_cast<__PTRDIFF_TYPE__>(0)) {
  return -1;
}
template <class T> auto element_count(T &object, Choice<2>)
    -> decltype(object.end() - object.begin(), static_cast<__PTRDIFF_TYPE__>(object.size())) {
  return static_cast<__PTRDIFF_TYPE__>(object.size());
}
template <class T> auto element_count(T &object, Choice<1>)
    -> decltype(object.cshift(0), static_cast<__PTRDIFF_TYPE__>(object.size())) {
  return static_cast<__PTRDIFF_TYPE__>(object.size());
}
template <class T> __PTRDIFF_TYPE__ element_count(T &, Choice<0>) { return -1; }

template <class Index> auto position(Index const &index, Choice<1>) -> decltype(static_cast<__PTRDIFF_TYPE__>(index)) {
  return static_cast<__PTRDIFF_TYPE__>(index);
}
template <class Index> __PTRDIFF_TYPE__ position(Index const &, Choice<0>) { return 0; }

template <class Index, class T> auto symreal_element(char const *name, Index &&index, T &&object)
    -> decltype((static_cast<T &&>(object)[static_cast<Index &&>(index)])) {
  __PTRDIFF_TYPE__ const count = element_count(object, Choice<4>());
  if (count >= 0) symreal_original_check_index(position(index, Choice<1>()), count, name);
  return static_cast<T &&>(object)[static_cast<Index &&>(index)];
}
template <class T> void symreal_bytes(T const &object) {
  symreal_original_bytes(&reinterpret_cast<char const volatile &>(object), sizeof object, 0);
}

/* Type of a returned expression after the conversion of `return`, for a number or an object of numbers. */
template <class T> struct IsClass {
  enum { value = __is_class(T) || __is_union(T) };
};
template <class T, bool is_class = IsClass<T>::value> struct Returned {
  typedef T Type;
};
template <class T> struct Returned<T, false> {
  typedef double Type;
};
template <class T> struct Returned<T &, false> : Returned<T> {};
template <class T> struct Returned<T const, true> : Returned<T> {};

template <class T> struct Decayed {
  typedef T Type;
};
template <class T> struct Decayed<T &> : Decayed<T> {};
template <class T> struct Decayed<T const> : Decayed<T> {};
template <class T> struct Decayed<T volatile> : Decayed<T> {};

/* The kernel of a function: its outputs are read when it returns. */
class SymrealKernel {
public:
  SymrealKernel(char const *name, char const *file, unsigned line, unsigned column, unsigned call, void const *frame)
      : active_(symreal_original_function(name, file, line, column, call, frame)) {}
  SymrealKernel(SymrealKernel const &) = delete;
  ~SymrealKernel() { symreal_original_function_end(active_); }
  int symreal_active() const { return active_; }
  template <class Value> typename Returned<Value>::Type
  symreal_returned(char const *label, char const *file, unsigned line, unsigned column, Value &&value) {
    typename Returned<Value>::Type result(static_cast<Value &&>(value));
    if (symreal_original_leaving(active_) && symreal_original_object("output", label, file, line, column, 0)) {
      walk(result, false);
      symreal_original_object_end();
      symreal_original_settle(&reinterpret_cast<char volatile &>(result), sizeof result);
    }
    return result;
  }
  template <class T> T symreal_handed_over(T &&value) {
    T result(static_cast<T &&>(value));
    symreal_original_whole(active_, &reinterpret_cast<char const volatile &>(result));
    symreal_original_handed_over(active_, &reinterpret_cast<char const volatile &>(result), sizeof result);
    return result;
  }
  template <class T, class Value> typename Decayed<Value>::Type
  symreal_returned_integer(char const *label, char const *file, unsigned line, unsigned column, Value &&value) {
    typename Decayed<Value>::Type result(static_cast<Value &&>(value));
    if (symreal_original_leaving(active_) && symreal_original_object("output", label, file, line, column, 0)) {
      double number = static_cast<double>(static_cast<T>(result));
      walk(number, true);
      symreal_original_object_end();
    }
    return result;
  }

  template <class... Containers, class Value>
  typename Returned<Value>::Type symreal_returned_layout(char const *label, char const *file, unsigned line,
                                                         unsigned column, char const *layout, Value &&value) {
    typename Returned<Value>::Type result(static_cast<Value &&>(value));
    if (symreal_original_leaving(active_) && symreal_original_object("output", label, file, line, column, 0)) {
      symreal_original_holder(&reinterpret_cast<char const volatile &>(result), sizeof result);
      symreal_original_layout(&reinterpret_cast<char const volatile &>(result), layout, Visits<Containers...>::list(),
                              1);
      symreal_original_whole(1, &reinterpret_cast<char const volatile &>(result));
      symreal_original_object_end();
      symreal_original_settle(&reinterpret_cast<char volatile &>(result), sizeof result);
    }
    return result;
  }

private:
  int active_;
};

template <class Outputs> class OnReturn {
public:
  OnReturn(int active, Outputs outputs) : active_(active), outputs_(static_cast<Outputs &&>(outputs)) {}
  OnReturn(OnReturn &&other) : active_(other.active_), outputs_(static_cast<Outputs &&>(other.outputs_)) {
    other.active_ = 0;
  }
  ~OnReturn() {
    if (symreal_original_leaving(active_)) outputs_();
  }

private:
  int active_;
  Outputs outputs_;
};
template <class Outputs> OnReturn<Outputs> symreal_on_return(int active, Outputs outputs) {
  return OnReturn<Outputs>(symreal_original_entered(active), static_cast<Outputs &&>(outputs));
}

} // namespace symreal_original

#define SYMREAL_ELEMENT(name, index, ...) (::symreal_original::symreal_element(name, index, __VA_ARGS__))
#define SYMREAL_ORIGINAL_IS_ACTIVE symreal_kernel.symreal_active()
#define SYMREAL_ORIGINAL_OWN(object)                                                                                   \
  symreal_original_own(&reinterpret_cast<char const volatile &>(object), sizeof(object));
#define SYMREAL_ORIGINAL_CHOSEN(object)                                                                                \
  symreal_original_chosen(&reinterpret_cast<char const volatile &>(object), sizeof(object));
#define SYMREAL_ORIGINAL_NUMBERS(...) ::symreal_original::symreal_numbers(__VA_ARGS__)
#define SYMREAL_ORIGINAL_BYTES(...) ::symreal_original::symreal_bytes(__VA_ARGS__)
#define SYMREAL_ORIGINAL_LAYOUT(layout, types, ...)                                                                    \
  symreal_original_layout(__builtin_addressof(__VA_ARGS__), layout,                                                    \
                          ::symreal_original::symreal_visits<SYMREAL_WORDS types>(), 0)
#define SYMREAL_ORIGINAL_FUNCTION(name, file, line, column, call)                                                      \
  ::symreal_original::SymrealKernel symreal_kernel(name, file, line, column, call, SYMREAL_ORIGINAL_FRAME);            \
  SYMREAL_ORIGINAL_AGAIN(symreal_kernel.symreal_active())
#define SYMREAL_RETURN(label, file, line, column, ...)                                                                 \
  (symreal_kernel.symreal_returned(label, file, line, column, __VA_ARGS__))
/* The function's result, converted from the expression as by `return`. */
#define SYMREAL_RETURNED_AS(type, ...) [&]() -> SYMREAL_WORDS type { return __VA_ARGS__; }()
#define SYMREAL_RETURN_AS(label, file, line, column, type, ...)                                                        \
  SYMREAL_RETURN(label, file, line, column, SYMREAL_RETURNED_AS(type, __VA_ARGS__))
#define SYMREAL_RETURN_WHOLE(type, ...) (symreal_kernel.symreal_handed_over(SYMREAL_RETURNED_AS(type, __VA_ARGS__)))
#define SYMREAL_BOOL bool
#define SYMREAL_RETURN_INTEGER(label, file, line, column, type, ...)                                                   \
  (symreal_kernel.symreal_returned_integer<SYMREAL_WORDS type>(label, file, line, column, __VA_ARGS__))
#define SYMREAL_RETURN_LAYOUT_AS(label, file, line, column, layout, types, type, ...)                                  \
  SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, SYMREAL_RETURNED_AS(type, __VA_ARGS__))
#define SYMREAL_RETURN_LAYOUT(label, file, line, column, layout, types, ...)                                           \
  (symreal_kernel.symreal_returned_layout<SYMREAL_WORDS types>(label, file, line, column, layout, __VA_ARGS__))
#define SYMREAL_ORIGINAL_OUTPUTS(...)                                                                                  \
  auto symreal_outputs = ::symreal_original::symreal_on_return(symreal_kernel.symreal_active(), [&] { __VA_ARGS__ });  \
  (void)symreal_outputs;

#endif

#include "names_show.h"

#endif
