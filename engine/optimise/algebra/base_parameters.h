// Base parameters: a smaller set of parameters with the same outputs.
//
// In outputs that are sums of products of a function of the inputs and a parameter, as a robot's torques are in its
// links' inertial parameters, some functions are linear combinations of others. A parameter with such a function
// becomes 0 after its shares are added to the other parameters, which is free in `compute`. After Gautier and Khalil,
// "Direct calculation of minimum set of inertial parameters of serial robots" (1990), but found by evaluation at random
// points over the prime field, for any program.
#pragma once

#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// The network with fewer parameters; nullopt if all are needed. If there are too many to analyse, `too_many` receives
// their number, values computed from parameters alone included.
std::optional<Network> with_base_parameters(Network const &network, std::size_t *too_many = nullptr);

} // namespace symreal::algebra
