// Reader of the parts of a configuration that replace pragmas.
//
//   kernels:
//     - function: arm::inverse_dynamics     # its clauses are those of the pragma
//       inputs: [q, "qd[0:n]"]              # items, or item: [low, high]
//       range: [-3.14, 3.14]                # of inputs without a range of their own
//       parameters: m
//       outputs: tau[0:n]
#pragma once

#include "tool/configuration/yaml.h"

namespace symreal::tool {

rewrite::ConfiguredKernel read_kernel(Yaml const &node, std::string const &directory);
rewrite::ConfiguredExternal read_external(Yaml const &node);

} // namespace symreal::tool
