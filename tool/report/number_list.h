// Inputs of a sample for a message: the first 16.
#pragma once

#include <string>
#include <vector>

namespace symreal::tool {

std::string number_list(std::vector<double> const &values);

} // namespace symreal::tool
