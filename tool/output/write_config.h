// Puts what the pragmas of kernels lack into the project's configuration.
#pragma once

#include "program/record/record.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::tool {

struct Lacking {
  rewrite::Kernel kernel;
  std::map<std::string, std::string> clauses; // by clause: "name, name"
};

// The text of the configuration with these clauses in the entries of their kernels; comments stay. An entry is made for
// a function whose pragma stands in a source. `file` need not exist. Throws configuration for a kernel that no entry
// can name, and for a form of YAML that is not understood.
std::string with_clauses(std::string const &file, std::vector<Lacking> const &lacking);

} // namespace symreal::tool
