// XML files of a functional mock-up unit (FMI 3.0).
#pragma once

#include "tool/fmu/unit_variables.h"

#include <string>
#include <vector>

namespace symreal::tool {

struct UnitNames {
  std::string model;      // title
  std::string identifier; // identifier of files and functions
  std::string token;      // token that ties a description to its code
};

// Text of modelDescription.xml.
std::string model_description(UnitNames const &names, std::vector<UnitVariable> const &variables);

// Text of sources/buildDescription.xml.
std::string build_description(std::string const &identifier, std::vector<std::string> const &sources,
                              std::string const &compiler_options);

} // namespace symreal::tool
