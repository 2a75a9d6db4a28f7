// Fewer parameters that do the same: base parameters.
//
// Where outputs are sums of products of a function of the inputs and a parameter, as the torques of a robot are in the
// inertial parameters of its links, some of these functions are sums of others times numbers. A parameter with such a
// function is 0 once its share is added to the parameters of the others, which costs nothing in `compute`. After
// Gautier and Khalil, "Direct calculation of minimum set of inertial parameters of serial robots" (1990), but found by
// evaluation at random points over the prime field, for whatever the program computes.
#pragma once

#include "engine/optimise/algebra/network.h"

namespace symreal::algebra {

// The network with fewer parameters, or nothing where none can be left out. `too_many` becomes the number of
// parameters, what is made of parameters included, where they are too many for this network to be looked at.
std::optional<Network> with_base_parameters(Network const &network, std::size_t *too_many = nullptr);

} // namespace symreal::algebra
