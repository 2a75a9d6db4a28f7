// constant(...) names what may be baked in: members, sections, containers, and whole objects with all that they own.
// RUN: %symreal generate %s -o %t.c 2>&1 | FileCheck %s --implicit-check-not=SYM017
// RUN: %symreal verify %s %t.c --samples=100
// CHECK-NOT: baked in
// CHECK: kernel force
// CHECK-NOT: baked in
// The pragma of another function names too little.
// RUN: not %symreal generate %s -o %t.c -- -DLITTLE 2>&1 | FileCheck %s --check-prefix=LITTLE
// LITTLE: error: kernel 'force' reads 'bodies[i].mass' (3), which is neither input nor parameter [SYM017]
// LITTLE-NOT: SYM017]
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

struct Body {
  std::string name;
  double mass, centre[3];
};

class Named {
protected:
  explicit Named(double base) : base_(base) {}
  double base_;
};

template <class T> class World : private Named {
public:
  World(std::vector<Body> bodies, T friction)
      : Named(10),
        bodies_(std::move(bodies)),
        by_name_{{"a", 8}},
        extra_(new T(9)),
        friction_(friction) {}

  T force(T x) const {
    T sum = friction_ * x + base_ + by_name_.at("a") + *extra_;
    for (unsigned i = 0; i < bodies_.size(); i++) sum += bodies_[i].mass * bodies_[i].centre[2] * x;
    return sum;
  }
  std::vector<Body> const &bodies() const { return bodies_; }

private:
  std::vector<Body> bodies_;
  std::map<std::string, T> by_name_;
  std::unique_ptr<T> extra_;
  T friction_;
};

struct Table {
  double rows[2][2];
  double *more;
  std::vector<double> list;
};


struct Arm {
  double length;
  World<double> const *model;

#ifdef LITTLE
#pragma symreal function input(x) constant(this->length, model->bodies()[0:1].mass, model->bodies()[0:2].centre) constant(table.rows[1], table.more[0:2], table.list) output(return)
#else
#pragma symreal function input(x) constant(length, *model) constant(table.rows[1], table.more[0:2], table.list) output(return)
#endif
  double force(Table const &table, double x) {
#ifdef LITTLE
    double sum = length * x;
    std::vector<Body> const &bodies = model->bodies();
    for (unsigned i = 0; i < 2; i++) sum += bodies[i].mass * bodies[i].centre[0] * x;
    return sum;
#else
    return model->force(x) * length + table.rows[1][1] + table.more[1] * x + table.list[0];
#endif
  }
};

int main() {
  double more[2] = {5, 6};
  World<double> const world({{"a", 2, {0, 0, 0.5}}, {"b", 3, {0, 0, 0.25}}}, 0.125);
  Table const table = {{{1, 2}, {3, 4}}, more, {7}};
  Arm arm = {2.0, &world};
  std::printf("%g\n", arm.force(table, 0.5));
}
