#define N 6
#define T 5
#define value 7
#define place 1
#include <symreal/symbolic_main.h>

int main() {
  REAL x[N];
  for (int i = 0; i < N; ++i) x[i] = i;
  input("x", x);
  REAL y = SIN(x[T]) * value + place;
  output("y", y);
  generate_code("by_hand_code.c");
}
