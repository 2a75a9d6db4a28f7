// Identifiers for the variables of a generated function.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>
#include <vector>

namespace symreal {

// Source names of values, with a number from the second use of a name on; t and a number for a value without a name.
// Distinct from each other and from the other names of the generated functions. Takes 8 bytes a variable.
class VariableNames {
public:
  VariableNames(Emission const &emission, FunctionBody const &body);

  void append_to(std::string &text, std::size_t variable) const;
  std::string operator()(std::size_t variable) const;

private:
  struct Entry {
    NameId name;
    std::uint32_t number;
  };
  void append_name(std::string &text, std::size_t variable) const;

  NameRules const *rules_;
  std::string (*written_)(std::string const &);
  std::vector<std::string> bases_; // per name of the graph
  std::vector<Entry> entries_;     // per variable; empty if no variable has a name
};

} // namespace symreal
