// Writes the clauses that the pragmas of kernels lack into the project's configuration.
#pragma once

#include "program/record/record.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::tool {

struct Lacking {
  rewrite::Kernel kernel;
  std::map<std::string, std::string> clauses; // arguments by clause: "name, name"
};

// The configuration's text with these clauses in their kernels' entries; comments stay. A function whose pragma stands
// in a source gets a new entry. `file` need not exist. Throws configuration for a kernel that no entry can name, and
// for unsupported YAML.
std::string with_clauses(std::string const &file, std::vector<Lacking> const &lacking);

} // namespace symreal::tool
