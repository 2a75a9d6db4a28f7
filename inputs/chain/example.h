// What the example programs share: the model and the state they run on, and how they print.
#ifndef CHAIN_EXAMPLE_H
#define CHAIN_EXAMPLE_H

#include "algorithms.h"

namespace chain {

// argv: [number of links [model table]].
Model example_model(int argc, char **argv);

// n numbers first, first + step, ...
std::vector<double> sequence(int n, double first, double step);
inline std::vector<double> example_q(int n) { return sequence(n, 0.3, 0.2); }
inline std::vector<double> example_qd(int n) { return sequence(n, 0.5, -0.1); }
inline std::vector<double> example_qdd_or_tau(int n) { return sequence(n, -0.4, 0.3); }

void print(std::vector<double> const &values);

} // namespace chain

#endif
