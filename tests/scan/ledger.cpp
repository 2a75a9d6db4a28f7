// Each type that is spelled, compiled or not, has its place in the ledger.
// RUN: %symreal scan --list %s > %t.txt
// RUN: FileCheck %s < %t.txt
// CHECK: total {{ *}}21 {{ *}}7 {{ *}}10 {{ *}}0 {{ *}}4 {{ *}}41%
// CHECK: left as they are: 1 float, 1 long double
// CHECK: passive
// CHECK: 2  an argument of a template that counts in plain numbers; first at {{.*}}ledger.cpp:{{[0-9]+}}:26
// CHECK: 1  kept by a comment; first at
// CHECK: inactive
// CHECK: 1  not compiled: #if 0; first at
// CHECK: obstacles
// CHECK-NEXT: 3  SYM041 Symreal does not know what a double is part of; first at
// RUN: %same %s -- -Wno-pragmas
// CHECK: what stays
#include <chrono>
#include <random>
#define TEXT(x) #x
#define DROP(x)
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:27: double is inactive: in a macro that is not expanded: NEVER_EXPANDED
#define NEVER_EXPANDED(x) double x
#define NUMBER double
NUMBER number;
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:11: double is passive: constexpr
constexpr double scale = 2.5;
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:22: double is passive: static_assert
static_assert(sizeof(double) == 8, "");
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:20: double is passive: the bound of an array
char buffer[sizeof(double)];
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:22: double is passive: the value of an enumerator
enum { size = sizeof(double) };
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:26: double is passive: an argument of a template that counts in plain numbers
std::normal_distribution<double> normal;
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:23: double is passive: an argument of a template that counts in plain numbers
std::chrono::duration<double> elapsed;
// CHECK-NEXT: ledger.cpp:[[@LINE+2]]:24: double is passive: a macro turns it into text
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:42: double is passive: an argument that its macro drops
char const *t = TEXT( (double) 1 ); DROP(double)
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:1: double is passive: kept by a comment
double kept; // symreal: keep
// CHECK-NEXT: ledger.cpp:[[@LINE+2]]:1: float is passive: float is left as it is
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:15: long double is passive: long double is left as it is
float f; long double l; double converted;
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:18: double is passive: in a directive: #pragma
#pragma unknown (double)
template <class T> T twice(T x) { return x + x; }
// CHECK-NEXT: ledger.cpp:[[@LINE+3]]:10: double is converted: follows its neighbours: SYM041
// CHECK-NEXT: ledger.cpp:[[@LINE+2]]:23: double is converted: follows its neighbours: SYM041
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:31: double is converted: follows its neighbours: SYM041
template double twice<double>(double);
#if 0
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:1: double is inactive: not compiled: #if 0
double inactive;
#elif defined WHATEVER
#ifdef DEEPER
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:1: double is inactive: not compiled: #elif defined WHATEVER
double inactive;
#endif
#else
double active;
#endif
#ifndef WHATEVER
double /* a comment is no double */ active_too;
#else
// CHECK-NEXT: ledger.cpp:[[@LINE+1]]:1: double is inactive: not compiled: #else of #ifndef WHATEVER
double inactive_too;
#endif
char const *text = "a double in a string", *raw = R"(and a double in a raw one)";
