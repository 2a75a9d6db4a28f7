// Costs of operations, selected by an option.
#pragma once

#include "engine/analysis/costs/costs.h"

#include <string>

namespace symreal::tool {

// `cost`: unit, table, or a file of `symreal measure-costs`. Throws cost_file, unreadable_file.
Costs costs_named(std::string const &cost);

} // namespace symreal::tool
