// Code that finds a class where a number was takes another way while it is recorded: each place is named.
// RUN: rm -f %t.c
// RUN: not %symreal generate %s -o %t.c -- -std=c++20 2>&1 | FileCheck %s
// RUN: not ls %t.c
#include <concepts>
#include <cstdio>
#include <type_traits>
#include <utility>

struct small { char c; };
struct large { char c[2]; };

// Only a class has members.
template <class T> small has_members(int T::*);
template <class T> large has_members(...);
// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the function 'has_members' is that of {{.*}}:[[@LINE-2]] in the symbolic program, and that of {{.*}}:[[@LINE-1]] in the original [SYM120]
template <class T> double detected(T x) { return sizeof(has_members<T>(0)) == 1 ? -x : x; }

template <class T, class = void> struct tag { static constexpr int value = 1; };
template <class T> struct tag<T, std::void_t<void (T::*)()>> { static constexpr int value = 2; };
// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: 'tag<double, void>::value' is 2 in the symbolic program, and 1 in the original [SYM120]
template <class T> double tagged(T x) { return x * tag<T>::value; }

// An own test of what converts.
template <class T> struct converts {
  static small test(int);
  static large test(...);
  static constexpr bool value = sizeof(test(std::declval<T>())) == 1;
};
// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: 'converts<double>::value' is 0 in the symbolic program, and 1 in the original [SYM120]
template <class T> double converted(T x) { return converts<T>::value ? x : -x; }

// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: this trait is 1 in the symbolic program, and 0 in the original [SYM120]
template <class T> double by_builtin(T x) { return __is_class(T) ? -x : x; }

template <class T> concept Derivable = requires { sizeof(int T::*); };
// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: this concept is 1 in the symbolic program, and 0 in the original [SYM120]
template <class T> double by_concept(T x) { if constexpr (Derivable<T>) return -x; else return x; }

// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the condition of this `if constexpr` is true in the symbolic program, and false in the original [SYM120]
template <class T> double narrows(T x) { if constexpr (requires { int{x}; }) return -x; else return x; }

// A specialisation that is chosen by a trait.
template <class T, bool = __is_class(T)> struct chosen { static double of(T x) { return x; } };
template <class T> struct chosen<T, true> { static double of(T x) { return -x; } };
// CHECK-DAG: types_asked.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the function 'of' is that of {{.*}}:[[@LINE-1]] in the symbolic program, and that of {{.*}}:[[@LINE-2]] in the original [SYM120]
static double by_specialisation(double x) { return chosen<double>::of(x); }

#pragma symreal function input(x) output(return)
double kernel(double x) {
  return detected(x) + tagged(x) + converted(x) + by_builtin(x) + by_concept(x) + narrows(x) +
         by_specialisation(x);
}

int main() { std::printf("%.17g\n", kernel(0.5)); }
