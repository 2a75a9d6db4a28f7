// Pointers to the bytes of REALs that are kept: nobody can tell when they are read.
// RUN: not %symreal generate %s -o %t.c 2>&1 | FileCheck %s
// RUN: not ls %t.c

struct View {
  unsigned char const *bytes;
};

unsigned char const *kept;

// CHECK: bytes.cpp:[[@LINE+1]]:42: error: the bytes of a REAL are read as const unsigned char *, by a pointer that is kept [SYM035]
void in_static(double const *x) { kept = (unsigned char const *)x; }
// CHECK: bytes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are read as const unsigned char *, by a pointer that is kept
void in_member(View &view, double const *x) { view.bytes = (unsigned char const *)x; }
// CHECK: bytes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are read as const unsigned char *, by a pointer that is kept
View in_list(double const *x) { return View{(unsigned char const *)x}; }
// CHECK: bytes.cpp:[[@LINE+1]]:{{[0-9]+}}: error: the bytes of a REAL are read as const unsigned char *, by a pointer that is kept
unsigned char const *returned(double const *x) { return (unsigned char const *)x; }

int main() {}
