// Functions that are declared here and defined nowhere, and REALs that leave the program.
// RUN: not %rewrite %s 2>&1 | FileCheck %s --implicit-check-not=unused --implicit-check-not=ostream --implicit-check-not=calculate --implicit-check-not=turned --implicit-check-not=scaled --implicit-check-not=rounded
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <unistd.h>

struct Rotation { double data[9]; };
// CHECK-DAG: boundary.cpp:[[@LINE+1]]:10: error: 'multiply' uses double but is not defined in the given sources [SYM030]
Rotation multiply(Rotation const &a, Rotation const &b);
Rotation unused(Rotation const &a);
inline Rotation also_unused(Rotation const &a) { return unused(a); }
int count(std::string const &name);
// What a source instantiates explicitly it defines.
template <class T> struct Angle { T turned(T x) const; T a; };
template <class T> T scaled(T x);
extern template struct Angle<double>;
double turn(Angle<double> const &angle) { return angle.turned(1.0) + scaled(angle.a); }
template <class T> T Angle<T>::turned(T x) const { return a + x; }
template <class T> T scaled(T x) { return 2 * x; }
template struct Angle<double>;
template <class T> struct Turn { static T rounded(T x); };
double round_turn(double x) { return Turn<double>::rounded(x); }
template <class T> T Turn<T>::rounded(T x) { return x + 1; }
template double Turn<double>::rounded(double);
template double scaled<double>(double);
// Only the tables of the classes that define it refer to it.
struct Joint { virtual double calculate(double q) = 0; };
double step(Joint &joint, double q) { return joint.calculate(q); }

// CHECK-DAG: boundary.cpp:[[@LINE+1]]:56: note: it is used here
Rotation square(Rotation const &a) { count(""); return multiply(a, a); }

// Whether the bytes are those of a symbolic value the run tells.
void save(double *x, int file) { (void)!write(file, x, sizeof *x); }
void copy(double *x, double const *y) { memcpy(x, y, sizeof *x); memset(x, 0, sizeof *x); std::cout << *x; }
unsigned long bits(double &x) { return *reinterpret_cast<unsigned long *>(&x); }
struct Packed { int n : 4; };
// CHECK-DAG: boundary.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the result is a REAL and is converted to int [SYM034]
void add(Packed &packed, double x) { packed.n += x; }
// CHECK-DAG: boundary.cpp:[[@LINE+1]]:{{[0-9]+}}: error: a REAL is changed by what is computed in long double [SYM036]
void widen(double &x, long double y) { x /= y; }
