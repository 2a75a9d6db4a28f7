// A symbolic main is linked with the library of programs that the tool runs, and is started by hand.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: %cxx -std=c++20 -DMBD_SYMBOLIC -I%runtime_include %s %runtime_library -o symbolic
// RUN: not ./symbolic 2>&1 | FileCheck %s
// RUN: not ls twice.c
#include <symreal/symbolic_main.h>

int main() {
  output("y", 2 * create_runtime_const("x"));
  generate_code("twice.c");
}

// CHECK: error: kernel 'twice' is recorded, and this program is linked without an emitter [SYM207]
// CHECK: help: {{.*}}libsymreal_generate.a
