// Messages about frozen state, whose values are baked into the program.
#pragma once

#include "engine/graph/graph.h"

#include <optional>
#include <string>

namespace symreal {

// The first few values, and their number.
std::string value_list(std::vector<double> const &values);

// Severity of a frozen state under a --frozen policy; nullopt if it is only listed.
std::optional<Severity> frozen_severity(Frozen const &state, std::string const &policy);

std::string frozen_message(std::string const &kernel, Frozen const &state);

} // namespace symreal
