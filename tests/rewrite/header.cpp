// A header that two sources include is edited once; it is part of the result even when nothing in it changes.
// RUN: cd %S && %symreal rewrite --out-root %t header.cpp Inputs/second.cpp && FileCheck %s < %t/Inputs/shared.h
// RUN: FileCheck --check-prefix=PLAIN %s < %t/Inputs/plain.h
// RUN: %same %s %S/Inputs/second.cpp
#include "Inputs/shared.h"
// CHECK: #line 1 "Inputs/shared.h"
// CHECK: inline REAL twice(REAL x) { return std::max(x, REAL_C(0.0)) + REAL_LATER(from_second(x)); }
// PLAIN: #line 1 "Inputs/plain.h"
// PLAIN-NEXT: #define PLAIN 1
double first(double x) { return twice(x); }
