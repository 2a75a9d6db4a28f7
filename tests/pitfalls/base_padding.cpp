// What follows a base class begins where it does with double: behind the padding of a plain structure.
// RUN: %same %s
// RUN: %rewrite %s | FileCheck %s
// RUN: %cxx %s -o %t.orig && %symreal-c++ %s -o %t.exe && %t.orig > %t.plain && %t.exe | diff %t.plain -
#include <cstddef>
#include <cstdio>
#include <cstring>

struct Sample {
  double value;
  char kind;
  // CHECK: REAL_PADDING(7) };
};
struct Marked : Sample {
  char mark;
};
struct Counted {
  double value;
  int count;
  // CHECK: REAL_PADDING(4) };
};
struct Holder {
  [[no_unique_address]] Counted counted;
  int more;
};
// CHECK: {{^}}struct Alone {
struct Alone {
  double value;
  char kind;
};

int main() {
  Marked marked;
  marked.mark = 3;
  Sample const sample{5.5, 'k'};
  auto const [value, kind] = sample;
  std::memcpy(static_cast<void *>(static_cast<Sample *>(&marked)), static_cast<void const *>(&sample), sizeof sample);
  std::printf("%d %g %c %zu %zu %zu\n", marked.mark, static_cast<double>(value), kind, sizeof marked, sizeof(Holder),
              sizeof(Alone));
}
