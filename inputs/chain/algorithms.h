// The four classical algorithms on a chain with a fixed base: every product in full, no care for zeros.
#ifndef CHAIN_ALGORITHMS_H
#define CHAIN_ALGORITHMS_H

#include "model.h"

namespace chain {

// The pose of the last link in the base: nine numbers for the rotation (tip to base, row by row), three for the
// position.
void forward_kinematics(Model const &model, double const *q, double *pose);

// tau(q, qd, qdd) by the recursive Newton-Euler algorithm.
void inverse_dynamics(Model const &model, double const *q, double const *qd, double const *qdd, double *tau);

// The joint-space inertia matrix, n by n, by the composite-rigid-body algorithm.
void mass_matrix(Model const &model, double const *q, double *H);

// qdd(q, qd, tau) by the articulated-body algorithm.
void forward_dynamics(Model const &model, double const *q, double const *qd, double const *tau, double *qdd);

} // namespace chain

#endif
