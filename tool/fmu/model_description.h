// The XML of a functional mock-up unit (FMI 3.0).
#pragma once

#include "tool/fmu/unit_variables.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct UnitNames {
  std::string model;      // in words
  std::string identifier; // of files and functions
  std::string token;      // by which a description and its code know each other
};

// modelDescription.xml
std::string model_description(UnitNames const &names, std::vector<UnitVariable> const &variables);

// sources/buildDescription.xml
std::string build_description(std::string const &identifier, std::vector<std::string> const &sources,
                              std::string const &compiler_options);

} // namespace symreal::tool
