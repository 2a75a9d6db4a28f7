// What is told of state that is baked in.
#pragma once

#include "engine/graph/graph.h"

#include <optional>
#include <string>

namespace symreal {

// The first few of them, and how many there are.
std::string value_list(std::vector<double> const &values);

// What --frozen makes of it: nothing where it is only listed.
std::optional<Severity> frozen_severity(Frozen const &state, std::string const &policy);

std::string frozen_message(std::string const &kernel, Frozen const &state);

} // namespace symreal
