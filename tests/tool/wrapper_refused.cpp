// What no other file can define has no wrapper; what only this file has is told.
// DEFINE: %{flag} =
// DEFINE: %{generate} = %symreal generate %s -o %t.d/k.c --wrapper -- %{flag}
// RUN: rm -rf %t.d && mkdir %t.d
// REDEFINE: %{flag} = -DKIND=static
// RUN: not %{generate} 2>&1 | FileCheck %s --check-prefix=STATIC
// STATIC: error: --wrapper cannot take the place of 'gain': it is static or in an unnamed namespace, so only its own file can call it [SYM095]
// REDEFINE: %{flag} = -DKIND=inline
// RUN: not %{generate} 2>&1 | FileCheck %s --check-prefix=INLINE
// INLINE: error: --wrapper cannot take the place of 'gain': it is inline, so each source that calls it has its own copy; define it in one source [SYM095]
// RUN: ls %t.d | count 0
// REDEFINE: %{flag} =
// RUN: %{generate} 2>&1 | FileCheck %s --check-prefix=MISSING
// MISSING: wrapper_refused.cpp:[[#@LINE+12]]:1: warning: the wrapper of 'gain' cannot be compiled alone: only {{.*}}wrapper_refused.cpp has Motor, load [SYM096]
// RUN: FileCheck %s --check-prefix=BEHIND < %t.d/k_wrapper.cpp
// BEHIND: Only the original's file has Motor, load: include this file there, behind them, in place of the function.
#ifndef KIND
#define KIND
#endif

struct Motor {
  double torque;
};
static double load = 3;

#pragma symreal function input(motor.torque, load) output(return)
KIND double gain(Motor const &motor) { return motor.torque / load; }

int main() { return gain({2.0}) > 5; }
