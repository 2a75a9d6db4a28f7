// Sections within their objects, and those behind pointers, are taken: a pointer's extent is the pragma's, an array of one element
// may go on behind the end of its structure, and a class may count its elements as it likes.
// RUN: %symreal generate %s --kernel all -o %t.c -- -std=c++20
// RUN: %symreal verify %s %t.c --samples=50 -- -std=c++20
// RUN: %symreal generate %s --kernel 'counted(n=3, h[0:n]=0.5, p[1:2]={1, 2}) -> return' -o %t.c
#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <vector>

struct Tail {
  int n;
  double a[1];
};
// Elements -1 to 2 of two and two ghosts.
struct Ghosts {
  double d[4];
  int size() const { return 2; }
  double &operator[](int i) { return d[i + 1]; }
};

#pragma symreal function input(p[-1:3], t->a[0:3], g[-1:4], v[1:n], r[0:4][0:2], u[0:2]) output(m[7], y[0:4])
void all(double const *p, Tail *t, Ghosts &g, std::vector<double> const &v, double (&r)[4][2],
         std::unique_ptr<double[]> const &u, std::map<int, double> &m, std::array<double, 4> &y, int n) {
  m[7] = p[-1] + t->a[2] * g[-1];
  for (int i = 0; i < 4; ++i) y[i] = v[1 + i % n] * r[i][1] - u[i % 2];
}

double counted(double const h[4], double const *p, int n) { return h[n - 1] * p[2]; }

int main() {
  double p[3] = {1, 2, 3}, r[4][2] = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  auto *t = static_cast<Tail *>(std::calloc(1, sizeof(Tail) + 2 * sizeof(double)));
  Ghosts g = {{1, 2, 3, 4}};
  std::vector<double> v(3, 0.5);
  std::unique_ptr<double[]> u(new double[2]{1, 2});
  std::map<int, double> m = {{7, 0}};
  std::array<double, 4> y;
  all(p + 1, t, g, v, r, u, m, y, 2);
  std::free(t);
}
