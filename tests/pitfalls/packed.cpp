// Packed and aligned classes have the sizes and offsets that they have with double.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %cxx %s -o %t.orig && %symreal-c++ %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
// RUN: %symreal generate %s -o %t.c && %symreal verify %s %t.c --samples=100
#include <cstddef>
#include <cstdio>
#include <cstring>

// CHECK: struct __attribute__((packed)) Message { {{.*}}REAL_LAYOUT(public, sizeof(symreal_class) == 9 && alignof(symreal_class) == 1 && {{.*}}symreal_class, value) == 1)
struct __attribute__((packed)) Message {
  unsigned char id;
  double value;
};
#pragma pack(push, 1)
typedef struct {
  char tag;
  double pair[2];
} Pair;
#pragma pack(pop)
#pragma pack(push, 4)
struct Four {
  int tag;
  double value;
};
#pragma pack(pop)
struct Member {
  char tag;
  double value __attribute__((packed));
};
struct alignas(32) Wide {
  double value;
};
struct Inner {
  char tag;
  alignas(16) double value;
};
template <class T> struct __attribute__((packed)) Tagged {
  short tag;
  T value;
};

#pragma symreal function input(x[0:2]) output(y[0:6])
void measure(double const *x, double *y) {
  Message message{1, x[0]};
  Pair pair{2, {x[0], x[1]}};
  Member member;
  member.value = x[1];
  Tagged<double> tagged{3, x[0]};
  Four four{4, x[1]};
  y[0] = message.value * sizeof(Message) + offsetof(Message, value);
  y[1] = pair.pair[1] * sizeof(Pair) + alignof(Pair);
  y[2] = member.value * sizeof(Member) + four.value * sizeof four;
  y[3] = tagged.value * sizeof tagged;
  message.value += y[0];
  y[4] = message.value * sizeof(Wide) * alignof(Wide);
  y[5] = x[0] * offsetof(Inner, value) * sizeof(Inner);
}

int main() {
  double x[2] = {5.3, 2.0}, y[6], number = 13.25;
  measure(x, y);
  for (double each : y) std::printf("%.17g\n", each);
  unsigned char buffer[sizeof(Message)] = {7};
  std::memcpy(buffer + 1, &number, sizeof number);
  Message received;
  std::memcpy(static_cast<void *>(&received), buffer, sizeof received);
  std::printf("%d %g\n", received.id, static_cast<double>(received.value));
}
