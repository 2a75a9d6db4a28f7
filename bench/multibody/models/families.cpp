// families KERNEL SHAPE N: one of the kernels below on a tree of N bodies.
#include "tree.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using tree::Tree;

#pragma symreal function input(q[0 : tree.n]) constant(tree) output(pose[0 : 12 * tree.tips])
void fk(Tree const &tree, double const *q, double *pose) { forward_kinematics(tree, q, pose); }

#pragma symreal function input(q[0 : tree.n], target[0 : 3]) constant(tree) output(q_next[0 : tree.n])
void ik(Tree const &tree, double const *q, double const *target, double *q_next) {
  inverse_kinematics(tree, q, target, q_next);
}

#pragma symreal function input(q[0 : tree.n], qd[0 : tree.n], qdd[0 : tree.n]) constant(tree) output(tau[0 : tree.n])
void rnea(Tree const &tree, double const *q, double const *qd, double const *qdd, double *tau) {
  inverse_dynamics(tree, q, qd, qdd, tau);
}

#pragma symreal function input(q[0 : tree.n]) constant(tree) output(H[0 : tree.n * tree.n])
void crba(Tree const &tree, double const *q, double *H) { mass_matrix(tree, q, H); }

#pragma symreal function input(q[0 : tree.n], qd[0 : tree.n], tau[0 : tree.n]) constant(tree) output(qdd[0 : tree.n])
void aba(Tree const &tree, double const *q, double const *qd, double const *tau, double *qdd) {
  forward_dynamics(tree, q, qd, tau, qdd);
}

int main(int argc, char **argv) {
  if (argc < 4) return 1;
  std::string const kernel = argv[1];
  static Tree const model = tree::make_tree(argv[2], std::atoi(argv[3]));
  std::vector<double> a, b, c, result(std::max(12 * model.n, kernel == "crba" ? model.n * model.n : 0));
  for (int i = 0; i < model.n; i++) {
    a.push_back(0.3 + 0.1 * (i % 7));
    b.push_back(0.5 - 0.1 * (i % 5));
    c.push_back(-0.4 + 0.3 * (i % 3));
  }
  double const target[3] = {0.2, 0.3, 0.4};
  if (kernel == "fk") fk(model, a.data(), result.data());
  if (kernel == "ik") ik(model, a.data(), target, result.data());
  if (kernel == "rnea") rnea(model, a.data(), b.data(), c.data(), result.data());
  if (kernel == "crba") crba(model, a.data(), result.data());
  if (kernel == "aba") aba(model, a.data(), b.data(), c.data(), result.data());
  double sum = 0;
  for (double value : result) sum += value * value;
  std::printf("%.17g\n", std::sqrt(sum));
}
