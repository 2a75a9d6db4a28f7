// Annotations as plain calls, for a hand-written symbolic main. Without -DMBD_SYMBOLIC the same program is the numeric
// one.
//
//   REAL q = create_runtime_const("q", 0.5);
//   output("y", SIN(q) * 10.0);
//   generate_code("y.c");
#pragma once

#include <symreal/real.h>

#include <symreal/names_hide.h>

#include <math.h>

#define PI 3.14159265358979323846

#if defined(MBD_SYMBOLIC) || defined(MBD_REPLAY)

#define SYMREAL_CALLER                                                                                                 \
  ::symreal::SourcePlace place = {__builtin_FILE(), __builtin_LINE(), 1, __builtin_frame_address(0)}

inline REAL create_runtime_const(char const *name, double value, SYMREAL_CALLER) {
  REAL number = value;
  ::symreal::symreal_annotate(::symreal::Kind::input, name, place, static_cast<REAL &&>(number));
  return number;
}
// An input without a value: the program cannot decide on, print or convert values that depend on it.
inline REAL create_runtime_const(char const *name, SYMREAL_CALLER) {
  return create_runtime_const(name, ::symreal::missing_value(), place);
}
inline REAL create_parameter(char const *name, double value, SYMREAL_CALLER) {
  REAL number = value;
  ::symreal::symreal_annotate(::symreal::Kind::parameter, name, place, static_cast<REAL &&>(number));
  return number;
}
// Annotates numbers, arrays, std::array, std::vector and Eigen objects in place.
template <class T> void input(char const *name, T &object, SYMREAL_CALLER) {
  ::symreal::symreal_annotate(::symreal::Kind::input, name, place, object);
}
template <class T> void parameter(char const *name, T &object, SYMREAL_CALLER) {
  ::symreal::symreal_annotate(::symreal::Kind::parameter, name, place, object);
}
// Annotates structures of numbers, whose layout the rewriter supplies.
inline void input(char const *name, ::symreal::LaidOut &&object, SYMREAL_CALLER) {
  object.annotate(::symreal::Kind::input, name, place);
}
inline void parameter(char const *name, ::symreal::LaidOut &&object, SYMREAL_CALLER) {
  object.annotate(::symreal::Kind::parameter, name, place);
}
inline void output(char const *name, ::symreal::LaidOut &&object, SYMREAL_CALLER) {
  object.annotate(::symreal::Kind::output, name, place);
}
template <class T> void output(char const *name, T &&object, SYMREAL_CALLER) {
  ::symreal::symreal_annotate(::symreal::Kind::output, name, place, static_cast<T &&>(object));
}
// Adds derivatives of outputs by inputs as further outputs: differentiate("jacobian(y, [q, qd])").
inline void differentiate(char const *derivative, SYMREAL_CALLER) {
  ::symreal::symreal_differentiate(derivative, place);
}
// Ends the kernel and writes its code.
inline void generate_code(char const *file_name, SYMREAL_CALLER) { ::symreal::symreal_generate(file_name, place); }

#undef SYMREAL_CALLER

#else

static inline double create_runtime_const(char const *name, double value) { return (void)name, value; }
static inline double create_parameter(char const *name, double value) { return (void)name, value; }
template <class T> void input(char const *, T const &) {}
template <class T> void parameter(char const *, T const &) {}
template <class T> void output(char const *, T const &) {}
static inline void differentiate(char const *derivative) { (void)derivative; }
static inline void generate_code(char const *file_name) { (void)file_name; }

#endif

static inline REAL SIN(REAL x) { return sin(x); }
static inline REAL COS(REAL x) { return cos(x); }

#include <symreal/names_show.h>
