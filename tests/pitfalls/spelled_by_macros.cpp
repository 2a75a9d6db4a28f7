// A `double` that macros paste together, or that stands on the command line, is in no file that could be edited.
// RUN: not %rewrite %s -- -DSPELLED=double 2>&1 | FileCheck %s
#define PASTE(a, b) a##b
#define DECLARE(kind, name) kind##_number name
typedef double real_number;
// CHECK: spelled_by_macros.cpp:[[@LINE+2]]:1: error: this `double` is spelled by a macro that cannot be edited [SYM033]
// CHECK: spelled_by_macros.cpp:3:{{[0-9]+}}: note: in the expansion of macro 'PASTE'
PASTE(dou, ble) pasted = 1.0;
// What is pasted to the name of a type is as good as written.
// CHECK-NOT: spelled_by_macros.cpp:[[@LINE+1]]
DECLARE(real, fine) = 2.0;
// CHECK: spelled_by_macros.cpp:[[@LINE+2]]:1: error: this `double` is spelled by a macro that cannot be edited [SYM033]
// CHECK: <command line>:1:{{[0-9]+}}: note: in the expansion of macro 'SPELLED'
SPELLED given = 3.0;
