#include <cstdio>

template <class T> bool same(char const *text, T const &x, T const &y) {
  std::printf("%s\n", text);
  return x == y;
}
inline bool near(char const *text, double x, double y) {
  std::puts(text);
  return x - y < 1e-9 && y - x < 1e-9;
}
#define SAME(x, y) (same(#x " == " #y, (x), (y)))
constexpr char const *operator""_text(char const *text, std::size_t) { return text; }
#define NEAR(x, y) near(#x##_text, x, y)
#define BOTH(x, y) (SAME(x, 0.25) && SAME(y, 0.5))
