// Inverse dynamics, mass matrix and forward dynamics of a serial robot. `inertial` are the inertial parameters of all
// links, ten for each (see Inertia).
#pragma once

#include "robot.h"

namespace dh {

// tau by Newton's and Euler's equations, out along the links and back.
void newton_euler(Robot const &robot, double const *inertial, double const *q, double const *qd, double const *qdd,
                  double *tau);

// The n x n mass matrix, row by row.
void mass_matrix(Robot const &robot, double const *inertial, double const *q, double *M);

// qdd from M(q) qdd = tau - tau(q, qd, 0).
void accelerations(Robot const &robot, double const *inertial, double const *q, double const *qd, double const *tau,
                   double *qdd);

} // namespace dh
